//! Tolerances of the solver: limits below which a value is zero, noise or rounding.
//!
//! All are without units. Rows and columns of M are balanced first, so entries of M lie near 1; every other quantity is compared with the terms
//! from which it was computed. ε = 2⁻⁵².
//!
//! Tolerances that a caller may change are fields of [`Settings`](super::Settings), where their reasons are given.

/// A value is zero below this fraction of its largest term, or of the largest value of its kind.
///
/// Sums of n terms have errors of about nε, and a few pivots multiply that by a few. If smaller, noise remains in the basis and `degenerate` is not
/// set. Above 1e-10, values are set to zero without a visible effect on the residuals.
pub(super) const ZERO_VALUE: f64 = 1e-13;

/// Residuals above this limit are worth a new factorisation of the basis, which costs up to 2n³/3 flops.
///
/// Refined points stay below it unless the basis is nearly singular. If smaller, ordinary problems are factorised needlessly; if larger, available
/// digits are given away.
pub(super) const SOUND_RESIDUAL: f64 = 1e-13;

/// Entries of a slack's stored column are rounding below this fraction of the largest entry.
///
/// Such a column is updated from pivot to pivot rather than summed, so its terms are unknown; the updates of some dozen pivots leave this much
/// rounding. If smaller, noise becomes a pivot; if larger, true small pivots are overlooked.
pub(super) const STORED_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A pivot below this fraction of its column is accepted only in a recently computed or refined dictionary.
///
/// Such a pivot multiplies the errors of all entries by its inverse: half of the sixteen digits would be lost. If larger, dictionaries are
/// recomputed, at O(n³), although nothing was lost; if smaller, pivots are made on noise.
pub(crate) const DOUBTFUL_PIVOT: f64 = 1e-7;

/// A dictionary whose values violate the data by more than this fraction of their terms is recomputed.
///
/// Below it, the signs of values down to 1e-10 of their terms are reliable. If smaller, long paths are refactorised again and again; if larger, the
/// path may deviate from that of the problem.
pub(super) const DRIFTED: f64 = 1e-10;

/// This fraction of the largest q_i is added to the terms of every row when drift is measured.
///
/// Otherwise a row that holds only noise would have no terms for comparison. If smaller, such rows cause refactorisations that do not help; if
/// larger, drift in rows of small terms is not noticed.
pub(super) const DRIFT_FLOOR: f64 = 1e-3;

/// A vanishing z is removed from the basis only if the pivot is at least this fraction of its column.
///
/// The exchange is meant to save digits of the other values, and a smaller pivot would cost more digits than it saves. At 1 hardly any such z
/// would be removed.
pub(super) const RETIRING_PIVOT: f64 = 1e-5;

/// A pivot below this fraction of the entry or column from which it was computed is rounding. The basis is then singular, in a recomputed
/// dictionary, or a principal minor is not positive.
///
/// Only rows are pivoted, and Schur complements of twelve rows are nested, so some fifty roundings are allowed for. If smaller, singular bases pass
/// and give values of 1e15, and singular matrices count as P-matrices. If larger, bases of condition 1e14 are refused although refinement would save
/// them, and so are P-matrices close to singular.
pub(super) const ELIMINATED_PIVOT: f64 = 1e-14;

/// A point whose residuals exceed rounding must solve the problem for a q close to the given one. In balanced rows the two may differ by this
/// fraction of the largest entry.
///
/// Residuals are relative to the terms of M z. If these terms cancel down to a q of 1e-10 of their size, residuals of 1e-10 say nothing about q. If
/// smaller, good points of ill-conditioned problems are refused; if larger, points pass that ignore q.
pub(crate) const BACKWARD_ERROR: f64 = 1e-6;

/// The solution does not depend on q, up to rounding, if q is below this fraction of the terms of M z in every row: some hundred thousand roundings.
///
/// A singular basis whose determinant is computed as 1e-16 gives a z of 1e14. To rounding, that z satisfies 0 ≤ z ⟂ M z + q ≥ 0 for every q.
/// Problems of condition 1e10 are not affected; if this limit were larger, they would be refused.
pub(crate) const LOST: f64 = 1e-11;

/// Residual, in powers of two, at which the equations of the balancing exponents have converged.
///
/// Equal rows must get equal factors, or ties turn into near-ties. If smaller, the iteration never converges; if larger, ties are separated.
pub(super) const BALANCED_EXPONENTS: f64 = 1e-13;

/// The rounding of a sum of n products and two further operations, relative to Σ|terms|: 8 (n + 2) ε.
///
/// The worst case is (n + 2) ε/2, but a Farkas vector is itself rounded. If larger, vectors pass that prove nothing.
pub(super) fn sum_rounding(n: usize) -> f64 {
    8.0 * (n as f64 + 2.0) * f64::EPSILON
}

/// Residuals of a point of n rows are rounding up to (8 + n/8) ε: a row of n terms cannot be summed much more accurately.
///
/// If smaller, points are refined without gain; if larger, refinement stops a digit early.
pub(super) fn residual_rounding(n: usize) -> f64 {
    (8.0 + n as f64 / 8.0) * f64::EPSILON
}

/// The rounding that n eliminations leave in a diagonal entry whose exact value is zero, relative to its original value: 8 n ε.
///
/// If smaller, noise makes semidefinite matrices definite or indefinite; if larger, definite ones of condition 1/(8 n ε) count as semidefinite.
pub(super) fn elimination_rounding(n: usize) -> f64 {
    8.0 * n as f64 * f64::EPSILON
}

/// The largest n for which all 2ⁿ bases are tried, about a million.
///
/// If larger, a call takes minutes; if smaller, problems remain undecided that nothing else decides.
pub(super) const MOST_ENUMERATED: usize = 20;

/// The largest number of rows of a problem whose vertices, some thousands, are tried.
///
/// If larger, the vertices cost more than the linear programs that they replace.
pub(super) const MOST_ROWS_WITH_VERTICES: usize = 6;

/// The largest number of rows for which pairs of rows are tried and vectors simplified, by n² checks of n² products.
///
/// If larger, these checks take longer than Lemke's path; if smaller, simple proofs are replaced by long ones.
pub(super) const MOST_PAIRED_ROWS: usize = 48;

/// 2⁵³, the largest denominator tried for the ratios of a proof: beyond it not all integers are doubles.
pub(super) const LARGEST_WHOLE: f64 = 9_007_199_254_740_992.0;

/// The lower bound on z that goes with a nearly proved contradiction is reduced by this fraction, to cover its own rounding.
///
/// If smaller, a bound may claim too much; if larger, it is weaker than necessary.
pub(super) const BOUND_ROUNDING: f64 = 1e-14;

/// Magnitude of the terms of a row below which products may have underflowed or lost digits. Such rows are summed again without rounding.
///
/// It is 2¹¹⁴ times the smallest double, so the errors in larger rows are negligible. If larger, more rows are summed twice.
pub(super) const FAINT_ROW: f64 = 1.03e-289;
