//! Invalid questions to a valid grasp: one bad number at a time in loads, commands and settings.
//!
//! Each fault returns a typed error with the place and the value.

use crate::valid::{NOT_MODERATE, equal_or_both_nan, planar_contacts, spatial_contacts};
use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::Wrench;
use grasp_lcp::load_path::Ramp;
use grasp_lcp::{Error, Field, PolygonCone, PolygonFit, Settings, planar, spatial};
use nalgebra::SVector;
use support::facts;

#[test]
fn new_commands_are_not_finite_or_not_one_a_contact() {
    let grasp = planar::Grasp::new(planar_contacts()).unwrap();
    for given in [0, 2, 4] {
        let error = grasp.clone().with_commands(vec![[0.1, 0.0]; given]).unwrap_err();
        assert_eq!(error, Error::Size { what: "commands", given, expected: 3 });
    }
    for value in NOT_MODERATE {
        let commands = [[0.1, 0.0], [0.1, value], [0.1, 0.0]].map(SVector::from);
        let error = grasp.clone().with_commands(commands).unwrap_err();
        assert_eq!(facts(&error), ["1 (thumb)".to_owned(), "command".to_owned(), value.to_string()]);
        assert!(matches!(error, Error::Contact { field: Field::Command, .. }));
    }
}

#[test]
fn command_changes_are_not_finite_or_not_one_a_contact() {
    let grasp = spatial::Grasp::new(spatial_contacts()).unwrap();
    for given in [0, 2, 4] {
        let change = vec![SVector::from([0.1, 0.0, 0.0]); given];
        let error = grasp.onset(Ramp::commands(Wrench::ZERO, change)).unwrap_err();
        assert_eq!(error, Error::Size { what: "command changes", given, expected: 3 });
    }
    for value in NOT_MODERATE {
        let change = [[0.1, 0.0, 0.0], [0.1, 0.0, value], [0.0; 3]].map(SVector::from);
        let error = grasp.onset(Ramp::commands(Wrench::ZERO, change)).unwrap_err();
        assert_eq!(
            facts(&error),
            ["1 (thumb)".to_owned(), "change of command".to_owned(), value.to_string()]
        );
        assert!(matches!(error, Error::Contact { field: Field::CommandChange, .. }));
    }
}

/// The error of every question with a wrench names the wrench, the component and the value.
fn wrench_refused<const D: usize, const C: usize>(grasp: &Grasp<C>) {
    for value in NOT_MODERATE {
        for component in 0..D {
            let mut w = SVector::<f64, D>::zeros();
            w[component] = value;
            let (bad, settings) = (Wrench::from_components(w.as_slice()), Settings::default());
            let onset = |base, direction| grasp.onset(Ramp::load(base, direction)).unwrap_err();
            for (what, error) in [
                ("load", grasp.solve(bad).unwrap_err()),
                ("load", grasp.with(&settings).equilibria(bad).unwrap_err()),
                ("base load", onset(bad, Wrench::ZERO)),
                ("load direction", onset(Wrench::ZERO, bad)),
            ] {
                let Error::Wrench { what: named, component: at, value: shown } = error else {
                    panic!("{error:?}")
                };
                assert!(named == what && at == component && equal_or_both_nan(shown, value));
            }
        }
    }
}

#[test]
fn the_load_is_not_finite_or_absurd() {
    wrench_refused::<3, 2>(&planar::Grasp::new(planar_contacts()).unwrap());
    wrench_refused::<6, 3>(&spatial::Grasp::new(spatial_contacts()).unwrap());
}

#[test]
fn a_friction_polygon_with_too_few_or_too_many_facets() {
    let most = PolygonCone::MOST_FACETS;
    for given in [0, 1, 2, most + 1, usize::MAX] {
        let error = PolygonCone::new(given, PolygonFit::Inscribed).unwrap_err();
        assert_eq!(error, Error::Facets { given, most });
    }
    assert_eq!(PolygonCone::new(3, PolygonFit::Balanced).unwrap().facets(), 3);
}

#[test]
fn too_many_combinations_to_list() {
    let grasp = planar::Grasp::new(planar_contacts()).unwrap();
    let error = grasp.with(&Settings::default().with_most_states(63)).equilibria(Wrench::ZERO).unwrap_err();
    assert_eq!(error, Error::TooManyStates { contacts: 3, combinations: 64.0, most: 63 });

    assert!(grasp.with(&Settings::default().with_most_states(64)).equilibria(Wrench::ZERO).is_ok());
}
