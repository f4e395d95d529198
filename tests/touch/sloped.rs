//! A face at an angle carries the part of the squeeze that its slope and friction allow, and edges are reported.

use grasp_lcp::spatial::Contact;
use grasp_lcp::touch::{Pad, Part, Touch};

use crate::shapes::{part, prism};

/// A roof with its ridge along z at the origin. Both sides slope by this angle, rad, away from a pad that closes along x.
fn roof(slope: f64) -> Part {
    let fall = 0.05 * slope.tan();
    part(&prism(
        &[[0.0, 0.0], [fall, -0.05], [fall + 0.05, -0.05], [fall + 0.05, 0.05], [fall, 0.05]],
        0,
        0.08,
    ))
}

fn pad(y: f64, friction: f64) -> Touch {
    let contact = Contact::new([-0.01, y, 0.04], [1.0, 0.0, 0.0]).tangent([0.0, 1.0, 0.0]).name("jaw");
    Touch::new(
        Pad::rectangle([0.02, 0.03], [2, 1]).expect("a rectangle").of_layer(1e6, 1e-3),
        contact.friction(friction).pressed_with(20.0),
    )
}

#[test]
fn a_ridge_is_an_edge_unless_friction_bridges_it() {
    let slope = 0.3_f64;
    for (friction, edge) in [(0.2, true), (0.35, false)] {
        let touched = pad(0.0, friction).on(&roof(slope)).expect("touches");
        assert_eq!(touched.is_over_an_edge(), edge);
        assert!((touched.steepest() - slope).abs() < 1e-12, "{}", touched.steepest());
    }
    let flat = pad(0.0, 0.0).on(&roof(0.0)).expect("touches");
    assert!(!flat.is_over_an_edge() && flat.steepest() == 0.0);
}

/// On one slope all points stick or all slide. The sum of their forces along the closing direction is the squeeze.
#[test]
fn a_slope_takes_the_squeeze_with_its_friction() {
    let slope = 0.4_f64;
    for friction in [0.0, 0.1, 2.0] {
        let touched = pad(0.02, friction).on(&roof(slope)).expect("touches");
        let mut along = 0.0;
        for contact in touched.contacts() {
            let k = contact.series_stiffness_of_axes();
            let [normal, first, second]: [f64; 3] = contact.commanded().into();
            // The travel along the normal before a point touches is its distance behind the foremost point, along the closing direction, times cos θ.
            let before = (contact.point()[0]
                - touched.contacts().iter().map(|c| c.point()[0]).fold(1.0, f64::min))
                * slope.cos();
            let pressed = (normal - before).max(0.0) * k[0];
            let dragged = (k[1] * first).hypot(k[2] * second).min(friction * pressed);
            along += pressed * slope.cos() + dragged * slope.sin();
        }
        assert!((along - 20.0).abs() < 1e-10, "{friction}: {along}");
    }
}
