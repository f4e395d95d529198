//! Helpers for scratch buffers: vectors that are used again from problem to problem.

use crate::prelude::*;

/// Replaces the contents of a vector by n copies of a value.
#[inline]
pub(super) fn refill<T: Clone>(v: &mut Vec<T>, n: usize, value: T) {
    v.clear();
    v.resize(n, value);
}

/// Reserves capacity for n entries in all.
#[inline]
pub(super) fn make_room<T>(v: &mut Vec<T>, n: usize) {
    v.reserve(n.saturating_sub(v.len()));
}
