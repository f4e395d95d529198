//! The square root under another name. A number trait whose own method is called `sqrt` uses it, because a call of `sqrt` in it may mean that method.

#[cfg(not(feature = "std"))]
use crate::prelude::*;

#[inline(always)]
pub(crate) fn square_root(x: f64) -> f64 {
    x.sqrt()
}
