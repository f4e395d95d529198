//! What the solver takes for zero, for noise or for rounding.
//!
//! All of them are pure numbers. Rows and columns of M are balanced first, so entries of M lie near 1; every other
//! quantity is compared with the terms it was computed from. ε = 2⁻⁵². The tolerances that a caller may move are
//! fields of [`Settings`](super::Settings), each with its reason there.

/// A value is zero below this part of its largest term, or of the largest value of its kind.
///
/// Sums of n terms carry some nε, and a few pivots a few times that. Smaller, noise is kept in the basis and solutions
/// miss their `degenerate`; from 1e-10 on values are cut off that the residuals miss.
pub(super) const ZERO: f64 = 1e-13;

/// Residuals above this are worth a fresh factorisation of the basis, which costs n³/3 flops.
///
/// Refined points stay below it unless the basis is nearly singular. Smaller, ordinary problems pay for
/// factorisations; larger, digits are given away that the data still hold.
pub(super) const SOUND: f64 = 1e-13;

/// A block with a pivot below this is singular, the entries of the balanced block being near 1.
///
/// Pivoting is complete in all small blocks, so a few roundings are allowed for. Smaller, singular
/// blocks pass; larger, solutions of badly conditioned blocks are lost to `all_solutions`.
pub(super) const SINGULAR_BLOCK: f64 = 1e-15;

/// An entry of the tableau of a mixed problem below this is zero, the balanced entries being near 1.
///
/// Whole rows and columns are eliminated without refinement, so thousands of roundings are allowed for. Smaller, a free
/// variable is eliminated by noise; larger, variables that are determined are called undetermined.
pub(super) const FREE_PIVOT: f64 = 1e-12;

/// A dependent equality is satisfied if its constant is below this part of 1 plus the largest constant.
///
/// Constants have been through all eliminations. Smaller, consistent equalities are sent to the split form, which is
/// larger; larger, contradictions pass here and are found by the residuals only.
pub(super) const DEPENDENT: f64 = 1e-10;

/// The rates of a ray below this part of their column are noise (of columns of largest entry below 1: below this).
///
/// A negative rate of that size would spoil a proof, a positive one adds noise to it. Larger, true small rates are
/// missing from the proof, which then fails its check and is looked for by linear programming.
pub(super) const RAY_NOISE: f64 = 1e-12;

/// Two solutions are one point if each pair of entries differs by at most this part of the larger one.
///
/// Two bases of condition 1e7 leave so much. Smaller, a degenerate point is listed twice; larger, two close
/// solutions are listed once. Entries that are zero but for rounding pass by [`SAME_POINT`].
pub(super) const SAME_ENTRY: f64 = 1e-9;

/// A pair of entries of two solutions also counts as equal if it differs by at most this part of the largest entry.
///
/// It takes in entries that are zero but for rounding. Smaller, their noise makes two points of one; larger, two
/// solutions of entries of very different size are listed once.
pub(super) const SAME_POINT: f64 = 1e-12;

/// A point whose residuals exceed rounding must solve the problem for a q that differs by at most this part of its
/// largest entry, in balanced rows.
///
/// Residuals measure against the terms of M z. Where those cancel down to a q that is 1e-10 of them, a tolerance of
/// 1e-10 says nothing about q any more. Smaller, good points of badly conditioned problems are refused.
pub(super) const BACKWARD_ERROR: f64 = 1e-6;

/// q is lost in the terms of M z where it is below this part of them in every row: some hundred thousand roundings.
///
/// A singular basis whose determinant came out as 1e-16 gives a z of 1e14 that satisfies 0 ≤ z ⟂ M z ≥ 0 and, to
/// rounding, any q. Problems of condition 1e10 stay clear of this; larger, they are refused.
pub(super) const LOST: f64 = 1e-11;

/// The exponents of the balance, in powers of two, are settled when their equations hold to this.
///
/// Rows that are alike must get equal factors, or ties turn into near-ties. Smaller, the iteration never sees itself
/// end; larger, ties come apart.
pub(super) const SETTLED: f64 = 1e-13;

/// The rounding of a sum of n products and two more operations, as a part of Σ|terms|: 8 (n + 2) ε.
///
/// The worst case is (n + 2) ε/2; a Farkas vector has been rounded itself. Larger, vectors pass that prove nothing.
pub(super) fn sum_rounding(n: usize) -> f64 {
    8.0 * (n as f64 + 2.0) * f64::EPSILON
}

/// Residuals of a point of n rows up to (8 + n/8) ε are rounding: a row of so many terms cannot be summed much better.
///
/// Smaller, points are refined without gain; larger, refinement stops a digit early.
pub(super) fn residual_rounding(n: usize) -> f64 {
    (8.0 + n as f64 / 8.0) * f64::EPSILON
}
