//! Lists that are filled anew in memory that is there.

use crate::prelude::*;

/// Empties a list that will hold so many entries. One without that much memory is asked for exactly: growing it as it is filled takes longer.
#[inline]
pub(crate) fn cleared_for<T>(list: &mut Vec<T>, entries: usize) {
    if list.capacity() < entries {
        *list = Vec::with_capacity(entries);
    } else {
        list.clear();
    }
}
