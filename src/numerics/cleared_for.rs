//! Emptying of lists before they are filled again.

use crate::prelude::*;

/// Empties a list and makes room for this number of entries at once: growing a list while it is filled takes longer.
#[inline]
pub(crate) fn cleared_for<T>(list: &mut Vec<T>, entries: usize) {
    if list.capacity() < entries {
        *list = Vec::with_capacity(entries);
    } else {
        list.clear();
    }
}
