//! Invalid questions are refused with an error that names contact, field and value.

use grasp_lcp::Error;
use grasp_lcp::improve::{Improve, Surface};
use grasp_lcp::planar::{Grasp, Loads, Turn, Wrench};
use support::facts;
use support::jaws::jaw;

/// The place, the datum and the value of the error.
fn refusal(question: &Improve<2>) -> [String; 3] {
    let jaw = |x: f64, name| jaw::<2>(x, [1e3, 8e2], 0.5).name(name).pressed_with(8.0);
    let grasp = Grasp::new([jaw(-0.03, "left"), jaw(0.03, "right")]).expect("two jaws");
    grasp.improve(question).map_or_else(|error: Error| facts(&error), |answer| panic!("{answer}"))
}

fn asked() -> Improve<2> {
    Improve::new(Wrench::force([0.0, -1.0]))
}

#[test]
fn errors_name_contact_field_and_value() {
    // The beginning of the datum's name is compared.
    let cases = [
        (asked(), "improve", "surface", ""),
        (asked().along(0, Surface::circle([0.0, 0.0], -1.0)), "0 (left)", "radius", "-1"),
        (
            asked().along(1, Surface::segment([0.04, -0.01], [0.04, 0.01])),
            "1 (right)",
            "distance",
            "0.010000000000000002",
        ),
        (
            asked().along(0, Surface::segment([-0.03, 0.0], [-0.02, 0.0])),
            "0 (left)",
            "angle",
            "1.4142135623730951",
        ),
        (asked().along(2, Surface::circle([0.0, 0.0], 1.0)), "contact", "2", "2"),
        (asked().pressing_at_most(-2.0), "0 (left)", "pressing force", "-2"),
        (
            Improve::new(Loads::Turn(Turn::tilting([0.0, -1.0], [0.0, 0.0]))).pressing_at_most(1.0),
            "improve",
            "turn",
            "",
        ),
        (asked().pressing_at_most(1.0).with_starts(1_000_000), "", "number of starts", "1000000"),
        (Improve::new(Vec::new()).pressing_at_most(1.0), "improve", "load", ""),
    ];
    for (question, place, datum, value) in cases {
        let [named, field, given] = refusal(&question);
        assert!(named == place && field.starts_with(datum) && given == value, "{named} {field} {given}");
    }
}

#[test]
fn what_is_nearest_to_nothing_is_refused() {
    let asked = |surface: Surface<2>, point: [f64; 2], normal: [f64; 2]| {
        surface.nearest(point, normal).map_or_else(|error| facts(&error), |there| panic!("{there:?}"))
    };
    let disc = || Surface::circle([0.0, 0.0], 0.05);
    let [point, normal] = [[0.1, 0.0], [-1.0, 0.0]];
    let mesh = Surface::triangles([]).nearest([0.0; 3], [0.0, 0.0, 1.0]).expect_err("empty");
    for ([_, datum, value], expected, given) in [
        (asked(Surface::polyline([]), point, normal), "length of an", "0"),
        (asked(Surface::spline([], true), point, normal), "least distance", "0"),
        (asked(disc(), [f64::NAN, 0.0], normal), "coordinate", "NaN"),
        (asked(disc(), point, [0.0, 0.0]), "length of the", "0"),
        (asked(disc(), point, [f64::INFINITY, 0.0]), "length of the", "inf"),
        (facts(&mesh), "height", "0"),
    ] {
        assert!(datum.starts_with(expected) && value == given, "{datum} {value}");
    }
}
