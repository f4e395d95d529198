//! The square root by a name of its own, for a trait of numbers that calls its own by that of std.

#[cfg(not(feature = "std"))]
use crate::prelude::*;

#[inline(always)]
pub(crate) fn square_root(x: f64) -> f64 {
    x.sqrt()
}
