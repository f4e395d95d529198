//! A load program followed from event to event and the same program followed in steps reach the same states, leg by leg or at once.

use std::mem::discriminant;

use grasp_lcp::Error;
use grasp_lcp::load_path::{Beyond, PathEnd};
use grasp_lcp::planar::{Contact, Equilibrium, Grasp, Leg, Wrench};
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// Allowed error of the steps.
const ERROR: f64 = 1e-7;

/// A pad of uneven springs on an uneven floor, pressed by its weight.
fn pad(numbers: &mut Random) -> Result<Grasp, Error> {
    let spring = |i: u8| {
        let k = 100.0 * (1.0 + 0.4 * numbers.signed());
        Contact::new([0.2 * f64::from(i) - 0.9, 0.0], [0.1 * numbers.signed(), 1.0])
            .series_stiffness(k, 0.8 * k)
            .friction(0.4 + 0.2 * numbers.signed())
    };
    Grasp::new((0..10).map(spring).collect::<Vec<_>>())
}

fn pulled(shear: f64, tilt: f64) -> Wrench {
    Wrench::new([shear, -10.0], tilt)
}

/// The pad is dragged and tilted three times and released, then dragged beyond the limit of friction.
fn program(numbers: &mut Random) -> Vec<Leg> {
    let mut legs: Vec<_> =
        (0..3).map(|_| Leg::load_to(pulled(3.0 * numbers.signed(), numbers.signed()))).collect();
    legs.extend([Leg::load_to(pulled(0.0, 0.0)), Leg::load_by(Wrench::force([8.0, 0.0]))]);
    legs
}

/// Relative difference of two equilibria, in forces and in motions.
fn apart(a: &Equilibrium, b: &Equilibrium) -> f64 {
    let largest = a.contacts.iter().map(|contact| contact.force.norm()).fold(0.0, f64::max);
    let pairs = a.contacts.iter().zip(&b.contacts);
    let forces = pairs.map(|(a, b)| (a.force - b.force).norm()).fold(0.0, f64::max) / largest;
    let [a, b] = [a, b].map(|state| state.twist.to_vector());
    forces.max((a - b).norm() / a.norm().max(b.norm()))
}

#[test]
fn they_stand_at_the_same_place() -> Result<(), Error> {
    let mut numbers = seeded(7);
    let (mut stepwise, mut lost, mut limits) = (0.0_f64, 0, 0);
    for _ in 0..samples(20) {
        let (pad, legs) = (pad(&mut numbers)?, program(&mut numbers));
        let start = pulled(0.0, 0.0);
        let mut path = pad.follow(start, &[])?;
        let mut steps = pad.follow_in_steps(start, &[], ERROR)?;
        let at_start = path.state().expect("rests");
        assert_eq!((path.place(), steps.place()), ((0, 0.0), (0, 0.0)));
        for state in [steps.state(), path.state_at(0, 0.0)] {
            assert!(apart(&at_start, &state.expect("rests")) < 1e-13);
        }
        let mut snaps = false;
        for (number, leg) in legs.iter().enumerate() {
            let leg = std::slice::from_ref(leg);
            path.continue_with(leg)?;
            steps.continue_with(leg)?;
            assert!(path.end().is_none() && steps.end().is_none());
            let events = path.run();
            steps.by_ref().for_each(drop);
            assert_eq!(path.place().0, number);
            snaps |= events.iter().any(|event| event.jump.as_ref().is_some_and(|jump| jump.snaps));
            if snaps {
                // The path in steps ends where the path from event to event snaps over.
                assert!(steps.place() <= path.place() && matches!(steps.end(), Some(PathEnd::Lost(_))));
                break;
            }
            let state = path.state().expect("on the way");
            // If the path ends at a limit load, it ends between two steps, whose states are not compared.
            let whole = number + 1 < legs.len();
            stepwise =
                stepwise.max(if whole { apart(&state, &steps.state().expect("on the way")) } else { 0.0 });
            let ((leg, fraction), (_, exact)) = (steps.place(), path.place());
            let near = leg == number && (fraction - exact).abs() < 1e-8;
            assert!(near, "{:?} {:?}", path.end(), steps.end());
            let forces = [path.forces(), steps.forces()];
            assert!(forces.iter().all(|forces| forces.len() == pad.len()));
        }
        if snaps {
            continue;
        }
        let ends = [path.end(), steps.end()].map(|end| end.map(discriminant));
        assert!(ends[0] == ends[1], "{:?} {:?}", path.end(), steps.end());
        lost += usize::from(matches!(path.end(), Some(PathEnd::Lost(_))));
        // Both paths give the same kind of end. A motion proves the limit load; without this proof, and with too many contact states to enumerate, a
        // path ends where no rates exist.
        let beyond = [path.beyond(), steps.beyond()];
        let kinds = beyond.each_ref().map(|beyond| beyond.as_ref().map(discriminant));
        assert!(kinds[0] == kinds[1], "{beyond:?}");
        assert!(matches!(beyond[0], Some(Beyond::LimitLoad | Beyond::Ends { .. })), "{beyond:?}");
        limits += usize::from(matches!(beyond[0], Some(Beyond::LimitLoad)));

        // All legs followed in one call end at the same state.
        let mut at_once = pad.follow_in_steps(start, &legs, ERROR)?;
        at_once.by_ref().for_each(drop);
        assert_eq!(at_once.forces(), steps.forces());
    }
    println!("{lost} lost, {limits} proved limits; {stepwise:.1e} apart in steps");
    assert_met(&[(limits, 1)]);
    assert!(lost >= samples(12) && stepwise < ERROR, "{stepwise:e}");
    Ok(())
}
