//! The numbers below which the solver takes a value for zero, for noise or for rounding.
//!
//! All of them are pure numbers. Rows and columns of M are balanced first, so entries of M lie near
//! 1; every other quantity is compared with the terms it was computed from. ε = 2⁻⁵².
//!
//! The tolerances that a caller may move are fields of [`Settings`](super::Settings), each with its
//! reason there.

/// A value is zero below this part of its largest term, or of the largest value of its kind.
///
/// Sums of n terms carry some nε, and a few pivots a few times that. Smaller, noise is kept in the
/// basis and solutions miss their `degenerate`; from 1e-10 on, values are cut off without a trace in
/// the residuals.
pub(super) const ZERO_VALUE: f64 = 1e-13;

/// Residuals above this are worth a fresh factorisation of the basis, at up to 2n³/3 flops.
///
/// Refined points stay below it unless the basis is nearly singular. Smaller, ordinary problems pay
/// for factorisations; larger, digits that the data hold are given away.
pub(super) const SOUND_RESIDUAL: f64 = 1e-13;

/// Entries of the column of a slack below this part of its largest are rounding.
///
/// Such a column is carried from pivot to pivot instead of summed, so its terms are unknown;
/// the updates of some dozen pivots leave this much. Smaller, noise becomes a pivot; larger,
/// true small pivots are overlooked.
pub(super) const STORED_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A pivot below this part of its column is made only in a dictionary computed afresh.
///
/// Such a pivot multiplies the errors of all entries by its inverse: half of the sixteen digits
/// would be gone. Larger, dictionaries are computed afresh, at O(n³), where nothing was lost;
/// smaller, pivots are made on noise.
pub(crate) const DOUBTFUL_PIVOT: f64 = 1e-7;

/// A dictionary whose values miss the data by more than this part of their terms is computed anew.
///
/// Below it, the signs of values down to 1e-10 of their terms are reliable. Smaller, long paths are
/// factorised again and again; larger, the path may turn where that of the problem does not.
pub(super) const DRIFTED: f64 = 1e-10;

/// This part of the largest q_i is added to the terms of every row when drift is measured.
///
/// A row with nothing but noise has no terms for comparison. Smaller, such
/// rows ask for fresh dictionaries that are no better; larger, drift in rows of small terms is
/// not noticed.
pub(super) const DRIFT_FLOOR: f64 = 1e-3;

/// A z that is zero is taken out of the basis only over a pivot of at least this part of its
/// column.
///
/// The exchange serves the digits of the other values, which a smaller pivot would cost more than
/// it saves. At 1 hardly any such z leaves.
pub(super) const RETIRING_PIVOT: f64 = 1e-5;

/// A pivot below this part of the entry or the column that it was computed from is rounding: the basis is singular where a dictionary
/// is computed anew, and a principal minor is not positive.
///
/// Rows only are pivoted, and Schur complements of twelve rows nested, so some fifty roundings are allowed for. Smaller, singular bases
/// pass and give values of 1e15, and singular matrices are called P-matrices. Larger, bases of condition 1e14 are refused that refinement
/// would still save, and so are P-matrices close to singular.
pub(super) const ELIMINATED_PIVOT: f64 = 1e-14;

/// An entry of the tableau of a mixed problem below this is zero, the balanced entries being near
/// 1.
///
/// Whole rows and columns are eliminated without refinement, so thousands of roundings are allowed
/// for. Smaller, a free variable is eliminated by noise; larger, variables that are determined are
/// called undetermined.
pub(super) const FREE_PIVOT: f64 = 1e-12;

/// A dependent equality is satisfied if its constant is below this part of 1 plus the largest
/// constant.
///
/// Constants have passed through all eliminations. Smaller, consistent equalities are sent to the
/// split form, which is larger; larger, contradictions pass here and are found by the residuals
/// only.
pub(super) const DEPENDENT_EQUALITY: f64 = 1e-10;

/// A point whose residuals exceed rounding must solve the problem for a q close to the one given.
/// In balanced rows, the two may differ by this part of the largest entry.
///
/// Residuals measure against the terms of M z. Where these terms cancel down to a q of 1e-10 of
/// their size, residuals of 1e-10 do not depend on q. Smaller, good points of badly
/// conditioned problems are refused; larger, points pass that ignore q.
pub(crate) const BACKWARD_ERROR: f64 = 1e-6;

