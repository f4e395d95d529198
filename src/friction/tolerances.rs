//! Tolerances of the solvers of frictional contact problems.
//!
//! All tolerances are without units: forces are compared with forces, and relative velocities `W r + q` with their terms. Here r are the contact
//! forces, W is the matrix from forces to velocities, and q are the velocities without contact forces. ε = 2⁻⁵². The central path leads through the
//! interior of the friction cones to a solution, as its parameter τ decreases to zero. At a fold of the path τ increases again. Limits for problems
//! that are dominated by rounding are in `lcp::tolerances`.

/// Residual, relative to the norm of its terms, at which a round of anchored Newton steps (with a proximal term) has converged.
///
/// If smaller, rounds that stop at rounding count as failed, and the proximal term grows; if larger, later rounds start from worse forces.
pub(super) const ROUND_CONVERGED: f64 = 1e-14;

/// If the residual of forces is below this number, final Newton steps without a proximal term (the polish) follow. Newton steps with a proximal term
/// then divide the residual of each contact by the magnitude of its own force and velocity. Contacts with small forces thus count as much as others.
/// Above this number residuals are weighed as energies.
///
/// If smaller, more rounds with a proximal term are made than necessary; if larger, the final Newton steps start where they do not converge.
pub(super) const WORTH_POLISHING: f64 = 1e-6;

/// Lower limit of the weight δ of the proximal term in the linear equations of a Newton step. It is relative to the contact's diagonal block of the
/// matrix W. The proximal term makes the equations of redundant contacts regular, although their forces are not determined.
///
/// With this limit, the undetermined force components are accurate to half of the digits, all others to all digits. With a smaller limit the
/// equations become singular.
pub(super) const LEAST_ANCHOR: f64 = 1e-12;

/// Along the central path a multiple of the identity is added to each contact's diagonal block of the matrix W. This number is the ratio of that
/// multiple to 1/ρ, where the factor ρ of the contact converts velocities to forces. The addition makes the equations of redundant contacts regular.
///
/// If smaller, equations are singular inside the cones; if larger, the forces at the end of the path solve a visibly different problem.
pub(super) const SHIFTED_BLOCK: f64 = 1e-9;

/// A point counts as on the central path if the root mean square of the residuals is at most this fraction of √τ, with the parameter τ of the path.
/// This limit serves where the path is followed around its folds.
///
/// If smaller, each step needs more corrections; if larger, the path jumps to another branch.
pub(super) const ON_CENTRAL_PATH: f64 = 1e-2;

/// A Newton step does not change a force whose pivot in the linear equations is below this fraction of the largest pivot. Such small pivots belong to
/// redundant contacts, whose forces are not determined.
///
/// If smaller, undetermined forces follow rounding; if larger, determined forces of soft contacts are not updated.
pub(super) const UNDETERMINED_FORCE: f64 = 1e-12;

/// The friction limit of a contact is μ r_N, for a normal force r_N. A force counts as outside its cone if its friction exceeds this limit by more
/// than this fraction of the limit.
///
/// If smaller, the rounding of a projection counts as outside; if larger, visible violations remain.
pub(super) const OUTSIDE_CONE: f64 = 1e-13;

/// Bound of the relative rounding error of a number on which a proof rests. The number comes from sums that are exact until they are rounded once,
/// and from a few further operations.
///
/// If smaller, a proof could be wrong; if larger, valid proofs are refused whose inequality holds at some contact with hardly any margin.
pub(super) const PROOF_ROUNDING: f64 = 8.0 * 1e-15;

/// Up to this number of rows, Lemke's method comes first, for the complementarity problem with polygons in place of the cones. Above it, the
/// iterative methods come first.
///
/// Up to this number Lemke's method takes milliseconds, and in the plane it decides the problem. With more rows it takes longer than the iterative
/// methods.
pub(super) const MOST_ROWS_FACETS_FIRST: usize = 160;
