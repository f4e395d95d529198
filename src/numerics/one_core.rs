//! Work on one core, without the feature `parallel`: the functions of `cores`, run one item after the other.

use crate::numerics::mapped;
use crate::prelude::*;

/// `f` of every item, with results in the order of the items.
pub(crate) fn in_order<T: Sync, R: Send>(items: &[T], f: &(impl Fn(&T) -> R + Sync)) -> Vec<R> {
    mapped(items, &f)
}

/// Calls `f` with each item, which it consumes.
pub(crate) fn each_taken<T: Send>(items: impl Iterator<Item = T>, f: &(impl Fn(T) + Sync)) {
    items.for_each(f);
}

/// The results of both functions.
pub(crate) fn both<R: Send>(a: impl FnOnce() -> R + Send, b: impl FnOnce() -> R + Send) -> (R, R) {
    (a(), b())
}
