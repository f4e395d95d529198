//! Tolerances of the solver: limits below which a value is zero, noise or rounding.
//!
//! All tolerances are without units. Rows and columns of M are balanced first: scaled by powers of two, so that nonzero entries of M lie near 1.
//! Every other quantity is compared with the terms from which it was computed. ε = 2⁻⁵². A dictionary is the condensed tableau of one basis.
//!
//! Tolerances that a caller may change are fields of [`Settings`](super::Settings), where the reasons for their values are given.

/// A basic variable z_j or w_i counts as zero below this fraction of the magnitude of the terms from which it was computed. Entries of z and of
/// Farkas vectors may also count as zero below this fraction of the largest entry of their vector.
///
/// Sums of n terms have relative errors of about nε, and a few pivots multiply them by a small number. With a smaller limit, noise remains in the
/// basis, and a degenerate solution (with a zero basic variable) is not marked as degenerate. If the limit is above 1e-10, true values are set to
/// zero, which the residuals do not show.
pub(super) const ZERO_VALUE: f64 = 1e-13;

/// Residuals of a point z above this limit are worth a new factorisation of its basis, which costs up to 2n³/3 flops.
///
/// Refined points stay below it unless the basis is nearly singular. With a smaller limit, ordinary problems are factorised needlessly. With a larger
/// limit, points keep fewer correct digits than possible.
pub(super) const SOUND_RESIDUAL: f64 = 1e-13;

/// For each nonbasic slack w_i the dictionary stores a column. Entries of this column below this fraction of its largest entry count as zero.
///
/// Such a column is updated from pivot to pivot rather than summed, so its terms are unknown. The updates of a few dozen pivots leave rounding errors
/// of this magnitude. With a smaller limit, noise becomes a pivot. With a larger limit, true small pivots are overlooked.
pub(super) const STORED_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A pivot below this fraction of the largest entry of its column is doubtful. It is accepted only if the dictionary was just recomputed from M, q
/// and d, or if the entering column was refined.
///
/// A pivot that is 1e-7 of its column multiplies the errors of all entries by 1e7, so seven of the sixteen digits are lost. With a larger limit,
/// dictionaries are recomputed, at O(n³), although they are accurate. With a smaller limit, pivots are made on noise.
pub(crate) const DOUBTFUL_PIVOT: f64 = 1e-7;

/// A dictionary is recomputed if its values violate w = q + M z + d z₀ in some row by more than this fraction of the terms of the row.
///
/// Violations up to this fraction leave about ten correct digits, so in well-conditioned bases only values near zero may have the wrong sign. With a
/// smaller limit, long paths are refactorised again and again. With a larger limit, the computed path may visit other bases than the path in exact
/// arithmetic.
pub(super) const DRIFTED: f64 = 1e-10;

/// The drift of a dictionary is its violation of w = q + M z + d z₀, relative to the terms of the row. This fraction of the largest |q_i| is added to
/// the terms of every row.
///
/// If nothing were added, the violation of a row whose terms are all rounding errors would be as large as the terms, and would count as drift. With a
/// smaller fraction, such rows cause refactorisations that do not help. With a larger fraction, drift in rows of small terms is not noticed.
pub(super) const DRIFT_FLOOR: f64 = 1e-3;

/// A basic z_j that is zero up to rounding is removed from the basis by a pivot. The pivot must be at least this fraction of the largest entry of its
/// column.
///
/// Removal keeps the noise of z_j out of the other values, but a small pivot amplifies the rounding errors of those values. With a larger fraction,
/// more such z_j stay in the basis with their noise.
pub(super) const RETIRING_PIVOT: f64 = 1e-5;

/// A pivot counts as zero if it is at most this fraction of a number from which it was computed. When a dictionary is recomputed, this number is the
/// largest entry of the balanced column of M, and the basis is then singular. In the P-matrix test the number is the diagonal entry of M, and a
/// principal minor is then not positive.
///
/// The fraction is about fifty rounding errors. A pivot is the result of many eliminations: of one for each variable of the basis, with exchanges of
/// rows alone, or of up to twelve in the P-matrix test. With a smaller limit, singular bases are accepted and give values of 1e15, and singular
/// matrices count as P-matrices. With a larger limit, bases of condition 1e14 are refused although refinement leads to a solution, and so are
/// P-matrices close to singular.
pub(super) const ELIMINATED_PIVOT: f64 = 1e-14;

