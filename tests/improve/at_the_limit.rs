//! An improved grasp that uses all its friction at rest is named as such.

use grasp_lcp::improve::{ActiveConstraintKind, Improve, Surface};
use grasp_lcp::planar::{Contact, Grasp, Wrench};

/// Jaws of unequal friction gain most for this load across a diagonal. In the improved grasp the left jaw carries all its friction before any load.
#[test]
fn jaws_across_a_diagonal_are_at_the_limit_of_friction() {
    let jaw = |x: f64, y: f64, k: [f64; 2], mu: f64| {
        let jaw = Contact::new([x, y], [-x, 0.0]).series_stiffness(k[0], k[1]).friction(mu);
        jaw.pressed_with(5.1086).name(if x < 0.0 { "left" } else { "right" })
    };
    let [left, right] = [
        jaw(-0.04, -0.0008, [6917.2525, 6997.6942], 0.2713),
        jaw(0.04, -0.0038, [3466.4333, 8293.1325], 0.5453),
    ];
    let grasp = Grasp::new([left, right]).unwrap();
    let edge = |x: f64| Surface::segment([x, -0.02], [x, 0.02]);
    let load = Wrench::force_at([0.3491, -2.6934], [-0.0142, -0.0012]);
    let question = Improve::new(load).along(0, edge(-0.04)).along(1, edge(0.04)).pressing_at_most(20.0);
    let improved = grasp.improve(&question).unwrap();
    assert!(
        improved.in_the_way.iter().any(|way| matches!(way.binds, ActiveConstraintKind::Rest { .. })),
        "{improved}"
    );
    let there = improved.placed(&grasp).unwrap().solve(Wrench::ZERO).unwrap();
    let left = &there.equilibrium().unwrap().contacts[0];
    assert!(left.margin.abs() < 1e-6 * left.normal_force(), "{}", left.margin);
    assert!(improved.to_string().contains("CAUTION: at rest left is at the limit of friction"), "{improved}");
}
