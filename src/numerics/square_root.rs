//! The square root under another name, for use in a number trait whose own method is called `sqrt`.

#[cfg(not(feature = "std"))]
use crate::prelude::*;

#[inline(always)]
pub(crate) fn square_root(x: f64) -> f64 {
    x.sqrt()
}
