//! The classes of a matrix, and what they guarantee for Lemke's method.

use super::error::LcpError;
use super::tolerances::{ELIMINATED_PIVOT, OFF_DIAGONAL, elimination_rounding};
use crate::numerics::matrix_of;
#[cfg(not(feature = "std"))]
use crate::prelude::*;
use nalgebra::DMatrix;

/// The classes to which a matrix M (n × n) belongs, as found by [`MatrixClass::of`].
///
/// The tests are exact up to rounding. A matrix closer to the boundary of a class than 32 n ε (ε = 2⁻⁵²) or 1e-14 of its diagonal may be put on
/// either side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct MatrixClass {
    /// M = Mᵀ, entry by entry.
    pub symmetric: bool,
    /// The sign of zᵀMz for all z; it depends only on the symmetric part (M + Mᵀ)/2.
    pub definiteness: Definiteness,
    /// The sign of zᵀMz for z ≥ 0, as far as the structure of M shows it.
    pub copositivity: Copositivity,
    /// No off-diagonal entry is positive.
    pub z_matrix: bool,
    /// Whether all principal minors are positive; `None` if undecided (then n > 12).
    pub p_matrix: Option<bool>,
}

/// The sign of zᵀMz.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Definiteness {
    /// zᵀMz > 0 for all z ≠ 0.
    PositiveDefinite,
    /// zᵀMz ≥ 0 for all z, with equality for some z ≠ 0.
    PositiveSemidefinite,
    /// zᵀMz < 0 for some z.
    Indefinite,
}

/// The sign of zᵀMz for z ≥ 0, as far as the structure of M shows it. The general decision is as hard as the complementarity problem itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Copositivity {
    /// zᵀMz > 0 for 0 ≠ z ≥ 0: positive definite, or no negative entries and a positive diagonal.
    Strict,
    /// zᵀMz ≥ 0 for z ≥ 0, and z ≥ 0, zᵀMz = 0 imply (M + Mᵀ)z = 0: positive semidefinite.
    Plus,
    /// zᵀMz ≥ 0 for z ≥ 0: the symmetric part is the sum of a positive semidefinite matrix and a matrix without negative entries.
    Plain,
    /// zᵀMz < 0 for some z ≥ 0: a diagonal entry is negative.
    Not,
    /// The structure of M does not show the sign.
    Unknown,
}

/// What Lemke's method achieves for a class of matrices, in exact arithmetic and with d > 0 (Cottle, Pang & Stone, *The Linear Complementarity
/// Problem*, 1992).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Guarantee {
    /// Exactly one solution for every q (theorem 3.3.7), and it is found (4.4.1 with the remark on
    /// P-matrices).
    UniqueSolution,
    /// A solution exists for every q (3.8.5), and one is found.
    Solution,
    /// If any z ≥ 0 satisfies M z + q ≥ 0, a solution is found. A ray proves that no such z exists (4.4.12).
    SolutionIfFeasible,
    /// No guarantee: a ray proves nothing, and there may be several solutions.
    None,
}

impl MatrixClass {
    /// Classifies M (n × n), with up to three eliminations of about 2n³/3 flops each.
    ///
    /// Definiteness, diagonal dominance or signs usually decide whether M is a P-matrix. If they do not, and n ≤ 12, up to 2ⁿ Schur complements
    /// are computed as well (M. J. Tsatsomeros and L. Li, *A recursive test for P-matrices*, BIT 40, 2000).
    ///
    /// ```
    /// use grasp_lcp::lcp::{Definiteness, Guarantee, MatrixClass};
    /// use nalgebra::DMatrix;
    ///
    /// // Not symmetric, but all principal minors are positive: 1, 1 and 3.
    /// let class = MatrixClass::of(&DMatrix::from_row_slice(2, 2, &[1.0, -1.0, 2.0, 1.0]))?;
    /// assert!(!class.symmetric && class.p_matrix == Some(true));
    /// assert_eq!(class.definiteness, Definiteness::PositiveDefinite);
    /// assert_eq!(class.guarantee(), Guarantee::UniqueSolution);
    /// # Ok::<(), grasp_lcp::lcp::LcpError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`LcpError::NotSquare`] for a matrix that is not square, [`LcpError::MatrixEntry`] for an
    /// entry that is not finite.
    pub fn of(m: &DMatrix<f64>) -> Result<Self, LcpError> {
        LcpError::check_square("M", m)?;
        let n = m.nrows();
        let off_diagonal =
            |test: &dyn Fn(f64) -> bool| (0..n).all(|j| (0..n).all(|i| i == j || test(m[(i, j)])));
        let definiteness = definiteness(&symmetric_part(m));
        let z_matrix = off_diagonal(&|x| x <= 0.0);
        Ok(Self {
            symmetric: (0..n).all(|j| (0..j).all(|i| m[(i, j)] == m[(j, i)])),
            definiteness,
            copositivity: copositivity(m, definiteness, off_diagonal(&|x| x >= 0.0)),
            z_matrix,
            p_matrix: p_matrix(m, definiteness, z_matrix),
        })
    }

    /// The strongest guarantee of the classes found; that of a P-matrix is stronger than that of a strictly copositive one.
    #[must_use]
    pub fn guarantee(&self) -> Guarantee {
        if self.p_matrix == Some(true) {
            Guarantee::UniqueSolution
        } else if self.copositivity == Copositivity::Strict {
            Guarantee::Solution
        } else if self.copositivity == Copositivity::Plus {
            Guarantee::SolutionIfFeasible
        } else {
            Guarantee::None
        }
    }
}

