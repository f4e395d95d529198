//! A path takes no more steps than the caller allows, and reports the state reached.

use std::f64::consts::TAU;

use grasp_lcp::Settings;
use grasp_lcp::equilibrium::Doubt;
use grasp_lcp::load_path::PathEnd;
use grasp_lcp::spatial::{Contact, Grasp, Leg, Ramp, Wrench};

/// Four different fingers around a glass.
fn glass() -> Grasp {
    let finger = |i: u32| {
        let (sin, cos) = (TAU * f64::from(i) / 4.0 + 0.1 * f64::from(i * i)).sin_cos();
        Contact::new([cos, sin, 0.1 * f64::from(i)], [-cos, -sin, 0.05])
            .series_stiffness(1000.0, 700.0)
            .friction(0.4 + 0.03 * f64::from(i))
            .command([0.01, 0.0, 0.0])
    };
    Grasp::new((0..4).map(finger)).unwrap()
}

#[test]
fn a_path_stops_where_its_steps_are_used_up() {
    let (grasp, load) = (glass(), Wrench::force([4.0, 1.0, -30.0]));
    let followed = |most_steps: usize| {
        let settings = Settings::default().with_most_steps(most_steps);
        let asked = grasp.with(&settings);
        let mut path = asked.follow(Wrench::ZERO, &[Leg::load_to(load)]).unwrap();
        let events = path.run().len();
        (path.end().unwrap().clone(), events)
    };
    let (whole, events) = followed(20_000);
    let Some(limit) = whole.loss().map(|loss| loss.fraction) else { panic!("{whole:?}") };
    let mut before = 0.0;
    for most_steps in [0, 1, 3, 6] {
        let (end, seen) = followed(most_steps);
        let PathEnd::Undecided { leg: 0, fraction, doubt: Doubt::OutOfSteps } = end else {
            panic!("{end:?}")
        };
        assert!(
            fraction > 0.0 && fraction >= before && fraction < limit && seen <= events,
            "{most_steps}: {fraction}"
        );
        before = fraction;
    }
}

/// With too few steps the verdict is a lower bound on the load that is held.
#[test]
fn a_verdict_without_steps_is_a_lower_bound() {
    let (grasp, ramp) = (glass(), Ramp::load(Wrench::ZERO, Wrench::force([4.0, 1.0, -30.0])));
    let whole = grasp.hold(&ramp).unwrap();
    let short = grasp.with(&Settings::default().with_most_steps(5)).hold(&ramp).unwrap();
    assert!(short.lost.is_none() && short.holds().is_none());
    let (held, limit) = (short.held_to, whole.lost.unwrap().factor);
    assert!(held >= short.first_slip.unwrap().factor && held < limit, "{held} {limit}");
}
