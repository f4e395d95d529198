//! Tolerances with which screening calls an answer unclear, or refines contact forces. Screening computes, for many grasps, the load factor at which
//! the first contact ceases to stick, or the least factor on the commands with which all contacts stick.
//!
//! All of them but the bounds of products are dimensionless. The margin of a contact is `μ F_n - |F_t|`; it is positive while the contact sticks. F'
//! is the rate of a contact force F, per unit of the load factor, or of the factor on the commands that is sought. If more than a few refinements of
//! the forces would be needed, the answer is unclear.

/// A contact force may be on the boundary of its friction cone if its margin at load factor zero is below this fraction of the sum of two magnitudes.
/// One is that of the contact force. The other is that of the spring forces of which the contact force is the difference.
///
/// If this were smaller, rounding would determine whether the contact sticks. If it were larger, more grasps would be unclear.
pub(super) const ON_THE_EDGE: f64 = 1e-12;

/// If no spring resists some motion and more than this fraction of the load stays unbalanced, the load is taken to do work along that motion.
///
/// If the load does no work along the motion, only rounding stays unbalanced. If this limit were larger, a load that drives the object away weakly
/// would be called unclear.
pub(super) const WORKS_ON_FREE_MOTION: f64 = 1e-6;

/// Contact forces are refined if the load that they leave unbalanced exceeds this fraction of all forces and loads. Rounding alone leaves about
/// 1e-15.
///
/// If this were smaller, refinement would gain nothing. If it were larger, the force of a soft contact would lose digits if another contact is stiff.
pub(super) const IMPROVABLE: f64 = 1e-14;

/// The rate at which a margin decreases, per unit of the sought factor on load or commands, must be at least this multiple of the rounding error of
/// the rate.
///
/// If a margin decreases more slowly, fewer than six digits of the factor at which it vanishes are right, and the answer is unclear. If this number
/// were larger, more grasps would be unclear.
pub(super) const SHARP_MARGIN: f64 = 1e6;

/// Least accepted product, N², of the magnitude of a contact force and the magnitude of its rate, for contacts in space:
/// `(μ|F_n| + |F_t|) (μ|F_n'| + |F_t'|)`. If the product is smaller, squares of forces underflow and lose digits, and the answer is unclear.
pub(super) const LEAST_PRODUCT: f64 = 1e-140;

/// Largest accepted product, N², of the magnitude of a contact force and the magnitude of its rate, for contacts in space:
/// `(μ|F_n| + |F_t|) (μ|F_n'| + |F_t'|)`. If the product is larger, squares of forces overflow, and the answer is unclear.
pub(super) const MOST_PRODUCT: f64 = 1e150;
