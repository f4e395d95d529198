//! Unit vectors along an axis.

use nalgebra::SVector;

/// The unit vector along an axis.
pub(crate) fn unit<const N: usize>(axis: usize) -> SVector<f64, N> {
    SVector::from_fn(|a, _| f64::from(u8::from(a == axis)))
}
