//! Tolerances with which screening calls an answer unclear, or refines contact forces.
//!
//! All of them but the bounds of products are dimensionless. The margin of a contact is `μ F_n - |F_t|`; it is positive while the contact sticks. If
//! more than a few refinements of the forces would be needed, the verdict is unclear.

/// A contact may be on the edge of its friction cone if its margin at load factor zero is below this fraction of the forces: its contact force, and
/// the spring forces whose difference that is.
///
/// If this were smaller, rounding would determine whether the contact sticks. If larger, more grasps would be unclear.
pub(super) const ON_THE_EDGE: f64 = 1e-12;

/// If no spring resists some motion and more than this fraction of the load stays unbalanced, the load is taken to do work along that motion.
///
/// If the load does no work along the motion, only rounding stays unbalanced. If this limit were larger, a load that drives the object away weakly
/// would be called unclear.
pub(super) const WORKS_ON_FREE_MOTION: f64 = 1e-6;

/// Contact forces whose residual exceeds this fraction of the load and forces are refined. Rounding alone leaves about 1e-15.
///
/// If this were smaller, refinement would gain nothing. If larger, the force of a soft contact would lose digits if another contact is stiff.
pub(super) const IMPROVABLE: f64 = 1e-14;

/// The rate at which a margin decreases with the load must be at least this multiple of the rounding of the rate.
///
/// A margin that decreases more slowly vanishes at a load factor of fewer than six digits, and the verdict is unclear. If this number were larger,
/// more grasps would be unclear.
pub(super) const SHARP_MARGIN: f64 = 1e6;

/// Lower bound of `|F| |F'|`, scaled contact force times its rate, for margins in space. If the product is smaller, squares underflow and lose
/// digits, and the answer is unclear.
pub(super) const LEAST_PRODUCT: f64 = 1e-140;

/// Upper bound of `|F| |F'|`, scaled contact force times its rate, for margins in space. If the product is larger, squares overflow, and the answer
/// is unclear.
pub(super) const MOST_PRODUCT: f64 = 1e150;
