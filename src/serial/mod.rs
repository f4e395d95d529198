//! Numbers as text has them: words for those that are not finite, rows of as many as there are axes, and fields made of them (feature `serde`).
//!
//! An answer is written as it is declared. Its declaration says `#[serde(with = "AsComputed::<T>")]` of a field that is made of numbers.

mod fields;
mod numbers;
mod rows;

#[cfg(feature = "schema")]
pub(crate) use fields::{As, Numeric};
pub(crate) use fields::{AsComputed, AsGiven};
#[cfg(feature = "schema")]
pub(crate) use numbers::Kind;
pub(crate) use numbers::{Computed, Friction, Given, Number, SpringStiffness};
pub(crate) use rows::{AxisRow, Few};
