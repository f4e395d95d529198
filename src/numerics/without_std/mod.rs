//! What std does for the rooms above, where there is none.
//!
//! | file | idea |
//! |---|---|
//! | `float_functions` | functions of floating point, from `libm` |
//! | `once` | what is made once, for all threads |

mod float_functions;
mod once;

#[cfg(not(feature = "std"))]
pub(crate) use float_functions::FloatFunctions;
#[cfg(not(feature = "std"))]
pub(crate) use once::Once;
