//! An equilibrium does not depend on the order of the contacts, on coordinates or units, or on changes that have no effect on forces.
//!
//! If the equilibrium is unique, or everything sticks (this equilibrium is returned first), the grasp in another frame has the same forces and
//! displacements. If a contact is split into two of half the stiffness, each carries half the force. More friction at a sticking contact, or a
//! contact far out of reach, changes nothing. Each scene is compared with its own image, so no expected numbers are needed.

use std::cell::Cell;
use std::f64::consts::TAU;

use grasp_lcp::equilibrium::{ContactAnswer, ContactState, Equilibrium, FoundBy, Outcome};
use grasp_lcp::{PolygonCone, PolygonFit, Settings};
use nalgebra::SVector;
use proptest::prelude::*;
use support::random::{self, Spread, for_all, scene};
use support::samples::samples;
use support::scene::{Datum, Scene};
use support::transform::Transform;

/// Largest difference of forces and displacements, relative to the largest one.
const AGREEMENT: f64 = 1e-9;
/// Scenes are left out if their answer changes by more than `CHANGE` when their data change by `JITTER`, because rounding
/// would be visible.
const JITTER: f64 = 1e-12;
const CHANGE: f64 = 1e-8;

/// Cones with three facets in space have few enough states to enumerate. The round cone has its own test file.
fn settings() -> Settings {
    Settings::default()
        .on_the_polygon()
        .with_cone(PolygonCone::new(3, PolygonFit::Inscribed).expect("a polygon"))
}

/// Forces, and displacements of the body, at each contact along the coordinate axes.
type Picture<const C: usize> = Vec<(SVector<f64, C>, SVector<f64, C>)>;

fn picture<const C: usize>(e: &Equilibrium<C>) -> Picture<C> {
    e.contacts.iter().map(|c| (c.force_world, c.body_core)).collect()
}

/// Largest difference of forces and displacements, relative to the largest force and displacement of `e`. Displacements are compared only if no free
/// motion exists.
fn distance<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    e: &Equilibrium<C>,
    other: &Picture<C>,
) -> f64 {
    let sizes = scene.sizes(e);
    let mut worst = 0.0_f64;
    for ((f, u), (g, v)) in picture(e).iter().zip(other) {
        worst = worst.max((f - g).norm() / sizes.force);
        if e.free_motions.is_empty() {
            worst = worst.max((u - v).norm() / sizes.motion);
        }
    }
    worst
}

/// The equilibrium of a scene if it is the only possible answer and well-conditioned.
fn only<const D: usize, const C: usize>(scene: &Scene<D, C>) -> Option<Equilibrium<C>> {
    let grasp = scene.grasp();
    let outcome = grasp.with(&settings()).solve(scene.wrench()).expect("a finite load");
    let e = outcome.equilibrium()?;
    if e.rule != FoundBy::EverythingSticks {
        let all = grasp.with(&settings()).equilibria(scene.wrench()).ok()?;
        if all.len() != 1 || !all[0].neutral_motions.is_empty() || all[0].free_motions != e.free_motions {
            return None;
        }
    }
    // A contact without force may equally be reported as open or sliding, and a sticking contact on the edge of its cone as sliding. With such a
    // contact the displacements are not unique.
    let least = 1e-9 * scene.sizes(e).force;
    let tied = |c: &ContactAnswer<C>| match c.state {
        ContactState::Separated => false,
        ContactState::Sticking => c.normal_force() <= least || c.margin <= least,
        _ => c.normal_force() <= least,
    };
    if e.contacts.iter().any(tied) {
        return None;
    }
    // The image of a scene has rounded data. This must not change the answer by 1e-9.
    let near = |phase| {
        solve(&jittered(scene, phase)).is_ok_and(|near| distance(scene, e, &picture(&near)) <= CHANGE)
    };
    [0.0, 1.0, 2.0].into_iter().all(near).then(|| e.clone())
}

/// The scene with each of its numbers changed by up to [`JITTER`] of itself; `phase` chooses the changes.
fn jittered<const D: usize, const C: usize>(scene: &Scene<D, C>, phase: f64) -> Scene<D, C> {
    let mut seed = phase;
    let mut jitter = |x: f64| {
        seed += 1.0;
        x * (1.0 + JITTER * (7.0 * seed).cos())
    };
    let mut near = scene.clone();
    for datum in &mut near.contacts {
        datum.point = datum.point.map(&mut jitter);
        datum.normal = datum.normal.map(&mut jitter);
        datum.command = datum.command.map(&mut jitter);
        datum.stiffness = datum.stiffness.map(&mut jitter);
    }
    near.load = near.load.map(&mut jitter);
    near
}

