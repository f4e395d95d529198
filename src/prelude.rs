//! What the prelude of std has and that of core lacks. A file that uses any of it imports all of it, so that it compiles without std, too.
//!
//! Lists, texts and boxes come from `alloc`, with std and without it. Functions of floating point are std's own wherever there is std: a file that
//! uses them and nothing else from here imports them without std only.

pub(crate) use alloc::borrow::ToOwned;
pub(crate) use alloc::boxed::Box;
pub(crate) use alloc::string::{String, ToString};
pub(crate) use alloc::vec::Vec;

#[cfg(not(feature = "std"))]
pub(crate) use crate::numerics::FloatFunctions;
