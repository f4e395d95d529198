//! Vectors that keep their memory from one problem to the next.

use crate::prelude::*;

/// Makes a vector n copies of a value.
#[inline]
pub(super) fn refill<T: Clone>(v: &mut Vec<T>, n: usize, value: T) {
    v.clear();
    v.resize(n, value);
}

/// Gives a vector room for n entries in all.
#[inline]
pub(super) fn make_room<T>(v: &mut Vec<T>, n: usize) {
    v.reserve(n.saturating_sub(v.len()));
}