fn solve<const D: usize, const C: usize>(scene: &Scene<D, C>) -> Result<Equilibrium<C>, TestCaseError> {
    match scene.grasp().with(&settings()).solve(scene.wrench()).expect("a finite load") {
        Outcome::Equilibrium(e) => Ok(*e),
        other => Err(TestCaseError::fail(format!("{other:?}"))),
    }
}

/// Numbers of compared scenes, by the states of their contacts.
#[derive(Debug, Default)]
struct Tally {
    compared: Cell<usize>,
    sliding: Cell<usize>,
    separated: Cell<usize>,
}

impl Tally {
    fn count<const C: usize>(&self, e: &Equilibrium<C>) {
        let add = |cell: &Cell<usize>, yes: bool| cell.set(cell.get() + usize::from(yes));
        add(&self.compared, true);
        add(&self.sliding, e.contacts.iter().any(|c| matches!(c.state, ContactState::Sliding { .. })));
        add(&self.separated, e.contacts.iter().any(|c| c.state == ContactState::Separated));
    }

    fn assert_at_least(&self, compared: usize, sliding: usize, separated: usize) {
        println!("{self:?}");
        let enough = self.compared.get() >= samples(compared)
            && self.sliding.get() >= samples(sliding)
            && self.separated.get() >= samples(separated);
        assert!(enough, "{self:?}");
    }
}

/// Checks that the image of a scene has the image of its equilibrium.
fn carried_along<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    transform: &Transform<C>,
    tally: &Tally,
) -> Result<(), TestCaseError> {
    let Some(e) = only(scene) else { return Ok(()) };
    let image = solve(&transform.scene(scene))?;
    let back: Picture<C> = picture(&image)
        .iter()
        .map(|(f, u)| (transform.force_back(f), transform.displacement_back(u)))
        .collect();
    let off = distance(scene, &e, &back);
    prop_assert!(off <= AGREEMENT, "{off:e} {e:?} {image:?}");
    tally.count(&e);
    Ok(())
}

fn check_order<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    turn: usize,
    swap: bool,
    tally: &Tally,
) -> Result<(), TestCaseError> {
    let Some(e) = only(scene) else { return Ok(()) };
    let count = scene.contacts.len();
    let at = |i: usize| if swap { count - 1 - (i + turn) % count } else { (i + turn) % count };
    let mut image = scene.clone();
    (0..count).for_each(|i| image.contacts[at(i)] = scene.contacts[i]);
    let solved = picture(&solve(&image)?);
    let back: Picture<C> = (0..count).map(|i| solved[at(i)]).collect();
    let off = distance(scene, &e, &back);
    prop_assert!(off <= AGREEMENT, "off by {off:e}\n{e:?}");
    tally.count(&e);
    Ok(())
}

/// Checks the scene with contact 0 split into two of half the stiffness at the same place.
fn check_split<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    tally: &Tally,
) -> Result<(), TestCaseError> {
    let Some(e) = only(scene) else { return Ok(()) };
    let mut split = scene.clone();
    split.contacts[0].stiffness *= 0.5;
    split.contacts.push(split.contacts[0]);
    let halves = picture(&solve(&split)?);
    let last = halves[scene.contacts.len()];
    let mut joined: Picture<C> = halves[..scene.contacts.len()].to_vec();
    joined[0].0 += last.0;
    let off = distance(scene, &e, &joined);
    prop_assert!(off <= AGREEMENT, "{off:e} {e:?} {halves:?}");
    tally.count(&e);
    Ok(())
}

/// Checks a change of the grasp that does not affect this equilibrium. It must remain among all equilibria, although the
/// change may add others. It must be returned if it is the only one, or if everything in contact sticks.
fn not_felt<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    e: &Equilibrium<C>,
    changed: &Scene<D, C>,
    tally: &Tally,
) -> Result<(), TestCaseError> {
    let off = |other: &Equilibrium<C>| distance(scene, e, &picture(other));
    let mut alone = false;
    if let Ok(all) = changed.grasp().with(&settings()).equilibria(changed.wrench()) {
        prop_assert!(all.iter().any(|other| off(other) <= AGREEMENT), "lost\n{e:?}\n{all:?}");
        alone = all.len() == 1;
    }
    if alone || e.rule == FoundBy::EverythingSticks {
        let returned = solve(changed)?;
        prop_assert!(off(&returned) <= AGREEMENT, "off by {:e}\n{e:?}\n{returned:?}", off(&returned));
        tally.count(e);
    }
    Ok(())
}

