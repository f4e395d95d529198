//! Optimal finger places and squeezes in the plane agree with closed forms.

use grasp_lcp::improve::{Improve, Surface};
use grasp_lcp::planar::{Contact, Grasp, Loads, Wrench};

const CLOSE: f64 = 1e-9;

fn jaw(x: f64, y: f64) -> Contact {
    Contact::new([x, y], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(8.0)
}

fn edge(x: f64) -> Surface<2> {
    Surface::segment([x, -0.02], [x, 0.02])
}

/// The best jaws are level and press with their largest force N: the first slip is at 2 μ N.
#[test]
fn a_symmetric_pinch_slides_at_all_its_friction() {
    let grasp = Grasp::new([jaw(-0.03, 0.004), jaw(0.03, -0.006)]).expect("two jaws");
    let question = Improve::new(Wrench::force([0.0, -1.0])).along(0, edge(-0.03)).along(1, edge(0.03));
    let improved = grasp.improve(&question.pressing_at_most(10.0)).expect("asked well");
    assert!((improved.after.expect("sticks") - 10.0).abs() < CLOSE, "{improved:.12}");
    assert!(improved.is_locally_best(), "{improved}");
    let level = improved.contacts[0].point[1] - improved.contacts[1].point[1];
    assert!(level.abs() < 1e-9, "{level}");
    let again = improved.placed(&grasp).expect("as many contacts");
    let onset = again.onset(Wrench::force([0.0, -1.0])).expect("a load");
    assert!((onset.factor().expect("slides") - 10.0).abs() < CLOSE);
}

/// The load is at the distance e from the middle of two jaws. The couple of their normal forces balances its moment if one jaw is higher by 2 μ e,
/// and then each jaw carries half of the load.
#[test]
fn a_load_aside_is_balanced_by_a_couple() {
    let grasp = Grasp::new([jaw(-0.03, 0.0), jaw(0.03, 0.0)]).expect("two jaws");
    let aside = 0.01;
    let load = Wrench::force_at([0.0, -1.0], [aside, 0.0]);
    let question = Improve::new(load).along(0, edge(-0.03)).along(1, edge(0.03)).pressing_at_most(10.0);
    let improved = grasp.improve(&question).expect("asked well");
    assert!((improved.after.expect("sticks") - 10.0).abs() < CLOSE, "{improved:.12}");
    let higher = improved.contacts[1].point[1] - improved.contacts[0].point[1];
    assert!((higher - 2.0 * 0.5 * aside).abs() < 1e-8, "{higher}");
}

/// Three fingers around a disc have equal stiffness along both axes. Each carries a third of a force of any direction, up to `3 N sin α` with the
/// angle of friction α.
#[test]
fn three_fingers_on_a_disc_stand_at_thirds() {
    let angles = [0.3_f64, 1.9, 4.4];
    let finger = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        let contact = Contact::new([0.05 * cos, 0.05 * sin], [-cos, -sin]).series_stiffness(1e3, 1e3);
        contact.friction(0.5).pressed_with(6.0)
    };
    let grasp = Grasp::new(angles.map(finger)).expect("three fingers");
    let any = Loads::AnyForce { base: Wrench::ZERO, size: 1.0, point: [0.0, 0.0] };
    let disc = || Surface::circle([0.0, 0.0], 0.05);
    let question =
        Improve::new(any).along(0, disc()).along(1, disc()).along(2, disc()).pressing_at_most(10.0);
    let improved = grasp.improve(&question).expect("asked well");
    let exact = 30.0 * 0.5 / 1.25_f64.sqrt();
    assert!((improved.after.expect("sticks") - exact).abs() < CLOSE, "{improved:.12} for {exact:.12}");
    assert!(improved.is_locally_best(), "{improved}");
    let direction = |k: usize| improved.contacts[k].normal;
    for (a, b) in [(0, 1), (1, 2), (2, 0)] {
        assert!((direction(a).dot(&direction(b)) + 0.5).abs() < 1e-6, "{}", direction(a).dot(&direction(b)));
    }
}

/// If only the squeeze may change, the load at first slip is proportional to it, up to the largest allowed squeeze force.
#[test]
fn a_squeeze_alone_goes_up_to_its_force() {
    let grasp = Grasp::new([jaw(-0.03, 0.0), jaw(0.03, 0.0)]).expect("two jaws");
    let improved =
        grasp.improve(&Improve::new(Wrench::force([0.0, -2.0])).pressing_at_most(12.0)).expect("asked");
    assert!((improved.before.expect("sticks") - 4.0).abs() < 1e-12);
    assert!((improved.after.expect("sticks") - 6.0).abs() < CLOSE, "{improved}");
    assert_eq!(improved.force, Some(2.0));
    let presses = improved.contacts.iter().map(|placed| placed.pressed_with.expect("is changed"));
    assert!(presses.into_iter().all(|newtons| (newtons - 12.0).abs() < CLOSE), "{improved}");
    assert!(improved.is_locally_best(), "{improved}");
}

/// A grasp that is already optimal is reported as such.
#[test]
fn what_is_best_stays() {
    let grasp = Grasp::new([jaw(-0.03, 0.0), jaw(0.03, 0.0)]).expect("two jaws");
    let question = Improve::new(Wrench::force([0.0, -1.0])).along(0, edge(-0.03)).along(1, edge(0.03));
    let improved = grasp.improve(&question).expect("asked well");
    assert!((improved.after.expect("sticks") - 8.0).abs() < CLOSE);
    assert!(improved.contacts.iter().all(|placed| placed.moved < 1e-9), "{improved}");
    assert!(improved.to_string().contains("nothing better"), "{improved}");
}
