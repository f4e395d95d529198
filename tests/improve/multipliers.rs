//! A multiplier is the gain of the goal for one more newton or metre of its bound. Differences of whole answers confirm this.

use grasp_lcp::improve::{ActiveConstraintKind, Improve, Improved, Surface};
use grasp_lcp::planar::{Contact, Grasp, Wrench};
use support::jaws;

fn jaw(x: f64) -> Contact {
    jaws::jaw::<2>(x, [1e3, 8e2], 0.5).pressed_with(8.0)
}

/// Two jaws on edges from `-half` to `half`, which press with at most `force` newtons. The load is so far from the middle that the jaws reach the
/// ends of the edges before they balance its moment.
fn asked(half: f64, force: f64) -> Improved<2> {
    let grasp = Grasp::new([jaw(-0.03), jaw(0.03)]).expect("two jaws");
    let edge = |x: f64| Surface::segment([x, -half], [x, half]);
    let load = Wrench::force_at([0.0, -1.0], [0.02, 0.0]);
    let question = Improve::new(load).along(0, edge(-0.03)).along(1, edge(0.03)).pressing_at_most(force);
    grasp.improve(&question).expect("asked well")
}

fn after(improved: &Improved<2>) -> f64 {
    improved.after.expect("sticks")
}

#[test]
fn ends_of_edges_gain_as_their_multipliers_say() {
    let improved = asked(0.006, 10.0);
    assert!(improved.is_locally_best(), "{improved}");
    let told: f64 = improved
        .in_the_way
        .iter()
        .filter_map(|way| {
            if let ActiveConstraintKind::End { per_metre } = way.binds { Some(per_metre) } else { None }
        })
        .sum();
    let h = 1e-6;
    let difference = (after(&asked(0.006 + h, 10.0)) - after(&asked(0.006 - h, 10.0))) / (2.0 * h);
    assert!(difference > 1.0 && (told - difference).abs() < 1e-5 * difference, "{told} {difference}");
}

#[test]
fn forces_gain_as_their_multipliers_say() {
    let improved = asked(0.006, 10.0);
    let told: f64 = improved
        .in_the_way
        .iter()
        .filter_map(|way| match way.binds {
            ActiveConstraintKind::Force { per_newton } | ActiveConstraintKind::Pressed { per_newton } => {
                Some(per_newton)
            }
            _ => None,
        })
        .sum();
    let h = 1e-4;
    let difference = (after(&asked(0.006, 10.0 + h)) - after(&asked(0.006, 10.0 - h))) / (2.0 * h);
    assert!(difference > 0.1 && (told - difference).abs() < 1e-5 * difference, "{told} {difference}");
}

#[test]
fn shares_of_what_comes_first_add_up_to_one() {
    let shares = asked(0.02, 10.0).in_the_way;
    let sum: f64 = shares
        .iter()
        .filter_map(|way| {
            if let ActiveConstraintKind::FirstSlip { share, .. } = way.binds { Some(share) } else { None }
        })
        .sum();
    assert!((sum - 1.0).abs() < 1e-9, "{sum}");
}
