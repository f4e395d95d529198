//! Loads on several bodies can grow together, each in its own direction.

use grasp_lcp::Error;
use grasp_lcp::load_path::Onset;
use grasp_lcp::planar::{Bodies, Body, Contact, Grasp, Leg, Link, Wrench};
use support::facts;

/// Two boxes on each other on a table: 20 N and 10 N, μ = 0.5 below and 0.3 between them.
pub(crate) fn boxes() -> Grasp {
    let at =
        |x: f64, y: f64, mu: f64| Contact::new([x, y], [0.0, 1.0]).series_stiffness(1e5, 1e5).friction(mu);
    Bodies::new([
        Body::new("lower").load(Wrench::force_at([0.0, -20.0], [0.0, 0.1])),
        Body::new("upper").load(Wrench::force_at([0.0, -10.0], [0.0, 0.3])),
    ])
    .contacts([-0.2, 0.2].map(|x| at(x, 0.0, 0.5).on("lower")))
    .contacts([-0.2, 0.2].map(|x| at(x, 0.2, 0.3).on("upper").against("lower")))
    .grasp()
    .expect("well posed")
}

pub(crate) fn pull(newtons: f64, height: f64) -> Wrench {
    Wrench::force_at([newtons, 0.0], [0.0, height])
}

/// P pulls the lower box, and Q pulls the upper box in the opposite direction. The upper box slides at Q = μ 10 N, both slide on the table at P - Q =
/// μ 30 N.
#[test]
fn boxes_that_are_pulled_apart() {
    for (p, q, lost) in [(10.0, 2.0, 1.5), (10.0, 5.0, 0.6), (20.0, -2.0, 15.0 / 22.0)] {
        let grasp =
            boxes().growing_together(&pull(p, 0.01), [("upper", pull(-q, 0.21))]).expect("well posed");
        let verdict = grasp.hold(pull(p, 0.01)).expect("well posed");
        let factor = verdict.lost.as_ref().unwrap_or_else(|| panic!("{verdict}")).factor;
        assert!((factor - lost).abs() < 1e-12, "{factor} {lost}");
    }
}

/// All questions accept a load factor for the common loads, and report the loads.
#[test]
fn every_question_takes_multiples() {
    let one = pull(10.0, 0.01);
    let grasp = boxes().growing_together(&one, [("upper", pull(-5.0, 0.21))]).expect("well posed");
    let Onset::At(event) = grasp.onset(one).expect("well posed") else { panic!("slides") };
    let outcome = grasp.solve(one * event.factor).expect("well posed");
    let state = outcome.equilibrium().expect("holds");
    assert!(state.residuals.worst() < 1e-14, "{}", state.residuals.worst());
    let across =
        |range: std::ops::Range<usize>| state.contacts[range].iter().map(|c| c.force_world[0]).sum::<f64>();
    assert!((across(2..4) - 5.0 * event.factor).abs() < 1e-12);
    assert!((across(0..2) + 5.0 * event.factor).abs() < 1e-12);
    let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_to(one)]).expect("well posed");
    path.run();
    let loss = path.end().and_then(|end| end.loss()).unwrap();
    assert!((loss.fraction - 0.6).abs() < 1e-12);
}

/// A hand presses the handles of pliers with P, 100 mm from the pin. The jaws press with N at 10 mm, with faces 2 mm off the pin, so that a pull of
/// 12 N on the rod tightens them: `10 N = 100 P + 2 μ N` and `12 = 2 μ N`. So P = 2.88 N is enough.
#[test]
fn hands_on_pliers() {
    let jaw = |side: f64, lever: &str| {
        let at = Contact::new([0.01, 0.002 * side], [0.0, -side]).series_stiffness(1e6, 1e6).friction(0.2);
        at.on("rod").against(lever)
    };
    let rod = Body::new("rod").load(Wrench::force_at([12.0, 0.0], [0.01, 0.0]));
    let pin = Link::hinge([0.0, 0.0]);
    let pliers = Bodies::new([rod, Body::new("upper"), Body::new("lower")])
        .contacts([jaw(1.0, "upper"), jaw(-1.0, "lower")])
        .links([pin.clone().between("upper", "lower"), pin.to_ground("lower")])
        .loaded("upper")
        .grasp()
        .expect("well posed");
    let press = |newtons: f64| Wrench::force_at([0.0, newtons], [-0.1, 0.0]);
    let pressed = pliers.growing_together(&press(1.0), [("lower", press(-1.0))]).expect("well posed");
    let holds = |newtons: f64| pressed.solve(press(newtons)).expect("well posed").equilibrium().is_some();
    assert_eq!([holds(2.88 - 1e-9), holds(2.88 + 1e-9)], [false, true]);
}

#[test]
fn refused() {
    let grow =
        |load: Wrench, name: &str, other: Wrench| boxes().growing_together(&load, [(name, other)]).err();
    let one = pull(1.0, 0.0);
    assert_eq!(grow(Wrench::ZERO, "upper", one), Some(Error::NothingChanges));
    assert!(matches!(grow(one, "upper", pull(f64::NAN, 0.0)), Some(Error::Wrench { .. })));
    let [name, fault, _] = facts(&grow(one, "lid", one).expect("refused"));
    assert!(name == "lid" && fault.contains("lower, upper"), "{fault}");
    let alone =
        Grasp::new([Contact::new([0.0; 2], [0.0, 1.0]).series_stiffness(1.0, 1.0)]).expect("well posed");
    let [name, fault, _] = facts(&alone.growing_together(&one, [("lid", one)]).expect_err("refused"));
    assert!(name == "lid" && fault.contains("has no bodies"), "{fault}");
}
