//! The largest friction margin under given loads agrees with closed forms, and with the margins of the equilibria of the improved grasp. A friction
//! margin is the friction limit μ N minus the tangential force.

use grasp_lcp::improve::{ActiveConstraintKind, Improve, ImproveGoal, Surface};
use grasp_lcp::planar::{Contact, Grasp, Loads, Wrench};
use grasp_lcp::spatial;
use support::jaws::jaws;

const CLOSE: f64 = 1e-9;

fn edge(x: f64) -> Surface<2> {
    Surface::segment([x, -0.02], [x, 0.02])
}

/// The question for two jaws that carry a load at a distance from their middle.
fn carried(load: f64, aside: f64) -> Improve<2> {
    let question = Improve::new(Wrench::force_at([0.0, -load], [aside, 0.0])).with_goal(ImproveGoal::Reserve);
    question.along(0, edge(-0.03)).along(1, edge(0.03))
}

/// One jaw is higher by P e / N, so that the couple of the normal forces N balances the load P at the distance e. Each jaw carries half of the load,
/// with the margin `μ N - P / 2`. For the goal of the largest load at first slip, the difference in height would be 2 μ e, 10 mm instead of 4 mm.
#[test]
fn a_load_aside_is_balanced_as_it_is_and_not_as_it_may_become() {
    let improved = jaws([0.5; 2]).expect("two jaws").improve(&carried(4.0, 0.01)).expect("asked well");
    assert!((improved.after.expect("sticks") - 3.0).abs() < CLOSE, "{improved:.12}");
    assert!(improved.is_locally_best(), "{improved}");
    let higher = improved.contacts[1].point[1] - improved.contacts[0].point[1];
    assert!((higher - 0.004).abs() < 1e-8, "{higher}");
    let words = improved.to_string();
    assert!(words.starts_with("RESERVE"), "{words}");
    assert!(words.contains("have least"), "{words}");
}

/// With equal stiffness along both axes, each of three fingers carries a third of a force F of any direction. This reduces its margin by `F √(1 + μ²) / 3`.
#[test]
fn three_fingers_on_a_disc_keep_what_a_third_of_any_force_leaves() {
    let finger = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        let contact = Contact::new([0.05 * cos, 0.05 * sin], [-cos, -sin]).series_stiffness(1e3, 1e3);
        contact.friction(0.5).pressed_with(6.0)
    };
    let grasp = Grasp::new([0.3, 1.9, 4.4].map(finger)).expect("three fingers");
    let any = Loads::AnyForce { base: Wrench::ZERO, size: 6.0, point: [0.0, 0.0] };
    let question = Improve::new(any).with_goal(ImproveGoal::Reserve).pressing_at_most(10.0);
    let question = (0..3).fold(question, |question, k| question.along(k, Surface::circle([0.0, 0.0], 0.05)));
    let improved = grasp.improve(&question).expect("asked well");
    let exact = 0.5 * 10.0 - 6.0 * 1.25_f64.sqrt() / 3.0;
    assert!((improved.after.expect("sticks") - exact).abs() < CLOSE, "{improved:.12} for {exact:.12}");
    assert!(improved.is_locally_best(), "{improved}");
}

/// The reported goal is the least friction margin of the equilibria under all loads, with round friction cones, before and after the improvement.
#[test]
fn it_is_the_least_margin_of_the_grasp_under_its_loads() {
    use spatial::{Contact, Grasp, Loads, Wrench};
    let finger = |angle: f64, height: f64| {
        let (sin, cos) = angle.sin_cos();
        let contact = Contact::new([0.05 * cos, 0.05 * sin, height], [-cos, -sin, 0.0]);
        contact.series_stiffness(1e3, 8e2).friction(0.5).pressed_with(9.0)
    };
    let grasp = Grasp::new([finger(0.3, 0.01), finger(1.9, -0.01), finger(4.4, 0.0)]).expect("three");
    let weight = Wrench::force([0.0, 0.0, -3.0]);
    let loads = vec![Wrench::force([1.5, 0.5, 0.0]), Wrench::new([0.0, -1.0, 0.5], [0.01, 0.0, 0.02])];
    let can = || Surface::cylinder([0.0, 0.0, -0.03], [0.0, 0.0, 0.03], 0.05);
    let question = Improve::new(Loads::Each(loads.clone())).on_top_of(weight).with_goal(ImproveGoal::Reserve);
    let question = (0..3).fold(question, |question, k| question.along(k, can())).pressing_at_most(12.0);
    let improved = grasp.improve(&question).expect("asked well");
    let least = |grasp: &Grasp| {
        let margins = loads.iter().flat_map(|load| {
            let outcome = grasp.solve(weight + *load).expect("a load");
            let state = outcome.equilibrium().expect("held").clone();
            state.contacts.iter().map(|contact| contact.margin).collect::<Vec<_>>()
        });
        margins.fold(f64::INFINITY, f64::min)
    };
    let [before, after] = [improved.before, improved.after].map(|reserve| reserve.expect("sticks"));
    assert!(after > before, "{improved}");
    assert!((least(&grasp) - before).abs() < 1e-9, "{before}");
    assert!((least(&improved.placed(&grasp).expect("three")) - after).abs() < 1e-9, "{after}");
}

/// The reserve is the margin `μ N - P / 2`. So the multipliers of the squeeze limits of both jaws, the gain per newton, have the sum μ.
#[test]
fn its_multipliers_are_what_a_newton_gains() {
    let improved = jaws([0.5; 2])
        .expect("two jaws")
        .improve(&carried(4.0, 0.0).pressing_at_most(12.0))
        .expect("asked well");
    assert!((improved.after.expect("sticks") - 4.0).abs() < CLOSE, "{improved:.12}");
    let gains = improved.in_the_way.iter().filter_map(|way| match way.binds {
        ActiveConstraintKind::Force { per_newton } | ActiveConstraintKind::Pressed { per_newton } => {
            Some(per_newton)
        }
        _ => None,
    });
    assert!((gains.sum::<f64>() - 0.5).abs() < 1e-6, "{improved:?}");
    let shares = improved.in_the_way.iter().filter_map(|way| match way.binds {
        ActiveConstraintKind::Reserve { load, share } => Some((load, share)),
        _ => None,
    });
    let shares: Vec<_> = shares.collect();
    assert!(shares.iter().all(|(load, _)| *load == Some(0)), "{shares:?}");
    assert!((shares.iter().map(|(_, share)| share).sum::<f64>() - 1.0).abs() < 1e-9, "{shares:?}");
}

/// The given grasp slides under the load, and is improved all the same.
#[test]
fn what_slides_is_improved() {
    let improved = jaws([0.5; 2])
        .expect("two jaws")
        .improve(&carried(9.0, 0.01).pressing_at_most(20.0))
        .expect("asked well");
    assert_eq!(improved.before, None);
    assert!((improved.after.expect("sticks") - 5.5).abs() < CLOSE, "{improved:.12}");
    assert!(improved.to_string().contains("instead of sliding"), "{improved}");
}

/// A load of 30 N exceeds the friction of every grasp.
#[test]
fn what_no_grasp_carries_is_told_so() {
    let improved = jaws([0.5; 2]).expect("two jaws").improve(&carried(30.0, 0.0)).expect("asked well");
    assert_eq!((improved.before, improved.after), (None, None));
    assert!(improved.to_string().starts_with("NO GRASP"), "{improved}");
}
