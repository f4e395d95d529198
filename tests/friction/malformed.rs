//! Malformed input is an error that names the place.

use grasp_lcp::friction::{Settings, SpatialContacts};
use grasp_lcp::lcp::{BreakdownCause, Outcome};
use nalgebra::{DMatrix, DVector};

#[test]
fn messages_name_the_place() {
    let message = |w: DMatrix<f64>, q: Vec<f64>, mu: Vec<f64>| {
        SpatialContacts::new(w, DVector::from_vec(q), mu).unwrap_err().to_string()
    };
    let eye = || DMatrix::identity(3, 3);
    assert_eq!(message(eye(), vec![0.0; 2], vec![0.5]), "q has 2 entries, but the problem has 3 rows");
    assert_eq!(
        message(eye(), vec![0.0; 6], vec![0.5; 2]),
        "block W has 3 rows and 3 columns, but must have 6 and 6"
    );
    assert_eq!(
        message(eye(), vec![0.0; 3], vec![-0.5]),
        "friction of contact 0 is -0.5, but must be finite and not negative"
    );
    assert_eq!(
        message(eye() * f64::NAN, vec![0.0; 3], vec![0.5]),
        "entry (0, 0) of W is NaN, not a finite number"
    );
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
