//! On every leg of every load path the energies balance: work of load and fingers = stored + dissipated. Work and heat are integrated here from
//! sampled states of random paths in the plane and in space.

use proptest::prelude::*;
use support::programs::Scene;
use support::programs::draw::{over, planar_scenes, spatial_scenes, turning};
use support::programs::tally::Tally;
use support::samples::assert_met;

/// Checks the balance of work, stored energy and heat, integrated by trapezoids between the ends of straight pieces, where this is exact. Compares
/// the sums with the energies that the path reports for each leg.
fn energy_balances<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    tally: &mut Tally,
) -> Result<(), TestCaseError> {
    let grasp = scene.grasp();
    let asked = grasp.with(&support::programs::polygon());
    let mut path = asked.follow(scene.start(), &scene.legs()).unwrap();
    let events = path.run();
    tally.count(&events, &path);
    let (last_leg, last) = path.place();
    for leg in 0..=last_leg {
        let there = |fraction: f64| path.state_at(leg, fraction).map(|state| (fraction, state));
        let mut states: Vec<_> = there(0.0).into_iter().collect();
        for event in events.iter().filter(|event| event.leg == leg) {
            // Where the object jumps at a constant load, both the state before and the state after the jump count.
            states.push((event.fraction, event.state.clone()));
            states.extend(event.jump.iter().map(|jump| (event.fraction, jump.state.clone())));
        }
        let end = if leg < last_leg { 1.0 } else { last };
        if states.last().is_some_and(|(fraction, _)| *fraction < end) {
            states.extend(there(end));
        }
        let (mut load_work, mut finger_work, mut heat, mut turnover) = (0.0, 0.0, 0.0, 0.0);
        for pair in states.windows(2) {
            let ((f, a), (g, b)) = (&pair[0], &pair[1]);
            let vector = nalgebra::DVector::from_column_slice;
            let mean = (vector(a.load.components()) + vector(b.load.components())) * 0.5;
            let work = mean.dot(&(vector(b.twist.components()) - vector(a.twist.components())));
            let (from, to) = (scene.at(leg, *f).1, scene.at(leg, *g).1);
            load_work += work;
            turnover += work.abs();
            for (i, (x, y)) in a.contacts.iter().zip(&b.contacts).enumerate() {
                let force = (x.force + y.force) * 0.5;
                let (pushed, lost) = (force.dot(&(to[i] - from[i])), force.dot(&(y.slip - x.slip)));
                finger_work += pushed;
                heat += lost;
                turnover += pushed.abs() + lost.abs();
            }
        }
        let (Some(first), Some(end)) = (states.first(), states.last()) else { continue };
        let told = path.energies()[leg];
        prop_assert!(told.residual().abs() <= 1e-12, "leg {leg}: {told:?}");
        prop_assert!(told.dissipated >= -1e-12 * turnover, "leg {leg}: {told:?}");
        // If the object snaps over, dampers of an unknown history take part of the work, so that this leg is not compared.
        if events.iter().any(|event| event.leg == leg && event.jump.as_ref().is_some_and(|jump| jump.snaps)) {
            continue;
        }
        let stored = end.1.stored_energy - first.1.stored_energy;
        turnover += end.1.stored_energy + first.1.stored_energy;
        let excess = load_work + finger_work - stored - heat;
        prop_assert!(excess.abs() <= 1e-12 * turnover, "{leg} {excess:e} {turnover}");
        let pairs = [
            (told.load_work, load_work),
            (told.finger_work, finger_work),
            (told.stored, stored),
            (told.dissipated, heat),
        ];
        for (told, here) in pairs {
            prop_assert!((told - here).abs() <= 1e-11 * turnover, "{leg} {told} {here}");
        }
        tally.checked += usize::from(heat > 1e-6 * turnover);
    }
    Ok(())
}

/// Checks that the energies reported for each leg balance and the heat is not negative. If the load turns, the library integrates heat and work
/// independently.
fn closes<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    tally: &mut Tally,
) -> Result<(), TestCaseError> {
    let grasp = scene.grasp();
    let asked = grasp.with(&support::programs::polygon());
    let mut path = asked.follow(scene.start(), &scene.legs()).unwrap();
    let events = path.run();
    tally.count(&events, &path);
    for energy in path.energies() {
        prop_assert!(energy.residual().abs() <= 1e-12, "{energy:?}");
        prop_assert!(energy.dissipated >= -1e-12 * energy.turnover, "{energy:?}");
        tally.checked += usize::from(energy.dissipated > 1e-6 * energy.turnover);
    }
    Ok(())
}

#[test]
fn planar_energies_balance() {
    let t = over(333, &planar_scenes(), |scene, tally| energy_balances(&scene, tally));
    println!("{t:?}");
    assert_met(&[(t.checked, 166), (t.opens, 50), (t.closes, 25)]);
}

#[test]
fn spatial_energies_balance() {
    let t = over(67, &spatial_scenes(), |scene, tally| energy_balances(&scene, tally));
    println!("{t:?}");
    assert_met(&[(t.checked, 16), (t.turns, 8)]);
}

#[test]
fn energies_balance_while_the_load_turns() {
    let t = over(167, &turning(planar_scenes(), 16.0), |scene, tally| closes(&scene, tally));
    println!("{t:?}");
    assert_met(&[(t.checked, 66), (t.opens, 16)]);
    let t = over(33, &turning(spatial_scenes(), 16.0), |scene, tally| closes(&scene, tally));
    println!("{t:?}");
    assert_met(&[(t.checked, 10)]);
}
