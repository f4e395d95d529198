//! Motions of the object that no spring resists.

use super::tolerances::NO_WORK;
use crate::numerics::Vector;

/// The unit motion, among orthonormal ones that nothing resists, on which a load works.
pub(crate) fn worked_on(free: &[Vector], wrench: &Vector) -> Option<Vector> {
    let along = free.iter().fold(Vector::zeros(), |sum: Vector, v| sum + v * v.dot(wrench));
    let work = along.norm();
    (work > NO_WORK * wrench.norm()).then(|| along / work)
}
