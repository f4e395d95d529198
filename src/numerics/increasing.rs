//! The order of anything by a number: one sort, compiled once.

use crate::numerics::IntoList;
use crate::prelude::*;

/// The positions of these values from the lowest to the highest; equal values keep their order. With the values negated, from the highest to the
/// lowest.
pub(crate) fn increasing(values: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..values.len()).list();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    order
}
