//! Vectors and matrices over the coordinates of a grasp, however many these are.
//!
//! The plane has 3 coordinates and space 6: [`Fixed`] leaves their arithmetic to nalgebra. A hand has [`Any`] number of them. Its vectors are lists
//! behind whose end all components are zero, so that zero needs no length.

mod list;
mod map;
mod map_entries;
mod seen;
mod size;
mod square;
mod sums;
mod vector;

pub(crate) use map::Map;
pub(crate) use seen::Seen;
pub(crate) use size::{Any, Fixed, Size};
pub(crate) use square::Square;
pub(crate) use vector::Vector;
