//! The numbers below which linear algebra takes a value for zero or for rounding, and the scales that rooms above share.
//!
//! All of them are pure numbers: parts of the terms or of the largest value that a result was computed from. ε = 2⁻⁵².

/// The rounding of a few operations, as a part of their terms: 4 ε.
///
/// A normal computed as (cos π/2, sin π/2) has a component of 6e-17, a residual of Newton's method ends here, and a projection that
/// moves a vector by less changes rounding only. Smaller, such an entry counts as a spring, and steps are made on noise. Larger, true
/// entries of soft springs beside stiff ones are lost, and forces lose their last digit.
pub(crate) const FEW_ROUNDINGS: f64 = 4.0 * f64::EPSILON;

/// The rounding of a short sum, as a part of its largest term: some sixteen operations, 16 ε.
///
/// Smaller, exact ties come apart: a tie rule fails, and an angle at which two numbers only touch is found or lost. Larger, rows that
/// block one after the other count as ties, and numbers that cross slowly count as touching.
pub(crate) const ROUNDED_SUM: f64 = 16.0 * f64::EPSILON;

/// The rounding of a quantity that comes out of linear solves, as a part of the largest of its kind.
///
/// Systems of condition 1e3 leave 1e-13 of it. Smaller, ties that symmetric grasps have come apart, and a sum that balances counts as
/// unbalanced. Larger, quantities that a caller can see count as zero.
pub(crate) const SOLVED_ROUNDING: f64 = 1e-12;

/// The part of a size below which a quantity has no effect: a gap, a slip, a gain, a difference of two results.
///
/// It lies between the rounding of solves (1e-12) and the digits that data and sentences have (1e-6). Smaller, results of iterations
/// differ by their own error. Larger, effects that people measure are left out.
pub(crate) const NEGLIGIBLE: f64 = 1e-9;

/// A step of part t is accepted where it reduces the error by at least this part of what its linear prediction promises.
///
/// It is Armijo's rule. Near 1 full Newton steps are refused; at 0 steps that gain nothing are accepted, and a search may circle.
pub(crate) const SUFFICIENT_DECREASE: f64 = 0.1;

/// A vector depends on others, and a matrix of orthonormal products is singular, if less than this part of it is left without them.
///
/// Rounding leaves 1e-16 times a few operations; normals of real geometry are parallel up to 1e-12. Smaller, noise becomes a
/// direction that resists, and a free motion gets a stiffness. Larger, soft springs beside stiff ones are lost.
pub(crate) const LINEARLY_DEPENDENT: f64 = 1e-13;

/// Pivot, relative to the largest entry, below which a matrix has no factors with partial pivoting.
///
/// [`CompletePivoting`](super::CompletePivoting) or [`Orthogonal`](super::Orthogonal) must then distinguish singular from soft. Above it
/// a solution has some six digits without refinement. Smaller, callers that do not refine get wrong digits; larger, more matrices take
/// the slower factors.
pub(super) const PARTIAL_PIVOT: f64 = 1e-10;

/// Pivot of a band matrix, relative to its largest entry, that counts as zero.
///
/// It is smaller than [`PARTIAL_PIVOT`], since solutions of bands are refined. Exactly singular matrices leave some 1e-16. Larger, soft
/// springs beside stiff ones count as absent.
pub(super) const BAND_PIVOT: f64 = 1e-11;

/// Pivot, relative to the original diagonal entry, below which a matrix does not count as positive definite.
///
/// Smaller, a semidefinite matrix gets factors made of rounding. Larger, matrices of condition 1e12 are refused.
pub(super) const POSITIVE_PIVOT: f64 = 1e-12;

/// A set thinner than this part of its size in some direction counts as flat.
///
/// Smaller, a flat set gets a volume made of rounding. Larger, thin sets count as flat: a wrench counts as out of reach.
pub(super) const FLAT_SET: f64 = 1e-10;

/// A growing polytope may come nearer to the origin by this part of its size, by rounding; more ends the search.
///
/// Smaller, sets of many points end with a loose bound. Larger, a polytope with a wrong face goes on growing.
pub(super) const POLYTOPE_SHRINKS: f64 = 1e-7;

/// Distance beyond a plane or from the middle of a set, relative to the ray, or size of a pivot, relative to the largest, that counts as
/// rounding.
///
/// Smaller, a ray changes planes by rounding until its pivots are used up. Larger, the length of a ray has fewer digits.
pub(super) const BEYOND_PLANE: f64 = 1e-13;
