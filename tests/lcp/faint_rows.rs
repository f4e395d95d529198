//! A row whose terms are smaller than the least positive double is tested like any other row.

use grasp_lcp::lcp::{Lcp, Outcome};
use nalgebra::{DMatrix, DVector};

fn problem(n: usize, rows: &[f64], q: &[f64]) -> Lcp {
    Lcp::new(DMatrix::from_row_slice(n, n, rows), DVector::from_row_slice(q)).expect("finite")
}

#[test]
fn a_slack_beside_a_positive_unknown_is_seen_whatever_its_size() {
    // w = M z is 1e-400, which underflows, while z is 1e-200: so z and w are not complementary.
    let alone = problem(1, &[1e-200], &[0.0]).residuals(&DVector::from_element(1, 1e-200));
    assert_eq!((alone.complementarity, alone.negative_w), (1.0, 0.0));
    // w₁ = (f − 1) 1e-400, from terms with the sum of sizes (f + 1) 1e-400. `part` is the negative part of w₁ relative to this sum.
    for (f, part) in [(0.5, 1.0 / 3.0), (1.0, 0.0), (0.25, 0.6)] {
        let rows = [f * 1e-200, -1e-200, 0.0, 1.0];
        let residuals = problem(2, &rows, &[0.0, -1e-200]).residuals(&DVector::from_element(2, 1e-200));
        assert!((residuals.negative_w - part).abs() < 1e-15, "{residuals:?}");
    }
}

/// Row 1 gives z₂ = 2e-202. Then w₂ = 0 needs z₀ = 4e-465, less than the least positive double, or a z₁ that compensates a larger z₀.
fn with_entry(entry: f64) -> Lcp {
    let rows = [
        [-2e-24, 0.0, -1e118, 1e43],
        [0.0, 0.0, 1e78, 1e59],
        [-1e114, entry, 2e-149, 0.0],
        [1e124, 1e56, 0.0, 2e-85],
    ];
    problem(4, rows.as_flattened(), &[2e-46, -2e-124, 0.0, 2e-81])
}

#[test]
fn an_unknown_below_the_smallest_number_is_not_taken_for_zero() {
    // No doubles satisfy this problem.
    let outcome = with_entry(0.0).solve();
    assert!(!matches!(outcome, Outcome::Solved(_)), "{outcome}");
    assert!(!outcome.is_infeasible(), "{outcome}");
}

#[test]
fn another_basis_without_such_an_unknown_is_found() {
    let outcome = with_entry(1e-111).solve();
    let solution = outcome.solution().unwrap_or_else(|| panic!("{outcome}"));
    for (z, expected) in solution.z.iter().zip([1e-22, 1e203, 2e-202]) {
        assert!((z / expected - 1.0).abs() < 1e-15, "{z} {expected}");
    }
    assert_eq!(solution.z[3], 0.0);
}
