//! Malformed soft fingertips are refused with typed errors, and errors in contacts report the values that the caller gave.

use crate::pinch::{KN, KT, R, finger};
use grasp_lcp::spatial::{Contact, Pressure, SoftFingertip};
use grasp_lcp::{Error, planar};
use support::facts;

#[test]
fn malformed_fingertips_are_refused() {
    let refused = |error: Result<(), Error>, what: &str, value: f64, allowed: &str| {
        let error = error.expect_err(what);
        let Error::Fingertip { what: named, value: shown, allowed: said } = error else {
            panic!("{error:?}")
        };
        assert!(named == what && said == allowed && (shown == value || shown.is_nan() && value.is_nan()));
    };
    let disc = |r, annuli, points| SoftFingertip::disc(r, annuli, points, Pressure::Hertz).map(drop);
    let pad = |w, strips| planar::SoftFingertip::pad(w, strips, Pressure::Uniform).map(drop);
    for bad in [0.0, -0.0, -1.0, 1e-51, 1.1e50, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let sizes = "from 1e-50 to 1e50";
        refused(SoftFingertip::ring(bad, 6).map(drop), "radius", bad, sizes);
        refused(disc(bad, 2, 6), "radius", bad, sizes);
        refused(planar::SoftFingertip::pair(bad).map(drop), "width", bad, sizes);
        refused(pad(bad, 3), "width", bad, sizes);
    }
    for few in [0_u8, 1, 2] {
        let (points, shown) = (usize::from(few), f64::from(few));
        for ring in [SoftFingertip::ring(R, points).map(drop), disc(R, 1, points)] {
            let [_, what, value] = facts(&ring.unwrap_err());
            assert!(what.ends_with("on a ring") && value == shown.to_string(), "{what} {value}");
        }
    }
    refused(disc(R, 0, 6), "number of annuli", 0.0, "at least 1");
    refused(pad(R, 0), "number of strips", 0.0, "at least 1");
    let most = SoftFingertip::MOST_POINTS;
    let too_many = "at most 4096";
    assert_eq!(format!("at most {most}"), too_many);
    assert_eq!(SoftFingertip::ring(R, most).unwrap().points().len(), most);
    assert!(disc(R, most / 8, 4).is_ok() && pad(R, most / 4).is_ok());
    refused(SoftFingertip::ring(R, most + 1).map(drop), "number of points", 4097.0, too_many);
    refused(disc(R, most / 8, 5), "number of points", 5120.0, too_many);
    refused(pad(R, most / 4 + 1), "number of points", 4100.0, too_many);
    for huge in [usize::MAX, usize::MAX / 2 + 1] {
        assert!(
            SoftFingertip::ring(R, huge).is_err() && disc(R, huge, 4).is_err() && disc(R, 4, huge).is_err()
        );
        assert!(pad(R, huge).is_err());
    }
}

/// A contact is validated before its data are distributed over points.
#[test]
fn broken_contacts_are_named_as_given() {
    let tip = SoftFingertip::ring(R, 6).unwrap();
    let broken = finger(1.0).finger_stiffness(-10.0, KT);
    let refused = |contact: &Contact| facts(&tip.contacts(contact).unwrap_err());
    assert_eq!(refused(&broken), ["0 (right)", "finger stiffness", "-10"]);
    let flat = Contact::new([0.0; 3], [0.0; 3]).series_stiffness(KN, KT);
    assert_eq!(refused(&flat)[1..], ["normal", "0"]);
    let along = finger(1.0).tangent([1.0, 0.0, 0.0]);
    assert_eq!(refused(&along)[1..], ["tangent", "1"]);
}
