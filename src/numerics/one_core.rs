//! The functions of `cores` without the feature `parallel`: work on one core, item by item.

use crate::numerics::mapped;
use crate::prelude::*;

/// Results of `f` for all items, in the order of the items.
pub(crate) fn in_order<T: Sync, R: Send>(items: &[T], f: &(impl Fn(&T) -> R + Sync)) -> Vec<R> {
    mapped(items, &f)
}

/// Calls `f` with each item by value.
pub(crate) fn each_taken<T: Send>(items: impl Iterator<Item = T>, f: &(impl Fn(T) + Sync)) {
    items.for_each(f);
}

/// Results of both functions, called one after the other.
pub(crate) fn both<R: Send>(a: impl FnOnce() -> R + Send, b: impl FnOnce() -> R + Send) -> (R, R) {
    (a(), b())
}
