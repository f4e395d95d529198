//! Vectors and matrices over the coordinates of a grasp, whose number is known at run time.
//!
//! One object has 3 coordinates in the plane and 6 in space; joints and other bodies add further coordinates. Data of up to 6 coordinates are stored
//! in place, with loops of fixed length. A vector is a list whose components beyond its end are zero, so the zero vector needs no length.

mod indices;
mod list;
mod map;
mod map_entries;
mod products;
mod size;
mod square;
mod sums;
mod vector;

pub(crate) use indices::Indices;
pub(crate) use map::Map;
pub(crate) use size::{Size, WHOLE};
pub(crate) use square::Square;
pub(crate) use vector::Vector;
