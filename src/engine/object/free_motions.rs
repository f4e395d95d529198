//! Motions of the object that no spring resists.

use super::tolerances::NO_WORK;
use crate::numerics::Vector;

/// The unit motion along which the load does the most work, in the span of the orthonormal motions `free`, along which no spring pushes. `None` if
/// that work is zero up to rounding.
pub(crate) fn motion_of_work(free: &[Vector], wrench: &Vector) -> Option<Vector> {
    let along = free.iter().fold(Vector::zeros(), |sum: Vector, v| sum + v * v.dot(wrench));
    let work = along.norm();
    (work > NO_WORK * wrench.norm()).then(|| along / work)
}
