//! Pads without touch and numbers out of range return typed errors that name the contact.

use grasp_lcp::spatial::Contact;
use grasp_lcp::touch::{Pad, Touch};
use grasp_lcp::{Error, Field};

use crate::shapes::{bracket_in_metres, part, round};

fn jaw(at: [f64; 3], closing: [f64; 3]) -> Touch {
    let contact = Contact::new(at, closing).tangent([0.0, 1.0, 0.0]).name("jaw").series_stiffness(1e5, 1e5);
    Touch::new(Pad::rectangle([0.02, 0.03], [1, 1]).expect("a rectangle"), contact)
}

#[test]
fn a_pad_that_misses_says_so() {
    let part = bracket_in_metres();
    for (at, closing) in [([-0.01, 0.06, 0.015], [1.0, 0.0, 0.0]), ([-0.01, 0.025, 0.015], [-1.0, 0.0, 0.0])]
    {
        let error = jaw(at, closing).on(&part).expect_err("misses");
        let Error::Misses { contact, fault } = error else { panic!("{error}") };
        assert!(contact.to_string() == "0 (jaw)" && fault.starts_with("misses"), "{contact}: {fault}");
    }
}

#[test]
fn a_pad_that_begins_inside_says_so() {
    let error = jaw([0.003, 0.025, 0.015], [1.0, 0.0, 0.0]).on(&bracket_in_metres()).expect_err("inside");
    let Error::Misses { contact, fault } = error else { panic!("{error}") };
    assert!(contact.to_string() == "0 (jaw)" && fault.starts_with("begins inside"), "{contact}: {fault}");
}

/// A pad may start in contact with the face.
#[test]
fn a_pad_that_lies_on_the_part_touches_at_once() {
    let touched = jaw([0.0, 0.025, 0.015], [1.0, 0.0, 0.0]).on(&bracket_in_metres()).expect("touches");
    assert_eq!(touched.missing(), 0.0);
    assert!(touched.contacts().iter().all(|contact| contact.point()[0].abs() < 1e-17));
}

#[test]
fn numbers_out_of_range_are_named() {
    let part = bracket_in_metres();
    let of_layer = |modulus| {
        let pad = Pad::rectangle([0.02, 0.03], [1, 1]).expect("a rectangle").of_layer(modulus, 0.003);
        Touch::new(pad, Contact::new([-0.01, 0.025, 0.015], [1.0, 0.0, 0.0])).on(&part)
    };
    assert!(of_layer(2e6).is_ok());
    for modulus in [0.0, -1.0, f64::NAN] {
        assert!(
            matches!(of_layer(modulus), Err(Error::Contact { field: Field::FingerStiffness, .. })),
            "{modulus}"
        );
    }
    assert!(matches!(Pad::cylinder(0.01, [0.02, 0.03], [1, 1]), Err(Error::Fingertip { .. })));
    assert!(matches!(Pad::v(0.05, [0.02, 0.03], [1, 1]), Err(Error::Fingertip { .. })));
    assert!(matches!(Pad::disc(0.0, 1, 4), Err(Error::Fingertip { .. })));
    assert!(matches!(bracket_in_metres().of_mass(-1.0), Err(Error::Argument { .. })));
}

/// A constant force acts along one normal, so all points must have this normal.
#[test]
fn a_constant_force_needs_a_flat_face() {
    let flat = Contact::new([-0.03, 0.025, 0.015], [1.0, 0.0, 0.0]).series_stiffness(1e5, 1e5).force(40.0);
    let pad = Pad::rectangle([0.02, 0.03], [1, 1]).expect("a rectangle");
    assert!(Touch::new(pad.clone(), flat.clone()).on(&bracket_in_metres()).is_ok());
    let error = Touch::new(pad, flat).on(&part(&round(0.02, 96, 0.08))).expect_err("round");
    assert!(matches!(error, Error::Contact { field: Field::Force, .. }), "{error}");
}