fn check_friction<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    more: f64,
    tally: &Tally,
) -> Result<(), TestCaseError> {
    let Some(e) = only(scene) else { return Ok(()) };
    let mut rougher = scene.clone();
    for (datum, c) in rougher.contacts.iter_mut().zip(&e.contacts) {
        if c.state == ContactState::Sticking {
            datum.friction *= more;
        }
    }
    not_felt(scene, &e, &rougher, tally)
}

fn check_out_of_reach<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    another: Datum<C>,
    tally: &Tally,
) -> Result<(), TestCaseError> {
    let Some(e) = only(scene) else { return Ok(()) };
    let mut changed = scene.clone();
    let away = 1e4 * scene.sizes(&e).motion;
    changed.contacts.push(Datum { clearance: away, ..another });
    not_felt(scene, &e, &changed, tally)
}

fn planar() -> impl Strategy<Value = Scene<3, 2>> {
    scene::<3, 2>(2..5, Spread::Wide, 0.2)
}

fn spatial() -> impl Strategy<Value = Scene<6, 3>> {
    scene::<6, 3>(3..5, Spread::Wide, 0.3)
}

fn angles() -> impl Strategy<Value = [f64; 3]> {
    [0.0..TAU, 0.0..TAU, 0.0..TAU]
}

fn shift<const C: usize>() -> impl Strategy<Value = SVector<f64, C>> {
    prop::collection::vec(-20.0..20.0_f64, C).prop_map(SVector::from_vec)
}

fn power_of_ten() -> impl Strategy<Value = f64> {
    (-6..7_i32).prop_map(|e| 10_f64.powi(e))
}

const PLANAR: usize = 300;
const SPATIAL: usize = 60;

macro_rules! in_plane_and_space {
    ($($name:ident($scene:ident, $tally:ident, $other:ident in $strategy:expr) $body:block)*) => { $(
        mod $name {
            use super::*;

            #[test]
            fn in_the_plane() {
                let $tally = Tally::default();
                for_all(file!(), PLANAR, &(planar(), $strategy), |($scene, $other)| $body);
                $tally.assert_at_least(PLANAR / 3, PLANAR / 10, PLANAR / 10);
            }

            #[test]
            fn in_space() {
                let $tally = Tally::default();
                for_all(file!(), SPATIAL, &(spatial(), $strategy), |($scene, $other)| $body);
                $tally.assert_at_least(SPATIAL / 6, SPATIAL / 20, SPATIAL / 50);
            }
        }
    )* };
}

in_plane_and_space! {
    turning(scene, tally, angles in angles()) {
        carried_along(&scene, &Transform::turned(angles), &tally)
    }
    mirroring(scene, tally, _nothing in Just(())) {
        carried_along(&scene, &Transform::mirrored(), &tally)
    }
    moving_the_reference_point(scene, tally, shift in shift()) {
        carried_along(&scene, &Transform::moved(shift), &tally)
    }
    other_units(scene, tally, units in (power_of_ten(), power_of_ten())) {
        carried_along(&scene, &Transform::in_units(units.0, units.1), &tally)
    }
    another_order(scene, tally, order in (0..4_usize, any::<bool>())) {
        check_order(&scene, order.0, order.1, &tally)
    }
    splitting_a_contact(scene, tally, _nothing in Just(())) {
        check_split(&scene, &tally)
    }
    more_friction_where_it_sticks(scene, tally, more in 1.0..100.0_f64) {
        check_friction(&scene, more, &tally)
    }
}

#[test]
fn a_finger_out_of_reach_is_not_felt_in_the_plane() {
    let tally = Tally::default();
    let another = random::datum::<2>(Spread::Wide);
    for_all(file!(), PLANAR, &(planar(), another), |(scene, another)| {
        check_out_of_reach(&scene, another, &tally)
    });
    tally.assert_at_least(PLANAR / 3, PLANAR / 10, PLANAR / 10);
}

#[test]
fn a_finger_out_of_reach_is_not_felt_in_space() {
    let tally = Tally::default();
    let another = random::datum::<3>(Spread::Wide);
    for_all(file!(), SPATIAL, &(spatial(), another), |(scene, another)| {
        check_out_of_reach(&scene, another, &tally)
    });
    tally.assert_at_least(SPATIAL / 6, SPATIAL / 20, SPATIAL / 50);
}
