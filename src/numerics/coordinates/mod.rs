//! Vectors and matrices over the coordinates of a grasp, for any number of them.
//!
//! The plane has 3 coordinates and space 6: [`Fixed`] leaves their arithmetic to nalgebra. A hand has [`Any`] number of coordinates, and its vectors
//! are lists. Components behind the end of a list are zero, so the zero vector needs no length.

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