fn symmetric_part(m: &DMatrix<f64>) -> DMatrix<f64> {
    matrix_of(m.nrows(), m.nrows(), &|i, j| 0.5 * m[(i, j)] + 0.5 * m[(j, i)])
}

/// Decides by Cholesky factorisation with diagonal pivoting, after scaling s to a diagonal of ones and zeros.
fn definiteness(s: &DMatrix<f64>) -> Definiteness {
    let n = s.nrows();
    if (0..n).any(|i| s[(i, i)] < 0.0) {
        return Definiteness::Indefinite;
    }
    let factor = |i: usize| if s[(i, i)] > 0.0 { 1.0 / s[(i, i)].sqrt() } else { 0.0 };
    for i in 0..n {
        // In a semidefinite matrix the row of a zero diagonal entry is zero.
        if s[(i, i)] == 0.0 && s.row(i).iter().any(|x| *x != 0.0) {
            return Definiteness::Indefinite;
        }
    }
    let mut a = matrix_of(n, n, &|i, j| s[(i, j)] * factor(i) * factor(j));
    let rounding = elimination_rounding(n);
    for k in 0..n {
        let (pivot, value) = (k..n)
            .fold((k, f64::NEG_INFINITY), |best, i| if a[(i, i)] > best.1 { (i, a[(i, i)]) } else { best });
        if value <= rounding {
            let rest = a.view((k, k), (n - k, n - k));
            let small = rest.iter().all(|x| x.abs() <= OFF_DIAGONAL * rounding);
            return if small { Definiteness::PositiveSemidefinite } else { Definiteness::Indefinite };
        }
        a.swap_rows(k, pivot);
        a.swap_columns(k, pivot);
        for j in k + 1..n {
            let f = a[(k, j)] / value;
            for i in k + 1..n {
                a[(i, j)] -= f * a[(i, k)];
            }
        }
    }
    Definiteness::PositiveDefinite
}

fn copositivity(
    m: &DMatrix<f64>,
    definiteness: Definiteness,
    nonnegative_off_diagonal: bool,
) -> Copositivity {
    let n = m.nrows();
    let diagonal = |test: &dyn Fn(f64) -> bool| (0..n).all(|i| test(m[(i, i)]));
    if definiteness == Definiteness::PositiveDefinite || (nonnegative_off_diagonal && diagonal(&|x| x > 0.0))
    {
        return Copositivity::Strict;
    }
    if definiteness == Definiteness::PositiveSemidefinite {
        return Copositivity::Plus;
    }
    if !diagonal(&|x| x >= 0.0) {
        return Copositivity::Not;
    }
    // If s without its positive off-diagonal entries is semidefinite, then s is the sum of this matrix and of a matrix without negative entries.
    let mut rest = symmetric_part(m);
    for j in 0..n {
        for i in 0..n {
            if i != j {
                rest[(i, j)] = rest[(i, j)].min(0.0);
            }
        }
    }
    match self::definiteness(&rest) {
        Definiteness::Indefinite => Copositivity::Unknown,
        _ => Copositivity::Plain,
    }
}

fn p_matrix(m: &DMatrix<f64>, definiteness: Definiteness, z_matrix: bool) -> Option<bool> {
    let n = m.nrows();
    if (0..n).any(|i| m[(i, i)] <= 0.0) {
        return Some(false);
    }
    let dominant = |i: usize| m.row(i).iter().map(|x| x.abs()).sum::<f64>() < 2.0 * m[(i, i)];
    if definiteness == Definiteness::PositiveDefinite || (0..n).all(dominant) {
        return Some(true);
    }
    if z_matrix {
        // A Z-matrix is a P-matrix exactly if all pivots of an elimination without exchanges are positive (3.11.10).
        let mut a = m.clone();
        for k in 0..n {
            if a[(k, k)] <= elimination_rounding(n) * m[(k, k)] {
                return Some(false);
            }
            eliminate(&mut a, k);
        }
        return Some(true);
    }
    // Each additional row doubles the work.
    (n <= 12).then(|| minors_are_positive(m.clone(), m))
}

fn eliminate(a: &mut DMatrix<f64>, k: usize) {
    for i in k + 1..a.nrows() {
        let f = a[(i, k)] / a[(k, k)];
        for j in k + 1..a.nrows() {
            a[(i, j)] -= f * a[(k, j)];
        }
    }
}

/// Whether a is a P-matrix.
///
/// The first entry of a must be positive. Two smaller matrices must be P-matrices: a without its first row and column, and the Schur complement
/// of the first entry.
///
/// m holds the original diagonal, in the order of a, relative to which a pivot is judged.
fn minors_are_positive(a: DMatrix<f64>, m: &DMatrix<f64>) -> bool {
    let n = a.nrows();
    if n == 0 {
        return true;
    }
    if a[(0, 0)] <= ELIMINATED_PIVOT * m[(0, 0)] {
        return false;
    }
    let smaller = m.view((1, 1), (n - 1, n - 1)).into_owned();
    let without = a.view((1, 1), (n - 1, n - 1)).into_owned();
    let mut a = a;
    eliminate(&mut a, 0);
    minors_are_positive(without, &smaller)
        && minors_are_positive(a.view((1, 1), (n - 1, n - 1)).into_owned(), &smaller)
}
