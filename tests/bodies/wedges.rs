//! Wedges from textbooks and benchmarks: pushed up a slope, drawn out, and driven into a gap.

use super::faces::{assert_close, face, lost_at};
use grasp_lcp::planar::{Bodies, Body, ContactAnswer, Link, Wrench};

/// NAFEMS CGS-4 (sliding wedge): up a slope of tan α = 0.1 with μ = 0.3 a push of `(tan α + μ) / (1 - μ tan α)` = 0.412371 of the weight is needed,
/// for every stiffness of the slope.
#[test]
fn a_wedge_is_pushed_up_a_slope() {
    let (rise, mu, weight): (f64, f64, f64) = (0.1, 0.3, 1500.0);
    for weld in [1e5, 1e9] {
        let bodies = Bodies::new([
            Body::new("wedge").load(Wrench::force_at([0.0, -weight], [3.0, 1.0])),
            Body::new("slope"),
        ])
        .contacts(face([0.0, 0.0], [6.0, 6.0 * rise], mu).map(|contact| contact.on("wedge").against("slope")))
        .links([Link::rigid([3.0, -1.0], 2.0).stiffness(weld).to_ground("slope")]);
        let pushed = lost_at(bodies, Wrench::force_at([weight, 0.0], [0.0, 0.5]));
        assert_close(pushed, (rise + mu) / (1.0 - mu * rise));
        assert!((pushed - 0.412_371).abs() < 5e-7);
    }
}

/// The lower of two wedges under 3000 lb is drawn out. They meet at 15° with μ = 0.1; μ = 0.2 at the floor and at the wall that guides the upper wedge
/// (Hibbeler, *Statics*, problems on wedges; there 106 lb).
#[test]
fn a_wedge_is_drawn_out() {
    let (sin, cos) = 15f64.to_radians().sin_cos();
    let bodies = Bodies::new([
        Body::new("lower"),
        Body::new("upper").load(Wrench::force_at([0.0, -3000.0], [0.4, 2.0])),
    ])
    .contacts(face([0.0, 0.0], [2.0, 0.0], 0.2).map(|contact| contact.on("lower").name("floor")))
    .contacts(
        face([0.0, 0.1], [1.0, 0.1 + sin / cos], 0.1).map(|contact| contact.on("upper").against("lower")),
    )
    .contacts(face([0.0, 2.0], [0.0, 0.5], 0.2).map(|contact| contact.on("upper").name("wall")));
    let drawn = 100.0 * lost_at(bodies, Wrench::force_at([100.0, 0.0], [2.0, 0.15]));
    // The upper wedge sinks. Its faces press on it with N and N', and friction acts upwards.
    let wall = sin - 0.1 * cos;
    let between = 3000.0 / (cos + 0.1 * sin + 0.2 * wall);
    assert_close(drawn, between * (0.2 * (cos + 0.1 * sin) + 0.1 * cos - sin));
    assert!((drawn - 105.838).abs() < 5e-4);
}

/// A force of 1760 N pushes a wedge into the gap between a slope of 0.115 with μ = 0.2 and a frictionless guide. It presses on the slope with the
/// total force `1760 √(1 + 0.115²) / (0.115 + 0.2)` = 5624.1 N; the distribution is not determined. The total agrees with FrontISTR's work item 859.
/// The push is not stated there, and was computed from the total.
#[test]
fn a_wedge_is_driven_into_a_gap() {
    let (rise, mu, push) = (0.115, 0.2, 1760.0);
    for stiffness in [1e6, 1e8, 1e10] {
        let grasp = Bodies::new([Body::new("wedge")])
            .contacts(
                face([0.0, 0.0], [4.0, 4.0 * rise], mu).map(|contact| contact.on("wedge").name("slope")),
            )
            .contacts(
                face([4.0, 1.0], [0.0, 1.0], 0.0)
                    .map(|contact| contact.series_stiffness(stiffness, stiffness).on("wedge").name("guide")),
            )
            .grasp()
            .expect("well posed");
        let outcome = grasp.solve(Wrench::force_at([push, 0.0], [0.0, 0.6])).expect("well posed");
        let state = outcome.equilibrium().unwrap();
        let total: f64 = state.contacts[..2].iter().map(ContactAnswer::normal_force).sum();
        assert_close(total, push * f64::hypot(1.0, rise) / (rise + mu));
        assert!((total - 5624.1).abs() < 0.05);
    }
}
