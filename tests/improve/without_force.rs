//! A contact that touches without force neither sticks nor slides: it does not keep the other contacts from a better grasp.

use grasp_lcp::improve::{Improve, ImproveGoal, Surface};
use grasp_lcp::planar::{Contact, Grasp, Loads, Wrench};

const CLOSE: f64 = 1e-9;
/// The weaker coefficient of friction of both jaws.
const MU: f64 = 0.3;
const MOST: f64 = 12.0;
/// Tangential stiffness of each jaw, and of the rest below in the same direction, N/m.
const JAW: f64 = 1e3;
const REST: f64 = 1e4;

/// Two jaws that press with 8 N.
fn jaws() -> [Contact; 2] {
    let jaw = |x: f64, normal: f64, mu: f64| {
        Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(normal, JAW).friction(mu).pressed_with(8.0)
    };
    [jaw(-0.03, 2e3, MU), jaw(0.03, 4e3, 0.6)]
}

/// The jaws, and a rest below the object that it touches without force.
fn with_a_rest() -> Grasp {
    let [a, b] = jaws();
    let rest = Contact::new([0.0, -0.02], [0.0, 1.0]).series_stiffness(REST, REST).friction(0.1);
    Grasp::new([a, b, rest]).expect("three contacts")
}

fn along_edges(loads: impl Into<Loads>) -> Improve<2> {
    let edge = |x: f64| Surface::segment([x, -0.02], [x, 0.02]);
    Improve::new(loads).along(0, edge(-0.03)).along(1, edge(0.03)).pressing_at_most(MOST)
}

fn three_loads() -> Loads {
    Loads::Each(vec![
        Wrench::force_at([0.0, 1.0], [0.005, 0.0]),
        Wrench::force_at([1.0, 0.0], [0.0, 0.015]),
        Wrench::new([0.0, 0.0], 0.02),
    ])
}

/// A lift off the rest slides on the weaker jaw, which carries half, at `2 μ N`.
#[test]
fn jaws_press_to_their_limit_above_an_idle_rest() {
    let question = Improve::new(Wrench::force([0.0, 1.0])).pressing_at_most(MOST);
    let improved = with_a_rest().improve(&question).expect("asked well");
    assert!((improved.before.expect("sticks") - 4.8).abs() < CLOSE, "{improved:.12}");
    assert!((improved.after.expect("sticks") - 2.0 * MU * MOST).abs() < CLOSE, "{improved:.12}");
    assert!(improved.is_locally_best(), "{improved}");
    assert_eq!((improved.contacts[2].pressed_with, improved.contacts[2].normal_force), (None, 0.0));
}

/// The jaws find the same places and commands as without the rest, which none of the loads pushes.
#[test]
fn places_are_found_as_without_the_rest() {
    let question = along_edges(three_loads());
    let alone = Grasp::new(jaws()).expect("two jaws").improve(&question).expect("asked well");
    let improved = with_a_rest().improve(&question).expect("asked well");
    let [alone, improved] = [alone, improved].map(|answer| answer.after.expect("sticks"));
    // Both jaws in the middle at their limit carry 8.64.
    assert!(improved > 8.64 && (improved - alone).abs() < 1e-6 * alone, "{improved} {alone}");
}

/// A load that presses on the rest is shared with it in proportion to stiffness, and the opposite load is not.
#[test]
fn a_load_that_presses_on_the_rest_is_shared() {
    for (loads, exact) in [
        (vec![[0.0, 1.0], [0.0, -1.0]], 2.0 * MU * MOST),
        (vec![[0.0, 0.1], [0.0, -1.0]], MU * MOST * (2.0 * JAW + REST) / JAW),
    ] {
        let loads = Loads::Each(loads.into_iter().map(Wrench::force).collect());
        let question = Improve::new(loads).pressing_at_most(MOST);
        let improved = with_a_rest().improve(&question).expect("asked well");
        assert!((improved.after.expect("sticks") - exact).abs() < CLOSE * exact, "{improved:.12} {exact}");
    }
}

/// The reserve under a lift of 2 N is that of the weaker jaw, which carries 1 N.
#[test]
fn the_reserve_is_that_of_contacts_that_press() {
    let question = Improve::new(Wrench::force([0.0, 2.0])).pressing_at_most(MOST);
    let question = question.with_goal(ImproveGoal::Reserve);
    let improved = with_a_rest().improve(&question).expect("asked well");
    assert!((improved.before.expect("sticks") - (8.0 * MU - 1.0)).abs() < CLOSE, "{improved:.12}");
    assert!((improved.after.expect("sticks") - (MOST * MU - 1.0)).abs() < CLOSE, "{improved:.12}");
    assert!(improved.is_locally_best(), "{improved}");
}

/// The least force aside makes the rest slip, as it has no force; but nothing slides at rest.
#[test]
fn what_has_no_force_does_not_slide_at_rest() {
    let loads = Loads::AnyForce { base: Wrench::ZERO, size: 2.0, point: [0.01, 0.01] };
    let improved = with_a_rest().improve(&along_edges(loads)).expect("asked well");
    assert_eq!(improved.before, Some(0.0));
    assert!(improved.to_string().contains(" N instead of 0 N: "), "{improved}");
}
