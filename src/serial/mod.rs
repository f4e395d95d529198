//! Text forms of numbers: words for numbers that are not finite, rows with one number per axis, and fields made of numbers (feature `serde`).
//!
//! Answers derive their text form with serde; `#[serde(with = "AsComputed::<T>")]` marks a field that consists of numbers.

mod fields;
mod numbers;
pub(crate) mod object;
mod rows;
#[cfg(feature = "schema")]
mod schema_as_written;
mod text_space;

#[cfg(feature = "schema")]
pub(crate) use fields::{As, Numeric};
pub(crate) use fields::{AsComputed, AsGiven, is_absent};
#[cfg(feature = "schema")]
pub(crate) use numbers::Kind;
pub(crate) use numbers::{Computed, Friction, Given, Number, SpringStiffness};
pub(crate) use rows::{AxisRow, ShortList};
#[cfg(feature = "schema")]
pub(crate) use schema_as_written::schema_as_written;
pub(crate) use text_space::{in_text_of, space_of_text};
