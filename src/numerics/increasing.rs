//! Sorting by a number, with one sort that is compiled once.

use crate::numerics::IntoList;
use crate::prelude::*;

/// The indices of these values from the lowest to the highest; equal values keep their order. For the reverse order, negate the values.
pub(crate) fn increasing(values: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..values.len()).list();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    order
}
