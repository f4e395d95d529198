//! Refilling of lists in their own memory.

use crate::prelude::*;

/// Empties a list and reserves capacity for this number of entries at once, since growing a list while it is filled takes longer.
#[inline]
pub(crate) fn cleared_for<T>(list: &mut Vec<T>, entries: usize) {
    if list.capacity() < entries {
        *list = Vec::with_capacity(entries);
    } else {
        list.clear();
    }
}
