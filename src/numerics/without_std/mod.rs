//! Replacements for parts of std, for targets without it.
//!
//! | file | idea |
//! |---|---|
//! | `float_functions` | floating-point functions, from `libm` |
//! | `once` | values that are computed once, for all threads |

mod float_functions;
mod once;

#[cfg(not(feature = "std"))]
pub(crate) use float_functions::FloatFunctions;
#[cfg(not(feature = "std"))]
pub(crate) use once::Once;
