//! Parallel work on a list of items, with results in the order of the items.

use crate::numerics::in_order;
use crate::prelude::*;

/// The results of `f` for all items, in the order of the items: in parallel with the feature `parallel`, one after the other without it. A panic in
/// `f` reaches the caller.
///
/// ```
/// let squares = grasp_lcp::sweep::map_in_order(&[1, 2, 3], |x| x * x);
/// assert_eq!(squares, [1, 4, 9]);
/// ```
pub fn map_in_order<T: Sync, R: Send>(items: &[T], f: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    in_order(items, &f)
}
