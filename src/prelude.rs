//! Names of std's prelude that core's prelude lacks. A file that uses one of these names imports all of them; it then also compiles without std.
//!
//! Lists, texts and boxes come from `alloc`, with std and without it. Floating-point functions are methods of f64 itself if std exists. A file that
//! needs nothing but floating-point functions therefore imports this module under `not(feature = "std")`.

pub(crate) use alloc::borrow::ToOwned;
pub(crate) use alloc::boxed::Box;
pub(crate) use alloc::string::{String, ToString};
pub(crate) use alloc::vec::Vec;

#[cfg(not(feature = "std"))]
pub(crate) use crate::numerics::FloatFunctions;
