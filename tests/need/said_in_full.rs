//! An answer names in full the newtons of a held contact, both ends of a safe range, and the load that determines the amount.

use grasp_lcp::need::{Amount, Need};
use grasp_lcp::planar::hand::{Finger, Hand};
use grasp_lcp::planar::{Contact, Grasp, Wrench};

const MU: f64 = 0.3;
const WEIGHT: f64 = 4905.0;
const PULL: f64 = 3924.0;

/// A crate of 1 m on a floor, held down by a strap at 45° with a given force. Without its weight the strap alone pushes it away.
fn strapped() -> Grasp {
    let floor = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e7, 1e7).friction(MU);
    let strap = Contact::new([0.5, 0.5], [-1.0, -1.0]).series_stiffness(1e5, 1e5).force(2000.0).name("strap");
    Hand::new([floor(-0.5), floor(0.5), strap].map(Finger::fixed)).grasp().expect("well posed")
}

/// The pull F is balanced by μ (W + T s) + T s with the tension T of the strap and s = sin 45°. Without the pull T s may be at most μ (W + T s).
#[test]
fn newtons_of_a_strap_that_only_the_weight_holds() {
    let s = 0.5_f64.sqrt();
    let [least, most] = [(PULL - MU * WEIGHT) / ((1.0 + MU) * s), MU * WEIGHT / ((1.0 - MU) * s)];
    let [weight, pull] = [[0.0, -WEIGHT], [PULL, 0.0]].map(|force| Wrench::force_at(force, [0.0, 0.5]));
    let needed = strapped().need(&Need::squeeze(pull).on_top_of(weight)).expect("well posed");
    let Amount::Bound { sufficient, until: Some(end), presses, .. } = needed.amount else {
        panic!("{needed}")
    };
    assert!((2000.0 * sufficient / least - 1.0).abs() < 1e-9, "{sufficient}");
    for (presses, force) in [(presses, least), (end.presses, most)] {
        let strap = presses.iter().find(|press| press.is_set).expect("the strap is set");
        assert!(
            *strap.part.label == *"strap" && (strap.force / force - 1.0).abs() < 1e-9,
            "{strap:?} {force}"
        );
    }
}

/// A bracket whose edges touch a post h = 0.1 m apart jams from an arm of h/(2μ) on, however large the load.
fn bracket() -> Grasp {
    let edge =
        |x: f64, y: f64, way: f64| Contact::new([x, y], [way, 0.0]).series_stiffness(1e8, 1e8).friction(0.2);
    Grasp::new([edge(-0.02, 0.05, -1.0), edge(0.02, -0.05, 1.0)]).expect("well posed")
}

#[test]
fn both_ends_of_a_safe_range() {
    let down = Wrench::force([0.0, -500.0]);
    let arm = Need::arm(down, Wrench::new([0.0, 0.0], -500.0));
    for (need, friction, load) in [(arm.clone(), 0.9, 1.0), (arm.with_safety(2.0), 1.0, 2.0)] {
        let needed = bracket().need(&need).expect("well posed");
        let range = |amount: &Amount| match amount {
            Amount::Bound { sufficient, until: Some(end), is_too_far: true, .. } => {
                [end.sufficient, *sufficient]
            }
            other => panic!("{other:?}"),
        };
        let ([near, far], [safe_near, safe_far]) =
            (range(&needed.amount), range(needed.safe.as_ref().expect("it is asked for")));
        assert!(
            (near - 0.25).abs() < 1e-9 && (safe_near - 0.25 / friction).abs() < 1e-7,
            "{near} {safe_near}"
        );
        // Small motions end at a moment: far out the arm is in inverse proportion to the load.
        assert!(safe_far < far && (safe_far * load / far - 1.0).abs() < 1e-2, "{far} {safe_far}");
    }
}

/// Of three loads the second is the largest that friction has to carry: 2 μ N = 16 N.
#[test]
fn which_of_several_loads_decides() {
    let jaw = |x: f64| {
        Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(0.4).pressed_with(10.0)
    };
    let gripper = Grasp::new([jaw(-0.03), jaw(0.03)]).expect("well posed");
    let loads = [5.0, 16.0, 3.0].map(|newtons| Wrench::force([0.0, -newtons]));
    let needed = gripper.need(&Need::squeeze(loads.to_vec())).expect("well posed");
    let Amount::Bound { sufficient, otherwise, .. } = needed.amount else { panic!("{needed}") };
    assert!(
        (sufficient - 2.0).abs() < 1e-11 && otherwise.starts_with("under load 2, (0, -16) N: "),
        "{otherwise}"
    );
    let alone = gripper.need(&Need::squeeze(loads[1])).expect("well posed");
    assert!(!alone.to_string().contains("under load"), "{alone}");
}