/// A point whose residuals are larger than rounding errors is accepted only if it solves the problem exactly for some q′ close to q. In balanced rows
/// q′ may differ from q by this fraction of the largest entry of q.
///
/// Residuals are relative to the terms of M z. If q is only 1e-10 of these terms, a point with residuals of 1e-10 may not depend on q at all. With a
/// smaller fraction, good points of ill-conditioned problems are refused. With a larger fraction, points that do not depend on q are accepted.
pub(crate) const BACKWARD_ERROR: f64 = 1e-6;

/// A point does not depend on q, up to rounding, if q is below this fraction of the terms of M z in every row. The fraction is about 5e4 rounding
/// errors.
///
/// A singular basis has a pivot that is computed as some 1e-16 to 1e-14 instead of zero. It gives a z of at least 1e14, beside which every q of
/// magnitude 1 is rounding. Problems of condition 1e10 have a q of 1e-10 of the terms and are not affected; if the fraction were larger, they would
/// be refused.
pub(crate) const LOST: f64 = 1e-11;

/// The equations for the balancing exponents (exponents of two) count as solved when their residual is below this number.
///
/// Equal rows must get equal factors, because otherwise ties in the ratio test turn into near-ties. With a smaller limit, the iteration never
/// converges. With a larger limit, such ties are separated.
pub(super) const BALANCED_EXPONENTS: f64 = 1e-13;

/// Bound on the rounding error of a sum of n products and two further operations, relative to Σ|terms|: 8 (n + 2) ε.
///
/// For exact factors the worst case is (n + 2) ε/2. The bound is 16 times larger, since factors such as the entries of a Farkas vector are themselves
/// rounded. With a larger bound, vectors that prove nothing are accepted as proofs.
pub(super) fn sum_rounding(n: usize) -> f64 {
    8.0 * (n as f64 + 2.0) * f64::EPSILON
}

/// Residuals of a point of n rows that are at most (8 + n/8) ε count as rounding errors: a row of n terms cannot be summed much more accurately.
///
/// With a smaller bound, points are refined without gain. With a larger bound, refinement stops one digit too early.
pub(super) fn residual_rounding(n: usize) -> f64 {
    (8.0 + n as f64 / 8.0) * f64::EPSILON
}

/// The rounding error that n elimination steps leave in a diagonal entry whose exact value is zero, relative to the original entry: 8 n ε.
///
/// With a smaller bound, noise decides whether a semidefinite matrix counts as definite or indefinite. With a larger bound, definite matrices of
/// condition 1/(8 n ε) count as semidefinite.
pub(super) fn elimination_rounding(n: usize) -> f64 {
    8.0 * n as f64 * f64::EPSILON
}

/// The largest n for which all 2ⁿ bases are tried; 2²⁰ bases are about a million.
///
/// With a larger limit, a call takes minutes. With a smaller limit, some problems remain undecided.
pub(super) const MOST_ENUMERATED: usize = 20;

/// The largest number of rows for which all vertices of a problem are tried. At a vertex as many inequalities are equations as there are unknowns.
/// Six rows give at most a few thousand vertices.
///
/// With a larger limit, the vertices cost more than the linear programs that they replace.
pub(super) const MOST_ROWS_WITH_VERTICES: usize = 6;

/// The largest number of rows for which pairs of rows are tried as proofs of infeasibility, and Farkas vectors are simplified. Either takes n²
/// checks, each with n² products.
///
/// With a larger limit, these checks take longer than Lemke's path. With a smaller limit, proofs are longer than necessary.
pub(super) const MOST_PAIRED_ROWS: usize = 48;

/// 2⁵³, the largest common denominator that is tried for the ratios of the entries of a Farkas vector: above 2⁵³ not all integers are doubles.
pub(super) const LARGEST_WHOLE: f64 = 9_007_199_254_740_992.0;

/// A vector y that is nearly a Farkas vector gives a lower bound on Σ z_j for every z ≥ 0 with M z + q ≥ 0. The bound is reduced by this fraction, to
/// cover its rounding error.
///
/// With a smaller fraction, the bound may be too large. With a larger fraction, it is weaker than necessary.
pub(super) const BOUND_ROUNDING: f64 = 1e-14;

/// Magnitude of the terms of a row below which products may have underflowed or lost digits. Such rows are summed again without rounding.
///
/// It is 2¹¹⁴ times 2⁻¹⁰⁷⁴, the smallest positive double, so that underflow of a product is negligible in rows with larger terms. With a larger
/// limit, more rows are summed twice.
pub(super) const FAINT_ROW: f64 = 1.03e-289;
