//! Tolerances of the solvers of frictional contact problems.
//!
//! All tolerances are without units: forces are compared with forces, and velocities with the terms of W r + q that add up to them. ε = 2⁻⁵². Limits
//! for problems that are dominated by rounding are in `lcp::tolerances`.

/// Residual, relative to the norm of its terms, at which a round of anchored Newton steps (with a proximal term) has converged.
///
/// If smaller, rounds that stop at rounding count as failed, and the proximal term grows; if larger, later rounds start from worse forces.
pub(super) const ROUND_CONVERGED: f64 = 1e-14;

/// Residual below which forces are refined by final Newton steps without a proximal term. Below it, residuals are also weighted contact by
/// contact instead of as energy.
///
/// If smaller, unnecessary rounds precede the polish; if larger, polishing starts where Newton's method does not converge.
pub(super) const WORTH_POLISHING: f64 = 1e-6;

/// Lower limit of the weight δ of the proximal term in the linear equations of a Newton step, relative to the contact's diagonal block of the
/// matrix W. It makes the equations of redundant contacts regular.
///
/// Undetermined force components lose half of their digits by this weight, determined components lose no digits. If smaller, equations become
/// singular.
pub(super) const LEAST_ANCHOR: f64 = 1e-12;

/// Multiple of the size of a contact's diagonal block of the matrix W that is added to the block along the central path. It makes the equations
/// of redundant contacts regular.
///
/// If smaller, equations are singular inside the cones; if larger, the forces at the end of the path solve a visibly different problem.
pub(super) const SHIFTED_BLOCK: f64 = 1e-9;

/// Root mean square of the residuals up to which a point counts as on the central path, when the path is followed around its folds. It is
/// relative to √τ, with the path's parameter τ.
///
/// If smaller, each step needs more corrections; if larger, the path jumps to another branch.
pub(super) const ON_CENTRAL_PATH: f64 = 1e-2;

/// Pivot of the linear equations of a Newton step, relative to the largest pivot, below which a force is not changed. The forces of redundant
/// contacts are not determined.
///
/// If smaller, undetermined forces follow rounding; if larger, determined forces of soft contacts are not updated.
pub(super) const UNDETERMINED_FORCE: f64 = 1e-12;

/// Relative excess of friction over its limit μ r_N, for a normal force r_N, from which a force counts as outside the cone.
///
/// If smaller, the rounding of a projection counts as outside; if larger, visible violations remain.
pub(super) const OUTSIDE_CONE: f64 = 1e-13;

/// Relative rounding error assumed in a proof: of sums rounded once, and of a few further operations.
///
/// If smaller, a proof could be wrong; if larger, proofs with contacts at the edge of their cones are refused.
pub(super) const PROOF_ROUNDING: f64 = 8.0 * 1e-15;

/// Largest number of rows of a complementarity problem with polygons for which the facets are tried first.
///
/// Up to this size Lemke's method takes milliseconds, and in the plane it decides the problem. If larger, it takes longer than Newton's method.
pub(super) const MOST_ROWS_FACETS_FIRST: usize = 160;
