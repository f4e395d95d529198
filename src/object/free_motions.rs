//! Motions of the object that no spring resists.

use crate::numerics::Vector;

/// A load that does less work than this part of its size on a unit free motion does none. Loads
/// that were computed to balance carry rounding of about 1e-16. A larger value would neglect loads
/// that drive the object off.
pub(super) const NO_WORK: f64 = 1e-13;

/// The unit motion, among orthonormal ones that nothing resists, on which a load works.
pub(crate) fn worked_on(free: &[Vector], wrench: &Vector) -> Option<Vector> {
    let along = free.iter().fold(Vector::zeros(), |sum: Vector, v| sum + v * v.dot(wrench));
    let work = along.norm();
    (work > NO_WORK * wrench.norm()).then(|| along / work)
}
