//! The component of a vector orthogonal to an orthonormal set.

use super::coordinates::Vector;

/// v minus its projection on an orthonormal set, subtracted once. Rounding may leave a small component along the set.
pub(crate) fn without(mut v: Vector, basis: &[Vector]) -> Vector {
    for b in basis {
        let along = b.dot(&v);
        v -= b * along;
    }
    v
}

/// v minus its projection on an orthonormal set. The projection is subtracted twice, so that rounding leaves
/// no component along the set.
pub(crate) fn orthogonal_part(v: Vector, basis: &[Vector]) -> Vector {
    without(without(v, basis), basis)
}

/// Makes v a unit vector orthogonal to an orthonormal set; the projection is subtracted twice.
pub(crate) fn orthonormalise_against(v: &mut Vector, basis: &[Vector]) {
    *v = orthogonal_part(core::mem::take(v), basis);
    let norm = v.norm();
    if norm > 0.0 {
        *v /= norm;
    }
}
