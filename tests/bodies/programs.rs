//! Load programs may change the load of each body separately.

use grasp_lcp::Error;
use grasp_lcp::equilibrium::Equilibrium;
use grasp_lcp::planar::{Leg, Turn, Wrench};
use support::facts;

use super::growing::{boxes, pull};

/// The largest residual of the balance of two boxes of 20 N and 10 N. `lower` and `upper` act besides their weights.
fn out_of_balance(state: &Equilibrium<2>, lower: Wrench, upper: Wrench) -> f64 {
    let mut sums = [
        Wrench::force_at([0.0, -20.0], [0.0, 0.1]) + lower,
        Wrench::force_at([0.0, -10.0], [0.0, 0.3]) + upper,
    ];
    let points = [[-0.2, 0.0], [0.2, 0.0], [-0.2, 0.2], [0.2, 0.2]];
    for (i, (contact, point)) in state.contacts.iter().zip(points).enumerate() {
        let force = Wrench::force_at(contact.force_world, point);
        if i < 2 {
            sums[0] = sums[0] + force;
        } else {
            (sums[0], sums[1]) = (sums[0] - force, sums[1] + force);
        }
    }
    sums.iter().flat_map(|sum| sum.components().to_vec()).map(f64::abs).fold(0.0, f64::max)
}

/// A force of 2.9 N pulls the upper box back, then a force pulls the lower box forward. Both slide on the table at 15 N more than 2.9 N. In one leg both
/// forces grow in proportion.
#[test]
fn one_after_the_other_and_together() {
    let boxes = boxes();
    for (back, lost) in [(2.9, 17.9), (-2.9, 12.1), (0.0, 15.0)] {
        let legs = [Leg::body_load_to("upper", pull(-back, 0.21)), Leg::load_to(pull(20.0, 0.01))];
        let mut path = boxes.follow(Wrench::ZERO, &legs).expect("well posed");
        path.run();
        let end = path.end().and_then(|end| end.loss()).unwrap();
        assert_eq!(end.leg, 1);
        assert!((end.load.resultant()[0] - lost).abs() < 1e-12, "{:?}", end.load);
    }
    let both = [Leg::load_to(pull(10.0, 0.01)).and_body_load_to("upper", pull(-5.0, 0.21))];
    let mut path = boxes.follow(Wrench::ZERO, &both).expect("well posed");
    path.run();
    let end = path.end().and_then(|end| end.loss()).unwrap();
    assert!((end.fraction - 0.6).abs() < 1e-12, "{}", end.fraction);
}

/// On a leg there and back every state is in balance with its loads, and accepts further questions.
#[test]
fn states_know_the_loads_of_bodies() {
    let boxes = boxes();
    let legs = [
        Leg::body_load_by("upper", pull(2.5, 0.21)).and_load_by(pull(4.0, 0.01)),
        Leg::body_load_by("upper", pull(-5.0, 0.21)).and_body_load_by("lower", pull(1.0, 0.02)),
        Leg::load_to(Wrench::ZERO).and_body_load_to("upper", Wrench::ZERO),
    ];
    let mut path = boxes.follow(Wrench::ZERO, &legs).expect("well posed");
    path.run();
    let at = |leg: usize, fraction: f64| path.state_at(leg, fraction).expect("has passed");
    for (leg, fraction, load, lower, upper) in [
        (0, 0.5, pull(2.0, 0.01), Wrench::ZERO, pull(1.25, 0.21)),
        (1, 0.25, pull(4.0, 0.01), pull(0.25, 0.02), pull(1.25, 0.21)),
        (1, 1.0, pull(4.0, 0.01), pull(1.0, 0.02), pull(-2.5, 0.21)),
        (2, 1.0, Wrench::ZERO, pull(1.0, 0.02), Wrench::ZERO),
    ] {
        let state = at(leg, fraction);
        assert!(state.residuals.worst() < 1e-14, "{leg} at {fraction}: {}", state.residuals.worst());
        let left = out_of_balance(&state, load + lower, upper);
        assert!(left < 1e-13 * 30.0, "{leg} {fraction} {left}");
        let told: Vec<_> = state.body_loads.iter().map(|on| (&*on.body, on.load)).collect();
        let near = |a: &Wrench, b: &Wrench| (*a - *b).components().iter().all(|x| x.abs() < 1e-14);
        for (name, load) in [("lower", lower), ("upper", upper)] {
            let found = told.iter().find(|(body, _)| *body == name).map_or(Wrench::ZERO, |(_, load)| *load);
            assert!(near(&found, &load), "{fraction} {name}: {found:?}");
        }
        // The accuracy is computed again from all loads.
        let accuracy = boxes.accuracy(&state).expect("of this grasp");
        assert!(accuracy.force < 1e-12, "{accuracy:?}");
    }
}

#[test]
fn refused() {
    let boxes = boxes();
    let one = pull(1.0, 0.0);
    let turn = Leg::turn(&Turn::tilting([0.0, -1.0], [0.0, 0.0]));
    for (leg, body, said) in [
        (Leg::body_load_by("lid", one), "lid", "lower, upper"),
        (Leg::body_load_by("upper", one).and_body_load_to("upper", one), "upper", "loaded twice"),
        (turn.and_body_load_to("upper", one), "upper", "must stay"),
    ] {
        let [name, fault, _] = facts(&boxes.follow(Wrench::ZERO, &[leg]).expect_err("refused"));
        assert!(name == body && fault.contains(said), "{name}: {fault}");
    }
    let bad = boxes.follow(Wrench::ZERO, &[Leg::body_load_by("upper", pull(f64::NAN, 0.0))]).err();
    assert!(matches!(bad, Some(Error::Wrench { .. })), "{bad:?}");
    // A cycle must end at the loads of its start.
    let open = boxes.shake(Wrench::ZERO, &[Leg::body_load_by("upper", one)]).expect_err("not closed");
    assert_eq!(open, Error::NotClosed { what: "load of a body", off: 1.0 });
}

/// A cycle in which the loads of two bodies change one after the other is survived while nothing slides.
#[test]
fn a_cycle_of_both() {
    let cycle = |newtons: f64| {
        let pulled = pull(newtons, 0.21);
        [
            Leg::body_load_by("upper", pulled),
            Leg::load_by(pull(5.0, 0.01)),
            Leg::body_load_to("upper", Wrench::ZERO),
            Leg::load_to(Wrench::ZERO),
        ]
    };
    let rests = boxes().shake(Wrench::ZERO, &cycle(2.0)).expect("closed");
    assert_eq!(rests.rests(), Some(true), "{rests}");
    let lost = boxes().shake(Wrench::ZERO, &cycle(3.5)).expect("closed");
    assert_eq!(lost.stays(), Some(false), "{lost}");
}
