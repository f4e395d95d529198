//! No input causes a panic, an endless loop or a false success.
#![allow(clippy::doc_markdown)]

use grasp_lcp::lcp::{Basis, Lcp, LcpError, Outcome, Parametric, Series, Settings};
use nalgebra::{DMatrix, DVector};
use proptest::collection::vec;
use proptest::prelude::*;
use support::samples::config;

/// A number with random bits: also infinities, NaN, subnormal numbers and extreme exponents.
fn any_bits() -> impl Strategy<Value = f64> + Clone {
    any::<u64>().prop_map(f64::from_bits)
}

/// Finite numbers of all sizes, many of them 0, ±1 or equal.
fn any_finite() -> impl Strategy<Value = f64> + Clone {
    prop_oneof![
        3 => (-3_i32..4).prop_map(f64::from),
        2 => -1.0..1.0_f64,
        1 => (-1.0..1.0_f64, -300_i32..300).prop_map(|(m, e)| m * 10.0_f64.powi(e)),
        1 => any_bits().prop_map(|x| if x.is_finite() { x } else { 0.0 }),
    ]
}

/// Numbers of moderate size, with many ties.
fn moderate() -> impl Strategy<Value = f64> + Clone {
    prop_oneof![2 => (-3_i32..4).prop_map(f64::from), 1 => -1.0..1.0_f64]
}

fn problem(
    entry: impl Strategy<Value = f64> + Clone,
    largest: usize,
) -> impl Strategy<Value = (DMatrix<f64>, DVector<f64>)> {
    (0..=largest).prop_flat_map(move |n| {
        (vec(entry.clone(), n * n), vec(entry.clone(), n))
            .prop_map(move |(m, q)| (DMatrix::from_vec(n, n, m), DVector::from_vec(q)))
    })
}

/// Checks all claims of an outcome, without the arithmetic of the library.
fn check(lcp: &Lcp, outcome: &Outcome) -> Result<(), TestCaseError> {
    let (m, q) = (lcp.matrix(), lcp.vector());
    match outcome {
        Outcome::Solved(solution) => {
            let z = &solution.z;
            prop_assert_eq!(z.len(), q.len());
            prop_assert!(z.iter().chain(&solution.w).all(|x| x.is_finite() && *x >= 0.0));
            for i in 0..q.len() {
                let terms: f64 = q[i].abs() + (0..q.len()).map(|j| (m[(i, j)] * z[j]).abs()).sum::<f64>();
                let w: f64 = q[i] + (0..q.len()).map(|j| m[(i, j)] * z[j]).sum::<f64>();
                prop_assert!(w >= -2e-10 * terms, "w_{i} = {w} of terms {terms}");
                if solution.basis.contains(i) {
                    prop_assert!(
                        w.abs() <= 2e-10 * terms || z[i] == 0.0,
                        "w_{i} = {w} of terms {terms}, z_i = {}",
                        z[i]
                    );
                    prop_assert_eq!(solution.w[i], 0.0);
                } else {
                    prop_assert_eq!(z[i], 0.0);
                }
            }
        }
        Outcome::Ray(ray) => {
            prop_assert!(ray.direction.iter().all(|x| x.is_finite() && *x >= 0.0));
        }
        Outcome::Infeasible(certificate) => prop_assert!(lcp.proves_infeasible(&certificate.y)),
        _ => {}
    }
    Ok(())
}

proptest! {
    #![proptest_config(config(300))]

    #[test]
    fn malformed_input_is_an_error_and_the_rest_is_a_problem(
        rows in 0_usize..4,
        columns in 0_usize..4,
        length in 0_usize..4,
        entries in vec(any_bits(), 16),
    ) {
        let m = DMatrix::from_fn(rows, columns, |i, j| entries[4 * i + j]);
        let q = DVector::from_fn(length, |i, _| entries[12 + i]);
        let finite = m.iter().chain(&q).all(|x| x.is_finite());
        match Lcp::new(m, q) {
            Ok(lcp) => {
                prop_assert!(rows == columns && rows == length && finite);
                check(&lcp, &lcp.solve())?;
            }
            Err(LcpError::NotSquare { .. }) => prop_assert!(rows != columns),
            Err(LcpError::Length { .. }) => prop_assert!(rows == columns && rows != length),
            Err(error) => prop_assert!(!finite, "{}", error),
        }
    }

    #[test]
    fn finite_problems_of_any_size_end_without_wrong_success((m, q) in problem(any_finite(), 6)) {
        let lcp = Lcp::new(m, q).unwrap();
        check(&lcp, &lcp.solve())?;
        let _ = lcp.has_p_matrix();
    }

    #[test]
    fn moderate_problems_end_in_an_answer((m, q) in problem(moderate(), 8)) {
        let lcp = Lcp::new(m, q).unwrap();
        let outcome = lcp.solve();
        check(&lcp, &outcome)?;
        let answered = outcome.solution().is_some() || outcome.is_infeasible();
        prop_assert!(answered || matches!(outcome, Outcome::NoBasis { .. }), "{}", outcome);
    }

    #[test]
    fn any_covering_vector_and_any_limit_are_endured(
        (m, q) in problem(moderate(), 5),
        covering in vec(any_bits(), 0..6),
        max_pivots in 0_usize..30,
        tolerances in vec(any_bits(), 3),
    ) {
        let lcp = Lcp::new(m, q).unwrap();
        let settings = Settings::default().with_covering(DVector::from_vec(covering)).with_max_pivots(max_pivots);
        check(&lcp, &lcp.solve_with(&settings))?;
        let mut settings = Settings::default();
        [settings.pivot_tolerance, settings.tie_tolerance] = [tolerances[0], tolerances[1]];
        check(&lcp, &lcp.solve_with(&settings))?;
    }

    #[test]
    fn any_basis_is_a_start((m, q) in problem(moderate(), 6), alpha in vec(0_usize..8, 0..6)) {
        let lcp = Lcp::new(m, q).unwrap();
        for n in [lcp.len(), 3] {
            check(&lcp, &lcp.solve_from(&Basis::from_indices(n, alpha.iter().copied()), &Settings::default()))?;
        }
    }

    #[test]
    fn a_series_and_a_parametric_path_say_nothing_wrong((m, q) in problem(any_finite(), 5), seed in vec(moderate(), 5)) {
        let lcp = Lcp::new(m.clone(), q.clone()).unwrap();
        let other = DVector::from_fn(q.len(), |i, _| seed[i]);
        let mut series = Series::new(m.clone(), Settings::default()).unwrap();
        for q in [&q, &other, &q] {
            let problem = Lcp::new(m.clone(), q.clone()).unwrap();
            check(&problem, &series.solve(q).unwrap().into_outcome())?;
        }
        let mut path = Parametric::new(&lcp, &other, Settings::default().with_max_pivots(50)).unwrap();
        check(&lcp, path.start())?;
        prop_assert!(path.by_ref().count() <= 50);
        prop_assert!(path.end().is_some());
    }
}
