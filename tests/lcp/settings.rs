//! Invalid settings are refused with an error that names them, for every problem.

use grasp_lcp::lcp::{Basis, BreakdownCause, Lcp, Outcome, Settings, Workspace};
use nalgebra::{DMatrix, DVector};

fn cause(outcome: Outcome) -> BreakdownCause {
    match outcome {
        Outcome::Breakdown { pivots: 0, cause } => cause,
        other => panic!("{other:?}"),
    }
}

#[test]
fn covering_vectors_and_tolerances_that_do_not_fit_are_refused() {
    // Invalid settings are refused also if q ≥ 0, where z = 0 is the solution and no path is followed.
    for q in [[1.0, 2.0], [-1.0, 2.0]] {
        let lcp = Lcp::new(DMatrix::identity(2, 2), DVector::from_row_slice(&q)).expect("finite");
        let all = |settings: &Settings| {
            let mut workspace = Workspace::new();
            [
                lcp.solve_with(settings),
                lcp.solve_from(&Basis::from_indices(2, [0]), settings),
                workspace.solve(&lcp, settings).into_outcome(),
            ]
            .map(cause)
        };
        let covering = |d: &[f64]| Settings::default().with_covering(DVector::from_row_slice(d));
        for told in all(&covering(&[1.0])) {
            assert_eq!(told, BreakdownCause::CoveringLength { given: 1, needed: 2 });
        }
        for told in all(&covering(&[1.0, f64::NAN])) {
            assert!(matches!(told, BreakdownCause::CoveringEntry { row: 1, value } if value.is_nan()));
        }
        for bad in [f64::NAN, f64::INFINITY, -1e-9] {
            let mut settings = Settings::default();
            settings.residual_tolerance = bad;
            for told in all(&settings) {
                assert!(
                    matches!(told, BreakdownCause::Tolerance { name: "residual_tolerance", value } if value.to_bits() == bad.to_bits()),
                    "{told:?}"
                );
            }
        }
    }
}
