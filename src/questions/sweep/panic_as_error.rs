//! Turns a panic in the answer for one item, such as a grasp of a sweep, into an error of that item. All other items are still answered. A panic is a
//! fault of this library.

use super::in_order::map_in_order;
use crate::error::Error;
use crate::prelude::*;

/// The results of `ask` for all items, in the order of the items and possibly in parallel. An error or a panic for one item does not stop the other
/// items.
pub(crate) fn each_answered<T: Sync, R: Send>(
    items: &[T],
    ask: &(dyn Fn(&T) -> Result<R, Error> + Sync),
) -> Vec<Result<R, Error>> {
    map_in_order(items, |item| caught(&|| ask(item)))
}

/// The result of `ask`, or [`Error::Internal`] if `ask` panics.
pub(crate) fn caught<R>(ask: &dyn Fn() -> Result<R, Error>) -> Result<R, Error> {
    let mut answer = None;
    let fault = fault_in(&mut || answer = Some(ask()));
    fault.map_or_else(
        || answer.unwrap_or(Err(Error::Internal { fault: String::new() })),
        |fault| Err(Error::Internal { fault }),
    )
}

/// Runs `work` and returns the message of its panic; `None` if it does not panic. The version of this function for builds without the standard
/// library catches no panic.
#[cfg(feature = "std")]
pub(crate) fn fault_in(work: &mut dyn FnMut()) -> Option<String> {
    let panic = std::panic::catch_unwind(std::panic::AssertUnwindSafe(work)).err()?;
    let said = panic.downcast_ref::<String>().map(String::as_str);
    Some(said.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("no message").to_owned())
}

/// Runs `work` and returns `None`. Without the standard library a panic is not caught.
#[cfg(not(feature = "std"))]
fn fault_in(work: &mut dyn FnMut()) -> Option<String> {
    work();
    None
}
