//! Work on one core, where there are no threads (without the feature `parallel`): the same questions as in `cores`, one after the other.

use crate::prelude::*;

/// `f` of every item, answers in the order of the items.
pub(crate) fn in_order<T: Sync, R: Send>(items: &[T], f: &(impl Fn(&T) -> R + Sync)) -> Vec<R> {
    items.iter().map(f).collect()
}

/// Does something with each of the items, which it takes.
pub(crate) fn each_taken<T: Send>(items: impl Iterator<Item = T>, f: &(impl Fn(T) + Sync)) {
    items.for_each(f);
}

/// Both results.
pub(crate) fn both<R: Send>(a: impl FnOnce() -> R + Send, b: impl FnOnce() -> R + Send) -> (R, R) {
    (a(), b())
}
