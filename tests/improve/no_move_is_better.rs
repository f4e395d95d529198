//! If an answer is proved to be a local optimum to first order, no small change improves the goal to first order: neither moves of contacts along
//! their surfaces, nor changes of squeezes. Gains are differences of goals of whole grasps, on curved surfaces, for both goals.

use std::f64::consts::TAU;

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::{ContactAnswer, ContactState};
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::improve::{Improve, ImproveGoal, Placed, Surface};
use grasp_lcp::load_path::Ramp;
use grasp_lcp::nalgebra::SVector;
use grasp_lcp::squeeze::{Loads, WeakestDirection};
use grasp_lcp::{planar, spatial};
use support::samples::{assert_met, samples, seeded};

/// Size of moves of contacts, relative to the size of the object. Changes of squeezes have this size relative to the largest squeeze.
const STEP: f64 = 4e-4;
const SIZE: f64 = 0.05;
const MOST: f64 = 12.0;
/// Accepted gain to first order, for a move by the size of the object, relative to the goal. Optima are reported to a millionth.
const NOTHING: f64 = 1e-6;
const ROUNDING: f64 = 1e-9;

const NORMAL: f64 = 1e3;
const TANGENTIAL: f64 = 8e2;

fn contact<const C: usize>(point: [f64; C], normal: [f64; C], press: f64) -> Contact<C> {
    let command = std::array::from_fn(|k| [press / NORMAL, 5e-4, 0.0][k]);
    Contact::new(point, normal).series_stiffness(NORMAL, TANGENTIAL).friction(0.8).command(command)
}

/// The contacts after a move of each contact point along its surface and a change of each squeeze. Tangents turn with the normal and do not twist
/// about it. `None` if a squeeze exceeds its largest value.
fn moved<const C: usize>(
    at: &[Placed<C>],
    surfaces: &[Surface<C>],
    moves: &[f64],
    step: f64,
) -> Option<Grasp<C>> {
    let mut is_allowed = true;
    let mut moves = moves.iter().map(|part| part * step);
    let mut next = || moves.next().expect("a number for each");
    let contacts = at.iter().zip(surfaces).map(|(at, surface)| {
        let there = at.point + SVector::<f64, C>::from_fn(|_, _| next() * SIZE);
        let (point, normal) = surface.nearest(there, at.normal).expect("a surface");
        let across = at.tangent - SVector::from(normal) * at.tangent.dot(&normal.into());
        let press = at.command[0] * NORMAL + next() * MOST;
        is_allowed &= press <= MOST * (1.0 + ROUNDING);
        contact(point, normal, press).tangent(across.normalize())
    });
    let contacts: Vec<_> = contacts.collect();
    is_allowed.then(|| Grasp::new(contacts).expect("a grasp"))
}

fn goal<const C: usize>(
    grasp: &Grasp<C>,
    base: &Wrench<C>,
    loads: &Loads<C>,
    goal: ImproveGoal,
) -> Option<f64> {
    let rest = grasp.solve(base).expect("a load");
    let is_allowed = |contact: &ContactAnswer<C>| {
        contact.force[0] <= MOST * (1.0 + ROUNDING) && contact.state == ContactState::Sticking
    };
    if !rest.equilibrium()?.contacts.iter().all(is_allowed) {
        return None;
    }
    let margin = |load: Wrench<C>| {
        let outcome = grasp.solve(*base + load).expect("a load");
        let margins = outcome.equilibrium()?.contacts.iter().map(|contact| contact.margin);
        Some(margins.fold(f64::INFINITY, f64::min))
    };
    let least = |values: Vec<f64>| values.into_iter().fold(f64::INFINITY, f64::min);
    match (loads, goal) {
        (Loads::Each(all), ImproveGoal::FirstSlip) => {
            let first = |load: &Wrench<C>| grasp.onset(Ramp::load(*base, *load)).expect("a load").factor();
            Some(least(all.iter().map(first).collect::<Option<_>>()?))
        }
        (Loads::Each(all), _) => Some(least(all.iter().map(|load| margin(*load)).collect::<Option<_>>()?)),
        (Loads::AnyForce { size, point, .. }, _) => {
            let WeakestDirection::Force { size: weakest, .. } =
                grasp.weakest_direction(base, *point).expect("a load")
            else {
                return None;
            };
            Some(weakest / size)
        }
        _ => None,
    }
}

