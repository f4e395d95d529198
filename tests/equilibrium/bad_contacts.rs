//! Invalid contacts: in a valid grasp one number at a time is replaced by a bad one.
//!
//! Each fault returns a typed error with the contact, the field, the value, and the beginning of the allowed range.

use crate::valid::{NOT_FINITE, NOT_MODERATE, equal_or_both_nan, planar_contacts, spatial_contacts};
use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::Contact;
use grasp_lcp::{ContactLabel, Error, Field, planar, spatial};
use support::facts;

const USABLE: &str = "from 1e-50 to 1e50 (";
const MODERATE: &str = "finite and";
const SOME_LENGTH: &str = "of positive, finite";
const NOT_ALONG: &str = "finite and not";
const POSITIVE: &str = "positive (infinite";

/// The array with its entry at the index `at` replaced by `value`.
fn with<const N: usize>(mut array: [f64; N], at: usize, value: f64) -> [f64; N] {
    array[at] = value;
    array
}

/// Checks that the valid grasp with a bad second contact is refused for this reason.
fn refused<const C: usize>(
    mut contacts: Vec<Contact<C>>,
    broken: impl FnOnce(Contact<C>) -> Contact<C>,
    field: Field,
    value: f64,
    allowed: &str,
) {
    assert!(Grasp::<C>::new(contacts.clone()).is_ok());
    contacts[1] = broken(contacts[1].clone());
    let error = Grasp::<C>::new(contacts).unwrap_err();
    match &error {
        Error::Contact { contact, field: named, value: shown, allowed: said } => {
            assert_eq!(
                *contact,
                ContactLabel { index: 1, point: None, name: Some("thumb".into()), link: None }
            );
            assert_eq!(*named, field);
            assert!(equal_or_both_nan(*shown, value), "{error} {shown} {value}");
            assert!(said.starts_with(allowed), "{error}");
        }
        other => panic!("{other}"),
    }
}

fn refused_in_plane(
    broken: impl FnOnce(planar::Contact) -> planar::Contact,
    field: Field,
    value: f64,
    allowed: &str,
) {
    refused::<2>(planar_contacts(), broken, field, value, allowed);
}

fn refused_in_space(
    broken: impl FnOnce(spatial::Contact) -> spatial::Contact,
    field: Field,
    value: f64,
    allowed: &str,
) {
    refused::<3>(spatial_contacts(), broken, field, value, allowed);
}

/// The second contact of the valid planar grasp, with another point and another normal.
fn planar_at(point: [f64; 2], normal: [f64; 2]) -> planar::Contact {
    planar::Contact::new(point, normal).name("thumb").series_stiffness(10.0, 10.0).friction(0.5)
}

fn spatial_at(point: [f64; 3], normal: [f64; 3]) -> spatial::Contact {
    spatial::Contact::new(point, normal).name("thumb").series_stiffness(10.0, 10.0).friction(0.5)
}

#[test]
fn an_empty_grasp() {
    for error in [planar::Grasp::new([]).unwrap_err(), spatial::Grasp::new([]).unwrap_err()] {
        assert_eq!(error, Error::EmptyGrasp);
    }
}

#[test]
fn the_point_is_not_finite_or_absurd() {
    for value in NOT_MODERATE {
        for axis in 0..2 {
            let point = with([1.0, 0.5], axis, value);
            refused_in_plane(|_| planar_at(point, [-1.0, 0.0]), Field::Point, value, MODERATE);
        }
        for axis in 0..3 {
            let point = with([1.0, 0.5, 0.2], axis, value);
            refused_in_space(|_| spatial_at(point, [-1.0, 0.0, 0.0]), Field::Point, value, MODERATE);
        }
    }
}

#[test]
fn the_normal_is_not_finite() {
    let allowed = SOME_LENGTH;
    for value in NOT_FINITE {
        for axis in 0..2 {
            let normal = with([-1.0, 0.5], axis, value);
            refused_in_plane(|_| planar_at([1.0, 0.5], normal), Field::Normal, value, allowed);
        }
        for axis in 0..3 {
            let normal = with([-1.0, 0.5, 0.2], axis, value);
            refused_in_space(|_| spatial_at([1.0, 0.5, 0.0], normal), Field::Normal, value, allowed);
        }
    }
}

#[test]
fn the_normal_has_no_length() {
    let allowed = SOME_LENGTH;
    for zero in [0.0, -0.0] {
        refused_in_plane(|_| planar_at([1.0, 0.5], [zero; 2]), Field::Normal, 0.0, allowed);
        refused_in_space(|_| spatial_at([1.0, 0.5, 0.0], [zero; 3]), Field::Normal, 0.0, allowed);
    }
}

#[test]
fn the_tangent_is_not_finite() {
    for value in NOT_FINITE {
        for axis in 0..2 {
            let tangent = with([0.0, 1.0], axis, value);
            let allowed = NOT_ALONG;
            refused_in_plane(|c| c.tangent(tangent), Field::Tangent, value, allowed);
        }
        for axis in 0..3 {
            let tangent = with([0.0, 0.0, 1.0], axis, value);
            refused_in_space(|c| c.tangent(tangent), Field::Tangent, value, SOME_LENGTH);
        }
    }
}

#[test]
fn the_tangent_points_along_the_normal() {
    for length in [-2.0_f64, 0.0, 3.0] {
        let allowed = NOT_ALONG;
        refused_in_plane(|c| c.tangent([length, 0.0]), Field::Tangent, length.abs(), allowed);
    }
    for length in [-2.0, 3.0] {
        let broken = |_| spatial_at([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]).tangent([length, 0.0, 0.0]);
        refused_in_space(broken, Field::Tangent, length.abs(), "not along");
    }
    refused_in_space(|c| c.tangent([0.0; 3]), Field::Tangent, 0.0, SOME_LENGTH);
}

