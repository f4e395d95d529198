//! What is asked badly is refused by name.

use grasp_lcp::Error;
use grasp_lcp::improve::{Improve, Surface};
use grasp_lcp::planar::{Grasp, Loads, Turn, Wrench};
use support::jaws::jaw;

fn refusal(question: &Improve<2>) -> String {
    let jaw = |x: f64, name| jaw::<2>(x, [1e3, 8e2], 0.5).name(name).pressed_with(8.0);
    let grasp = Grasp::new([jaw(-0.03, "left"), jaw(0.03, "right")]).expect("two jaws");
    grasp.improve(question).map_or_else(|error: Error| error.to_string(), |answer| panic!("{answer}"))
}

fn asked() -> Improve<2> {
    Improve::new(Wrench::force([0.0, -1.0]))
}

#[test]
fn messages_name_contact_field_value_and_what_is_allowed() {
    let cases = [
        (
            asked(),
            "improve: surface is given of no contact and no greatest force, must be one: nothing may change",
        ),
        (
            asked().along(0, Surface::circle([0.0, 0.0], -1.0)),
            "contact 0 (left): radius of its surface is -1, must be finite, above 0 and at most 1e50 m",
        ),
        (
            asked().along(1, Surface::segment([0.04, -0.01], [0.04, 0.01])),
            "contact 1 (right): distance of its point from its surface is 0.010000000000000002, must be 0 m: the point has to lie on it",
        ),
        (
            asked().along(0, Surface::segment([-0.03, 0.0], [-0.02, 0.0])),
            "contact 0 (left): angle between its normal and that of its surface is 1.4142135623730951, must be 0 rad",
        ),
        (
            asked().along(2, Surface::circle([0.0, 0.0], 1.0)),
            "number of the contact is 2, must be less than the number of contacts",
        ),
        (
            asked().pressing_at_most(-2.0),
            "contact 0 (left): pressing force is -2, must be at most a force above 0 and up to 1e50 N",
        ),
        (
            Improve::new(Loads::Turn(Turn::tilting([0.0, -1.0], [0.0, 0.0]))).pressing_at_most(1.0),
            "improve: turn is given, must be loads that grow or a force of any direction",
        ),
        (
            asked().pressing_at_most(1.0).with_starts(1_000_000),
            "number of starts is 1000000, must be at most 1000",
        ),
        (
            Improve::new(Vec::new()).pressing_at_most(1.0),
            "improve: load is missing, must be one of load, loads and any_force",
        ),
    ];
    for (question, message) in cases {
        assert_eq!(refusal(&question), message);
    }
}

#[test]
fn what_is_nearest_to_nothing_is_refused() {
    let asked = |surface: Surface<2>, point: [f64; 2], normal: [f64; 2]| {
        surface.nearest(point, normal).map_or_else(|error| error.to_string(), |there| panic!("{there:?}"))
    };
    let disc = || Surface::circle([0.0, 0.0], 0.05);
    let [point, normal] = [[0.1, 0.0], [-1.0, 0.0]];
    for (told, expected) in [
        (asked(Surface::polyline([]), point, normal), "length of an edge of its surface is 0, must be "),
        (
            asked(Surface::spline([], true), point, normal),
            "least distance of points of its spline is 0, must be ",
        ),
        (asked(disc(), [f64::NAN, 0.0], normal), "coordinate of the point is NaN, must be "),
        (asked(disc(), point, [0.0, 0.0]), "length of the normal is 0, must be finite, above 0"),
        (asked(disc(), point, [f64::INFINITY, 0.0]), "length of the normal is inf, must be finite, above 0"),
    ] {
        assert!(told.starts_with(expected), "{told}");
    }
    let mesh = Surface::triangles([]).nearest([0.0; 3], [0.0, 0.0, 1.0]);
    assert!(
        mesh.is_err_and(|error| error.to_string().starts_with("height of a triangle of its surface is 0"))
    );
}
