//! Parallel work on a list of items that reports its progress and can be stopped.

use core::ops::ControlFlow;
use core::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use super::in_order::map_in_order;
use crate::prelude::*;

/// The progress of [`map_watched`] after one more result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Progress {
    /// Number of items whose result has been computed so far.
    pub answered: usize,
    /// Number of all items.
    pub of: usize,
}

/// The results of `f` for all items, in the order of the items. After every result `watch` is called on the thread that computed it; the number of
/// results in its argument takes every value from 1 on once. If `watch` returns `Break`, items that were not begun have the result `None`. Which
/// items have no result depends on the threads; the results of all other items do not.
///
/// ```
/// use std::ops::ControlFlow;
/// use grasp_lcp::sweep::map_watched;
///
/// let squares = map_watched(&[1, 2, 3], |x| x * x, |progress| {
///     eprint!("\r{} of {}", progress.answered, progress.of);
///     ControlFlow::Continue(())
/// });
/// assert_eq!(squares, [Some(1), Some(4), Some(9)]);
/// ```
pub fn map_watched<T: Sync, R: Send>(
    items: &[T],
    f: impl Fn(&T) -> R + Sync + Send,
    watch: impl Fn(Progress) -> ControlFlow<()> + Sync + Send,
) -> Vec<Option<R>> {
    let (answered, stopped) = (AtomicUsize::new(0), AtomicBool::new(false));
    map_in_order(items, |item| {
        if stopped.load(Ordering::Relaxed) {
            return None;
        }
        let answer = f(item);
        let answered = answered.fetch_add(1, Ordering::Relaxed) + 1;
        if watch(Progress { answered, of: items.len() }).is_break() {
            stopped.store(true, Ordering::Relaxed);
        }
        Some(answer)
    })
}