/// q is lost in the terms of M z where it is below this part of them in every row: some hundred
/// thousand roundings.
///
/// A singular basis whose determinant came out as 1e-16 gives a z of 1e14. That z satisfies 0 ≤ z ⟂
/// M z ≥ 0 and, to rounding, any q. Problems of condition 1e10 stay clear of this; larger, they are
/// refused.
pub(crate) const LOST: f64 = 1e-11;

/// The exponents of the balance, in powers of two, have converged when their equations hold to this.
///
/// Rows that are alike must get equal factors, or ties turn into near-ties. Smaller, the iteration
/// never meets its criterion; larger, ties come apart.
pub(super) const BALANCED_EXPONENTS: f64 = 1e-13;

/// The rounding of a sum of n products and two more operations, as a part of Σ|terms|: 8 (n + 2) ε.
///
/// The worst case is (n + 2) ε/2; a Farkas vector has been rounded itself. Larger, vectors pass
/// that prove nothing.
pub(super) fn sum_rounding(n: usize) -> f64 {
    8.0 * (n as f64 + 2.0) * f64::EPSILON
}

/// Residuals of a point of n rows up to (8 + n/8) ε are rounding: a row of n terms cannot be
/// summed much better.
///
/// Smaller, points are refined without gain; larger, refinement stops a digit early.
pub(super) fn residual_rounding(n: usize) -> f64 {
    (8.0 + n as f64 / 8.0) * f64::EPSILON
}

/// The rounding that n eliminations leave in a diagonal entry that vanishes, as a part of that entry: 8 n ε.
///
/// Smaller, semidefinite matrices are called definite or indefinite by their noise; larger,
/// definite ones of condition 1/(8 n ε) are called semidefinite.
pub(super) fn elimination_rounding(n: usize) -> f64 {
    8.0 * n as f64 * f64::EPSILON
}

/// The remainder of a semidefinite matrix after elimination is zero if all its entries are below this multiple of
/// [`elimination_rounding`].
///
/// Its off-diagonal entries are not pivoted to the front, so they may carry more than the diagonal.
/// Smaller, semidefinite matrices are called indefinite; larger, slightly indefinite ones pass.
pub(super) const OFF_DIAGONAL: f64 = 4.0;

/// The largest n for which all 2ⁿ bases are tried: about a million.
///
/// Larger, a call takes minutes; smaller, problems that nothing else decides stay undecided.
pub(super) const MOST_ENUMERATED: usize = 20;

/// The largest number of rows of a problem whose vertices are tried: some thousands of them.
///
/// Larger, the vertices cost more than the linear programs that replace them.
pub(super) const MOST_ROWS_WITH_VERTICES: usize = 6;

/// The largest number of rows for which pairs of rows are tried and vectors simplified: n² checks of n² products.
///
/// Larger, these checks take longer than Lemke's path; smaller, simple proofs are replaced by long ones.
pub(super) const MOST_PAIRED_ROWS: usize = 48;

/// 2⁵³, the largest denominator tried for the ratios of a proof: not all whole numbers beyond it are doubles.
pub(super) const LARGEST_WHOLE: f64 = 9_007_199_254_740_992.0;

/// Bounds of a nearly proved contradiction are reduced by this part of themselves, more than the rounding with which they are computed.
///
/// Smaller, a bound may claim too much; larger, it says less than is known.
pub(super) const BOUND_ROUNDING: f64 = 1e-14;

/// Factor by which bounds of a verified solution grow: far more than the rounding of the few operations that lead to them.
///
/// Nearer to 1, a bound may be too small; larger, bounds lose digits that nobody reads.
pub(super) const SAFE_BOUND: f64 = 1.0 + 1e-12;

/// Largest loss to underflow in a bound of a verified solution.
///
/// Smaller, products of subnormal numbers are not covered; larger, problems in tiny units are not verified.
pub(super) const UNDERFLOW: f64 = 1e-300;

/// Size of the terms of a row below which products may have underflowed or lost digits: such rows are summed again without rounding.
///
/// It is 2¹¹⁴ times the smallest double, so the losses in larger rows are negligible. Larger, more rows are summed twice.
pub(super) const FAINT_ROW: f64 = 1.03e-289;
