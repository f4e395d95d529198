//! The square root under a name of its own, for a number trait whose own method has the name of std's.

#[cfg(not(feature = "std"))]
use crate::prelude::*;

#[inline(always)]
pub(crate) fn square_root(x: f64) -> f64 {
    x.sqrt()
}
