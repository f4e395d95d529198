//! Limits at which the answer of screening is called unclear.
//!
//! All of them are dimensionless. Screening computes each answer in a single pass; where refinement would be needed, the verdict is unclear.

/// A contact may be on the edge of its cone if its margin at load factor zero is below this fraction of the forces.
///
/// If smaller, rounding would decide whether it sticks. If larger, more grasps would be unclear.
pub(super) const ON_THE_EDGE: f64 = 1e-12;

/// If more than this fraction of the load stays unbalanced, and some motion is free, the load works on that motion.
///
/// If the load does not work on it, only rounding stays unbalanced. If larger, a load that drives the object away weakly would be called unclear.
pub(super) const WORKS_ON_FREE_MOTION: f64 = 1e-6;

/// Forces whose residual exceeds this fraction of the load are refined. Rounding alone leaves about 1e-15.
///
/// If smaller, refinement would gain nothing. If larger, the force of a soft contact beside a stiff one would lose digits.
pub(super) const IMPROVABLE: f64 = 1e-14;

/// A margin must fall with the load at a rate of at least this multiple of the rounding of the rate.
///
/// A slower margin vanishes at a load factor of fewer than six digits, and the verdict is unclear. If larger, more grasps would be unclear.
pub(super) const SHARP_MARGIN: f64 = 1e6;

/// Lower bound of `|F| |F'|` for margins in space: below it squares underflow and lose their digits, and the answer is unclear.
pub(super) const LEAST_PRODUCT: f64 = 1e-140;

/// Upper bound of `|F| |F'|` for margins in space: above it squares overflow, and the answer is unclear.
pub(super) const MOST_PRODUCT: f64 = 1e150;
