//! Malformed input returns an error with its place.

use grasp_lcp::friction::{Error, Settings, SpatialContacts};
use grasp_lcp::lcp::{BreakdownCause, LcpError, Outcome};
use nalgebra::{DMatrix, DVector};

#[test]
fn errors_name_the_place() {
    let error = |w: DMatrix<f64>, q: Vec<f64>, mu: Vec<f64>| {
        SpatialContacts::new(w, DVector::from_vec(q), mu).unwrap_err()
    };
    let eye = || DMatrix::identity(3, 3);
    let short = LcpError::Length { what: "q", given: 2, needed: 3 };
    assert_eq!(error(eye(), vec![0.0; 2], vec![0.5]), Error::Numbers(short));
    let small = LcpError::BlockShape { what: "W", rows: 3, columns: 3, needed_rows: 6, needed_columns: 6 };
    assert_eq!(error(eye(), vec![0.0; 6], vec![0.5; 2]), Error::Numbers(small));
    assert_eq!(error(eye(), vec![0.0; 3], vec![-0.5]), Error::Friction { contact: 0, value: -0.5 });
    let nothing = error(eye() * f64::NAN, vec![0.0; 3], vec![0.5]);
    let Error::Numbers(LcpError::MatrixEntry { what: "W", row: 0, column: 0, value }) = nothing else {
        panic!("{nothing}")
    };
    assert!(value.is_nan());
}

#[test]
fn nothing_is_solved_by_forces_that_do_not_fit() {
    let problem = SpatialContacts::new(DMatrix::identity(3, 3), DVector::zeros(3), vec![0.5]).unwrap();
    assert_eq!(problem.residuals(&DVector::zeros(2)).max(), f64::INFINITY);
    assert_eq!(problem.residuals(&DVector::from_element(3, f64::NAN)).max(), f64::INFINITY);
    let empty = SpatialContacts::new(DMatrix::zeros(0, 0), DVector::zeros(0), vec![]).unwrap();
    assert!(empty.solve().solution().is_some());
}

#[test]
fn settings_that_do_not_fit_solve_nothing() {
    let q = DVector::from_vec(vec![-1.0, 2.0, 0.5]);
    let problem = SpatialContacts::new(DMatrix::identity(3, 3), q, vec![0.5]).unwrap();
    for tolerance in [f64::NAN, -1.0, f64::INFINITY] {
        let outcome = problem.solve_with(&Settings::default().with_tolerance(tolerance));
        let Outcome::Breakdown { cause: BreakdownCause::Tolerance { name, .. }, .. } = outcome else {
            panic!("{outcome}")
        };
        assert_eq!(name, "tolerance");
    }
    for facets in [0, 1, usize::MAX] {
        let outcome = problem.solve_with(&Settings::default().with_facets(facets));
        assert!(outcome.solution().is_some(), "{outcome}");
        assert!(problem.facets(facets).unwrap().forces(&DVector::zeros(2)).is_err());
    }
}