#[test]
fn the_body_stiffness_is_not_positive() {
    let allowed = POSITIVE;
    for value in [f64::NAN, f64::NEG_INFINITY, -3.0, -0.0, 0.0] {
        refused_in_plane(|c| c.body_stiffness(value, 80.0), Field::BodyStiffness, value, allowed);
        refused_in_plane(|c| c.body_stiffness(100.0, value), Field::BodyStiffness, value, allowed);
        for axis in 0..3 {
            let axes = with([100.0, 80.0, 60.0], axis, value);
            refused_in_space(|c| c.body_stiffness_axes(axes), Field::BodyStiffness, value, allowed);
        }
    }
}

#[test]
fn the_finger_stiffness_is_not_positive() {
    let allowed = POSITIVE;
    for value in [f64::NAN, f64::NEG_INFINITY, -3.0, -0.0, 0.0] {
        refused_in_plane(|c| c.finger_stiffness(value, 80.0), Field::FingerStiffness, value, allowed);
        refused_in_plane(|c| c.finger_stiffness(100.0, value), Field::FingerStiffness, value, allowed);
        for axis in 0..3 {
            let axes = with([100.0, 80.0, 60.0], axis, value);
            refused_in_space(|c| c.finger_stiffness_axes(axes), Field::FingerStiffness, value, allowed);
        }
    }
}

#[test]
fn the_series_stiffness_is_not_positive() {
    for value in [f64::NAN, f64::NEG_INFINITY, -3.0, 0.0] {
        let allowed = "positive and finite";
        refused_in_plane(|c| c.series_stiffness(value, 80.0), Field::SeriesStiffness, value, allowed);
        refused_in_plane(|c| c.series_stiffness(100.0, value), Field::SeriesStiffness, value, allowed);
        for axis in 0..3 {
            let axes = with([100.0, 80.0, 60.0], axis, value);
            refused_in_space(|c| c.series_stiffness_axes(axes), Field::SeriesStiffness, value, allowed);
        }
    }
}

#[test]
fn both_sides_are_rigid() {
    let (rigid, allowed) = (f64::INFINITY, USABLE);
    refused_in_plane(|c| c.series_stiffness(rigid, 1.0), Field::SeriesStiffness, rigid, allowed);
    refused_in_plane(
        |c| c.body_stiffness(rigid, 1.0).finger_stiffness(rigid, 1.0),
        Field::SeriesStiffness,
        rigid,
        allowed,
    );
    refused_in_space(
        |c| c.body_stiffness(1.0, rigid).finger_stiffness(1.0, rigid),
        Field::SeriesStiffness,
        rigid,
        allowed,
    );
    // A missing stiffness is refused in the same way.
    let said_nothing = |_| planar::Contact::new([1.0, 0.5], [-1.0, 0.0]).name("thumb").friction(0.5);
    refused_in_plane(said_nothing, Field::SeriesStiffness, rigid, allowed);
}

#[test]
fn one_rigid_side_is_no_fault() {
    for (body, finger) in [(f64::INFINITY, 40.0), (40.0, f64::INFINITY)] {
        let mut contacts = planar_contacts();
        contacts[1] = contacts[1].clone().body_stiffness(body, body).finger_stiffness(finger, finger);
        assert!(planar::Grasp::new(contacts).is_ok());
    }
}

#[test]
fn without_friction_the_tangential_stiffness_may_be_rigid() {
    let mut contacts = planar_contacts();
    contacts[1] = planar_at([1.0, 0.5], [-1.0, 0.0]).friction(0.0).series_stiffness(5.0, f64::INFINITY);
    assert!(planar::Grasp::new(contacts).is_ok());
}

#[test]
fn the_friction_is_out_of_range() {
    for value in [f64::NAN, -0.5, f64::NEG_INFINITY, -f64::MIN_POSITIVE, 1.1e50] {
        let allowed = "from 0 to 1e50";
        refused_in_plane(|c| c.friction(value), Field::Friction, value, allowed);
        refused_in_space(|c| c.friction(value), Field::Friction, value, allowed);
    }
}

#[test]
fn infinite_friction_is_no_fault() {
    let contacts = planar_contacts().into_iter().map(|c| c.friction(f64::INFINITY));
    assert!(planar::Grasp::new(contacts).is_ok());
}

#[test]
fn the_command_is_not_finite_or_absurd() {
    for value in NOT_MODERATE {
        for axis in 0..2 {
            let command = with([0.1, 0.0], axis, value);
            refused_in_plane(|c| c.command(command), Field::Command, value, MODERATE);
            refused_in_plane(|c| c.command_world(command), Field::Command, value, MODERATE);
        }
        for axis in 0..3 {
            let command = with([0.1, 0.0, 0.2], axis, value);
            refused_in_space(|c| c.command(command), Field::Command, value, MODERATE);
            refused_in_space(|c| c.command_world(command), Field::Command, value, MODERATE);
        }
    }
}

#[test]
fn the_clearance_is_not_finite_or_absurd() {
    for value in NOT_MODERATE {
        refused_in_plane(|c| c.clearance(value), Field::Clearance, value, MODERATE);
        refused_in_space(|c| c.clearance(value), Field::Clearance, value, MODERATE);
    }
}

#[test]
fn a_contact_without_a_name_goes_by_its_index() {
    let mut contacts = planar_contacts();
    contacts[2] = contacts[2].clone().friction(-1.0);
    let error = planar::Grasp::new(contacts).unwrap_err();
    assert_eq!(facts(&error), ["2", "friction coefficient", "-1"]);
}
