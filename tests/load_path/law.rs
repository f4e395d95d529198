//! On every load path the contact law holds at every sampled fraction, and slip dissipates energy. Random grasps and programs in the plane and in
//! space are checked; [`common_path`] writes the law out from points, normals and springs. All kinds of events must occur often, and no path may end
//! undecided.

use grasp_lcp::equilibrium::{ContactState, Equilibrium};
use grasp_lcp::load_path::{Event, LoadPath};
use proptest::prelude::*;
use support::programs::draw::{over, planar_scenes, spatial_scenes, turning};
use support::programs::tally::Tally;
use support::programs::{Scene, brief, corners, sizes, tangential};
use support::samples::assert_met;

/// States along a path, for each straight piece between two events: its first and last state, which are continuous from one piece to the next, and
/// states inside.
fn sampled<const C: usize>(
    path: &LoadPath<'_, C>,
    events: &[Event<C>],
) -> Vec<Vec<(usize, f64, Equilibrium<C>)>> {
    let (last_leg, last) = path.place();
    let mut pieces = Vec::new();
    for leg in 0..=last_leg {
        let end = if leg < last_leg { 1.0 } else { last };
        let mut marks = vec![0.0];
        marks.extend(events.iter().filter(|e| e.leg == leg).map(|e| e.fraction));
        marks.push(end);
        for ends in marks.windows(2) {
            // On shorter pieces slips are smaller than rounding.
            if ends[1] - ends[0] > 1e-6 {
                let at = |x: f64| ends[0] + (ends[1] - ends[0]) * x;
                let here = |f: f64| path.state_at(leg, f).map(|state| (leg, f, state));
                pieces.push([0.001, 0.3, 0.7, 0.999].into_iter().filter_map(|x| here(at(x))).collect());
            }
        }
    }
    pieces
}

/// Checks the contact law at every sampled state. Between two states of a piece a sticking contact keeps its slip. The slip Δs of a sliding contact
/// dissipates as much as possible: (F_t - p)·Δs >= 0 for every corner p of the cone, so that F_t·Δs >= 0.
fn law_holds<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    tally: &mut Tally,
) -> Result<(), TestCaseError> {
    let grasp = scene.grasp();
    let asked = grasp.with(&support::programs::polygon());
    let mut path = asked.follow(scene.start(), &scene.legs()).unwrap();
    let events = path.run();
    tally.count(&events, &path);
    for event in &events {
        let breach = scene.breach(event.leg, event.fraction, &event.state);
        prop_assert!(breach <= 1e-12, "{breach:e} {} {}", event.leg, event.fraction);
    }
    for piece in sampled(&path, &events) {
        for (leg, fraction, state) in &piece {
            let breach = scene.breach(*leg, *fraction, state);
            prop_assert!(breach <= 1e-12, "{breach:e} {leg} {fraction} {}", brief(state));
        }
        for pair in piece.windows(2) {
            let ((leg, fraction, a), (_, _, b)) = (&pair[0], &pair[1]);
            let (force, motion) = sizes(a);
            for (i, (x, y)) in a.contacts.iter().zip(&b.contacts).enumerate() {
                let slip = y.slip - x.slip;
                let same = std::mem::discriminant(&x.state) == std::mem::discriminant(&y.state);
                prop_assert!(same, "{i} {leg} {fraction}");
                match x.state {
                    ContactState::Sticking => {
                        prop_assert!(slip.norm() <= 1e-12 * motion, "contact {i} slips: {slip}");
                    }
                    ContactState::Sliding { .. } => {
                        for (f, p) in
                            [x, y].iter().flat_map(|c| corners::<C>().into_iter().map(|p| (c.force, p)))
                        {
                            let lost = (tangential(&f) - p * (scene.spots[i].mu * f[0])).dot(&slip);
                            let size = (1.0 + scene.spots[i].mu) * force * motion;
                            prop_assert!(lost >= -1e-12 * size, "{i} {lost:e} {leg} {fraction}");
                        }
                        tally.checked += 1;
                    }
                    _ => {}
                }
            }
        }
    }
    Ok(())
}

#[test]
fn planar_states_satisfy_the_law_and_slip_dissipates() {
    let t = over(375, &planar_scenes(), |scene, tally| law_holds(&scene, tally));
    println!("{t:?}");
    assert_met(&[(t.slides, 187), (t.sticks, 100), (t.opens, 50), (t.closes, 25), (t.checked, 1000)]);
    assert_met(&[(t.completed, 125), (t.limits, 25), (t.snaps, 12)]);
    assert_eq!(t.undecided, 0, "{t:?}");
}

#[test]
fn spatial_states_satisfy_the_law_and_slip_dissipates() {
    let t = over(75, &spatial_scenes(), |scene, tally| law_holds(&scene, tally));
    println!("{t:?}");
    assert_met(&[(t.slides, 12), (t.sticks, 6), (t.turns, 12), (t.opens, 2), (t.checked, 187)]);
    assert_eq!(t.undecided, 0, "{t:?}");
}

#[test]
fn planar_states_under_loads_that_turn_do() {
    let t = over(250, &turning(planar_scenes(), 16.0), |scene, tally| law_holds(&scene, tally));
    println!("{t:?}");
    assert_met(&[(t.slides, 250), (t.sticks, 250), (t.opens, 50), (t.closes, 25), (t.checked, 1000)]);
    assert_eq!(t.undecided, 0, "{t:?}");
}

#[test]
fn spatial_states_under_loads_that_turn_do() {
    let t = over(50, &turning(spatial_scenes(), 16.0), |scene, tally| law_holds(&scene, tally));
    println!("{t:?}");
    assert_met(&[(t.slides, 12), (t.sticks, 6), (t.turns, 12), (t.opens, 2), (t.checked, 187)]);
    assert_eq!(t.undecided, 0, "{t:?}");
}
