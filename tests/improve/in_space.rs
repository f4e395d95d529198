//! Optimal finger places in space agree with closed forms.

use grasp_lcp::improve::{Improve, Surface};
use grasp_lcp::spatial::{Contact, Grasp, Loads, Wrench};

const CLOSE: f64 = 1e-9;

fn finger(angle: f64, height: f64, normal: f64) -> Contact {
    let (sin, cos) = angle.sin_cos();
    let contact = Contact::new([0.05 * cos, 0.05 * sin, height], [-cos, -sin, 0.0]);
    contact.series_stiffness(1e3, normal).friction(0.5).pressed_with(9.0)
}

/// Three fingers on a can carry a weight along its axis up to 3 μ N, at the angles of a third of a turn.
#[test]
fn fingers_on_a_can_carry_with_all_their_friction() {
    let start = [(0.2, 0.01), (2.0, -0.012), (4.5, 0.004)];
    let grasp = Grasp::new(start.map(|(angle, height)| finger(angle, height, 8e2))).expect("three fingers");
    let can = || Surface::cylinder([0.0, 0.0, -0.03], [0.0, 0.0, 0.03], 0.05);
    let question =
        Improve::new(Wrench::force([0.0, 0.0, -1.0])).along(0, can()).along(1, can()).along(2, can());
    let improved = grasp.improve(&question.pressing_at_most(10.0)).expect("asked well");
    assert!((improved.after.expect("sticks") - 15.0).abs() < CLOSE, "{improved:.12}");
    assert!(improved.is_locally_best(), "{improved}");
}

/// Under a force of any direction, three fingers on a ball are best on a great circle, as on a disc.
#[test]
fn fingers_on_a_ball_stand_on_a_great_circle() {
    let grasp = Grasp::new([0.1, 2.3, 4.0].map(|angle| finger(angle, 0.0, 1e3))).expect("three fingers");
    let ball = || Surface::sphere([0.0; 3], 0.05);
    let any = Loads::AnyForce { base: Wrench::ZERO, size: 1.0, point: [0.0; 3] };
    let question =
        Improve::new(any).along(0, ball()).along(1, ball()).along(2, ball()).pressing_at_most(10.0);
    let improved = grasp.improve(&question).expect("asked well");
    let exact = 30.0 * 0.5 / 1.25_f64.sqrt();
    assert!((improved.after.expect("sticks") - exact).abs() < CLOSE, "{improved:.12} for {exact:.12}");
}

/// A clamp that presses a plate on three pads.
fn clamped(x: f64, y: f64) -> Grasp {
    let pad = |x: f64, y: f64, z: f64| {
        let contact = Contact::new([x, y, z], [0.0, 0.0, -z]).series_stiffness(1e3, 8e2);
        contact.friction(0.4).pressed_with(if z > 0.0 { 10.0 } else { 3.0 })
    };
    let pads = [pad(-0.03, -0.02, -0.01), pad(0.03, -0.02, -0.01), pad(0.01, 0.02, -0.01), pad(x, y, 0.01)];
    Grasp::new(pads).unwrap()
}

/// A clamp on a plate has the same optimum on a rectangle and on its two triangles.
#[test]
fn triangles_and_rectangles_agree() {
    let grasp = clamped(0.01, -0.01);
    let corner = |x: f64, y: f64| [x, y, 0.01];
    let [a, b, c, d] = [corner(-0.04, -0.02), corner(0.04, -0.02), corner(0.04, 0.02), corner(-0.04, 0.02)];
    let rectangle = Surface::rectangle(a, [[0.08, 0.0, 0.0], [0.0, 0.04, 0.0]]);
    let halves = Surface::triangles([[a, b, c], [a, c, d]]);
    let best = |surface: Surface<3>| {
        let loads = vec![
            Wrench::force([1.0, 0.0, 0.0]),
            Wrench::force([0.0, 1.0, 0.0]),
            Wrench::force([0.5, -1.0, 0.0]),
        ];
        let improved = grasp.improve(&Improve::new(loads).along(3, surface)).expect("asked well");
        assert!(improved.is_locally_best(), "{improved}");
        assert!(improved.contacts[3].moved > 1e-3, "{improved}");
        (improved.after.expect("sticks"), improved.contacts[3].point)
    };
    let [one, other] = [best(rectangle), best(halves)];
    assert!((one.0 - other.0).abs() < 1e-9 * one.0, "{one:?} {other:?}");
}

/// From a single start, a clamp on a plate of many triangles moves over their edges to the optimum of the whole plate.
#[test]
fn fingers_go_over_the_edges_of_a_mesh() {
    let grasp = clamped(-0.015, -0.013);
    let corner = |i: i32, k: i32| [0.01 * f64::from(i) - 0.04, 0.01 * f64::from(k) - 0.02, 0.01];
    let cells = (0..8).flat_map(|i| (0..4).map(move |k| (i, k)));
    let halves = cells.flat_map(|(i, k)| {
        let [a, b, c, d] = [corner(i, k), corner(i + 1, k), corner(i + 1, k + 1), corner(i, k + 1)];
        [[a, b, c], [a, c, d]]
    });
    let best = |surface: Surface<3>| {
        let loads = vec![Wrench::force([1.0, 0.0, 0.0]), Wrench::force([0.5, -1.0, 0.0])];
        let question = Improve::new(loads).along(3, surface).with_starts(0);
        let improved = grasp.improve(&question).expect("asked well");
        let moved = &improved.contacts[3];
        assert!(moved.moved > 0.015, "{improved}");
        assert!(["rectangle", "mesh"].contains(&moved.surface.as_deref().expect("has one")), "{moved:?}");
        improved.after.expect("sticks")
    };
    let plate = best(Surface::rectangle(corner(0, 0), [[0.08, 0.0, 0.0], [0.0, 0.04, 0.0]]));
    let mesh = best(Surface::triangles(halves));
    assert!((plate - mesh).abs() < 1e-9 * plate, "{plate} {mesh}");
}
