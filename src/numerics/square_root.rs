//! The square root under another name. A trait of number types that has its own method `sqrt` calls this function, because `x.sqrt()` inside the
//! trait could mean that method.

#[cfg(not(feature = "std"))]
use crate::prelude::*;

#[inline(always)]
pub(crate) fn square_root(x: f64) -> f64 {
    x.sqrt()
}
