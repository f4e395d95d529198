//! Sums and products of lists, entry by entry and in place.

use core::ops::{AddAssign, Mul};

/// Adds each entry of `more`, multiplied by `times`, to the entry of `to` at the same place.
pub(crate) fn add_times<T: AddAssign + Copy + Mul<f64, Output = T>>(to: &mut [T], more: &[T], times: f64) {
    for (to, more) in to.iter_mut().zip(more) {
        *to += *more * times;
    }
}

/// Multiplies each entry of `list` by `factor`.
pub(crate) fn scale(list: &mut [f64], factor: f64) {
    for entry in list {
        *entry *= factor;
    }
}

/// Multiplies each entry of `list` by the factor at the same place.
pub(crate) fn scale_each(list: &mut [f64], factors: &[f64]) {
    for (entry, factor) in list.iter_mut().zip(factors) {
        *entry *= factor;
    }
}
