//! Lists that are refilled in their own memory.

use crate::prelude::*;

/// Empties a list and makes room for a number of entries. A larger allocation is exact: growing a list while it is filled takes longer.
#[inline]
pub(crate) fn cleared_for<T>(list: &mut Vec<T>, entries: usize) {
    if list.capacity() < entries {
        *list = Vec::with_capacity(entries);
    } else {
        list.clear();
    }
}
