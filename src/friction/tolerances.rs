//! The numbers below which a solver of frictional contact takes a value for zero or for rounding.
//!
//! All of them are pure numbers: forces are compared with forces, velocities with the terms of W r + q. ε = 2⁻⁵².
//! Where the problem is lost in rounding, the limits of `lcp::tolerances` hold here, too.

/// A round of anchored steps has also converged if its residual is this part of its terms.
///
/// Smaller, rounds that rounding has ended count as failed and the anchor gets firmer; larger, later rounds begin at worse forces.
pub(super) const ROUND_CONVERGED: f64 = 1e-14;

/// Residual below which forces are polished and residuals are weighed contact by contact.
///
/// Smaller, polishing begins after rounds that it would have spared; larger, it begins where Newton's method does not converge.
pub(super) const WORTH_POLISHING: f64 = 1e-6;

/// Least anchor δ in the linear equations, in units of the contact's own compliance, so that redundant contacts give regular equations.
///
/// Undetermined force components lose half their digits by it, determined ones none. Smaller, equations become singular.
pub(super) const LEAST_ANCHOR: f64 = 1e-12;

/// Relative increase of the own blocks along the central path, in units of 1/ρ, for redundant contacts.
///
/// Smaller, equations are singular inside the cones; larger, the path ends at forces of another problem.
pub(super) const SHIFTED_BLOCK: f64 = 1e-9;

/// A point is on the path around folds if the root mean square of its residuals is below this part of √τ.
///
/// Smaller, each step takes more corrections; larger, the path jumps to another branch.
pub(super) const ON_CENTRAL_PATH: f64 = 1e-2;

/// Pivot, relative to the largest, below which an unknown keeps its value: the forces of redundant contacts are not determined.
///
/// Smaller, they follow rounding; larger, determined forces of soft contacts stay where they are.
pub(super) const UNDETERMINED_FORCE: f64 = 1e-12;

/// Part by which friction must exceed μ r_N to count as outside the cone.
///
/// Smaller, the rounding of a projection counts as outside; larger, violations that a caller sees are left.
pub(super) const OUTSIDE_CONE: f64 = 1e-13;

/// Relative error allowed for in a proof: of sums that were rounded once, and a few operations more.
///
/// Smaller, a proof could be wrong; larger, proofs of contacts at the edge of their cones are refused.
pub(super) const PROOF_ROUNDING: f64 = 8.0 * 1e-15;

/// Largest number of rows of a polygon's complementarity problem for which facets come first.
///
/// Lemke's method takes milliseconds then, and in the plane it decides. Larger, it takes longer than Newton's method.
pub(super) const MOST_ROWS_FACETS_FIRST: usize = 160;
