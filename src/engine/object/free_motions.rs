//! Motions of the object that no spring resists.

use super::tolerances::NO_WORK;
use crate::numerics::Vector;

/// The unit motion along which the load `wrench` does the most work, among the motions that no spring resists. `free` is an orthonormal basis of
/// these motions. `None` if the load does no work along them, up to rounding.
pub(crate) fn motion_of_work(free: &[Vector], wrench: &Vector) -> Option<Vector> {
    let along = free.iter().fold(Vector::zeros(), |sum: Vector, v| sum + v * v.dot(wrench));
    let work = along.norm();
    (work > NO_WORK * wrench.norm()).then(|| along / work)
}
