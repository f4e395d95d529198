//! Unit vectors along an axis.

use crate::numerics::by_axis;
use nalgebra::SVector;

pub(crate) fn unit<const N: usize>(axis: usize) -> SVector<f64, N> {
    by_axis(|a| f64::from(u8::from(a == axis)))
}
