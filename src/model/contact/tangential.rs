//! The tangential part of a vector in a contact frame.

use nalgebra::SVector;

use crate::numerics::Reals;
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// The vector without its normal component.
#[inline(always)]
pub(crate) fn tangential(v: &SVector<f64, 3>) -> SVector<f64, 3> {
    let mut t = *v;
    t[0] = 0.0;
    t
}

/// The length of the tangential part. It is correct even if its square underflows: the force of a contact that hardly presses may be that small.
#[inline(always)]
pub(crate) fn tangential_norm(v: &SVector<f64, 3>) -> f64 {
    let square: f64 = v.iter().skip(1).map(|x| x * x).added();
    // Squares between this number and its reciprocal lose no digits by underflow or overflow.
    let safe_square = 1e-280;
    if (safe_square..1.0 / safe_square).contains(&square) {
        square.sqrt()
    } else {
        v.iter().skip(1).fold(0.0, |h: f64, x| h.hypot(*x))
    }
}

/// Normal component of the cross product `a × b` of two tangents in space.
#[inline(always)]
pub(crate) fn cross(a: &SVector<f64, 3>, b: &SVector<f64, 3>) -> f64 {
    a[1] * b[2] - a[2] * b[1]
}

/// A tangent in space turned by a right angle, `e_n × t`.
#[inline]
pub(crate) fn right_angle(t: &SVector<f64, 3>) -> SVector<f64, 3> {
    let mut turned = SVector::<f64, 3>::zeros();
    (turned[1], turned[2]) = (-t[2], t[1]);
    turned
}
