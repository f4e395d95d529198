//! P-matrices. If the matrix M of a problem 0 ≤ z ⟂ w = M z + q ≥ 0 is one, every q has exactly one solution.

use super::problem::Lcp;
use super::tolerances::{ELIMINATED_PIVOT, elimination_rounding};
use crate::numerics::{Reals, any_index, every_index, matrix_of};
#[cfg(not(feature = "std"))]
use crate::prelude::*;
use nalgebra::DMatrix;

impl Lcp {
    /// Whether M is a P-matrix, which means that all its principal minors are positive. Then there is exactly one solution for every q (Cottle, Pang
    /// & Stone, *The Linear Complementarity Problem*, 1992, theorem 3.3.7), and Lemke's method finds it. `None` if undecided (then n > 12).
    ///
    /// Definiteness, diagonal dominance or signs usually decide this. If they do not, and n ≤ 12, up to 2ⁿ Schur complements are computed (M. J.
    /// Tsatsomeros and L. Li, *A recursive test for P-matrices*, BIT 40, 2000). A pivot counts as positive only above 8 n ε (ε = 2⁻⁵²) times the
    /// diagonal entry of M, in Schur complements above 1e-14 times this entry. If a pivot is near this limit, rounding may decide.
    ///
    /// ```
    /// use grasp_lcp::lcp::Lcp;
    ///
    /// // Not symmetric, but all principal minors are positive: 1, 1 and 3.
    /// assert_eq!(Lcp::from_rows(&[[1.0, -1.0], [2.0, 1.0]], &[0.0, 0.0])?.has_p_matrix(), Some(true));
    /// # Ok::<(), grasp_lcp::lcp::LcpError>(())
    /// ```
    #[must_use]
    pub fn has_p_matrix(&self) -> Option<bool> {
        let m = &self.m;
        let n = m.nrows();
        if any_index(n, &|i| m[(i, i)] <= 0.0) {
            return Some(false);
        }
        let dominant = |i: usize| m.row(i).iter().map(|x| x.abs()).added() < 2.0 * m[(i, i)];
        if is_positive_definite(m) || every_index(n, &dominant) {
            return Some(true);
        }
        if every_index(n, &|j| every_index(n, &|i| i == j || m[(i, j)] <= 0.0)) {
            // A matrix without positive entries off its diagonal is a P-matrix exactly if all pivots of an elimination without exchanges are
            // positive (Cottle, Pang & Stone, theorem 3.11.10).
            let mut a = m.clone();
            for k in 0..n {
                if a[(k, k)] <= elimination_rounding(n) * m[(k, k)] {
                    return Some(false);
                }
                eliminate(&mut a, k);
            }
            return Some(true);
        }
        // Each additional row doubles the number of Schur complements.
        (n <= 12).then(|| minors_are_positive(m.clone(), m))
    }
}

/// Whether zᵀMz > 0 for all z ≠ 0, by Cholesky factorisation of the symmetric part with diagonal pivoting, after scaling to a diagonal of ones. The
/// diagonal of M must be positive.
fn is_positive_definite(m: &DMatrix<f64>) -> bool {
    let n = m.nrows();
    let factor = |i: usize| 1.0 / m[(i, i)].sqrt();
    let mut a = matrix_of(n, n, &|i, j| (0.5 * m[(i, j)] + 0.5 * m[(j, i)]) * factor(i) * factor(j));
    let rounding = elimination_rounding(n);
    for k in 0..n {
        let (pivot, value) = (k..n)
            .fold((k, f64::NEG_INFINITY), |best, i| if a[(i, i)] > best.1 { (i, a[(i, i)]) } else { best });
        if value <= rounding {
            return false;
        }
        a.swap_rows(k, pivot);
        a.swap_columns(k, pivot);
        eliminate(&mut a, k);
    }
    true
}

fn eliminate(a: &mut DMatrix<f64>, k: usize) {
    for i in k + 1..a.nrows() {
        let f = a[(i, k)] / a[(k, k)];
        for j in k + 1..a.nrows() {
            a[(i, j)] -= f * a[(k, j)];
        }
    }
}

/// Whether the matrix `a` is a P-matrix.
///
/// The first entry of `a` must be positive. Two smaller matrices must be P-matrices: `a` without its first row and column, and the Schur complement
/// of the first entry.
///
/// `m` holds the same rows and columns before any elimination. A pivot counts as positive if it exceeds [`ELIMINATED_PIVOT`] (1e-14) times the
/// diagonal entry of `m`.
fn minors_are_positive(mut a: DMatrix<f64>, m: &DMatrix<f64>) -> bool {
    let n = a.nrows();
    if n == 0 {
        return true;
    }
    if a[(0, 0)] <= ELIMINATED_PIVOT * m[(0, 0)] {
        return false;
    }
    let smaller = m.view((1, 1), (n - 1, n - 1)).into_owned();
    let without = a.view((1, 1), (n - 1, n - 1)).into_owned();
    eliminate(&mut a, 0);
    minors_are_positive(without, &smaller)
        && minors_are_positive(a.view((1, 1), (n - 1, n - 1)).into_owned(), &smaller)
}