fn no_move_gains<const C: usize>(
    places: [([f64; C], Surface<C>); 3],
    base: Wrench<C>,
    loads: &Loads<C>,
    to: ImproveGoal,
) {
    let surfaces = places.each_ref().map(|(_, surface)| surface.clone());
    let given = places.map(|(toward, surface)| {
        let (point, normal) = surface.nearest(toward, toward.map(|x| -x)).expect("a surface");
        contact(point, normal, 9.0)
    });
    let grasp = Grasp::new(given).expect("three fingers");
    let question = Improve::new(loads.clone()).on_top_of(base).pressing_at_most(MOST).with_goal(to);
    let question = surfaces
        .iter()
        .enumerate()
        .fold(question, |question, (k, surface)| question.along(k, surface.clone()));
    let improved = grasp.improve(&question).expect("asked well");
    assert!(improved.is_locally_best(), "{improved}");
    let best = improved.after.expect("sticks");
    let value =
        |moves: &[f64], step| goal(&moved(&improved.contacts, &surfaces, moves, step)?, &base, loads, to);
    let told = value(&[0.0; 12], 0.0).expect("sticks");
    assert!((told / best - 1.0).abs() < 1e-9, "{told} {best}: {improved}");

    let (mut random, mut most, mut asked, mut lose) = (seeded(48), f64::NEG_INFINITY, 0, 0);
    for _ in 0..samples(300) {
        // Each random direction changes only some of the coordinates and squeezes. The others stay as they are.
        let mut part = || if random.index(0, 3) > 0 { 0.0 } else { random.signed() };
        let moves: [f64; 12] = std::array::from_fn(|_| part());
        let gain = |step: f64| Some(value(&moves, step)? / best - 1.0);
        let (Some(whole), Some(half)) = (gain(STEP), gain(STEP / 2.0)) else { continue };
        // The slope at zero of the parabola through zero and both gains. So the curvature of surfaces does not count.
        let first = (4.0 * half - whole) / STEP;
        (most, asked, lose) = (most.max(first), asked + 1, lose + usize::from(first < -0.01));
    }
    println!("{asked} moves, {lose} lose, at most {most:e}: {improved}");
    assert_met(&[(asked, 30), (lose, 20)]);
    assert!(most < NOTHING, "{asked} {lose} {most:e}");
}

#[test]
fn in_the_plane() {
    use planar::Wrench;
    let blob = [[0.05, 0.0], [0.02, 0.04], [-0.04, 0.03], [-0.05, -0.02], [0.01, -0.04]];
    let places = || [0, 2, 4].map(|k| (blob[k], Surface::spline(blob, true)));
    let base = Wrench::force([0.1, 0.2]);
    let each = Loads::Each(vec![Wrench::force([0.3, -1.0]), Wrench::new([0.5, 0.0], 0.01)]);
    let any = Loads::AnyForce { base: Wrench::ZERO, size: 2.0, point: [0.01, 0.0] };
    no_move_gains(places(), base, &each, ImproveGoal::FirstSlip);
    no_move_gains(places(), base, &each, ImproveGoal::Reserve);
    no_move_gains(places(), base, &any, ImproveGoal::FirstSlip);
}

#[test]
fn in_space() {
    use spatial::Wrench;
    let toward = |angle: f64| [0.05 * angle.cos(), 0.05 * angle.sin(), 0.01];
    let can = || Surface::cylinder([0.0, 0.0, -0.03], [0.0, 0.0, 0.03], 0.05);
    let places = || {
        [(toward(0.2), can()), (toward(2.0), Surface::sphere([0.0; 3], 0.06)), (toward(TAU * 0.72), can())]
    };
    let base = Wrench::force([0.1, 0.2, 0.0]);
    let each =
        Loads::Each(vec![Wrench::force([0.1, 0.2, -1.0]), Wrench::new([0.5, 0.0, 0.3], [0.0, 0.0, 0.01])]);
    let any = Loads::AnyForce { base: Wrench::ZERO, size: 2.0, point: [0.01, 0.0, 0.0] };
    no_move_gains(places(), base, &each, ImproveGoal::FirstSlip);
    no_move_gains(places(), base, &each, ImproveGoal::Reserve);
    no_move_gains(places(), base, &any, ImproveGoal::FirstSlip);
}
