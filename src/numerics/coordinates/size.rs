//! The number of coordinates.

use super::indices::Indices;

/// The number of coordinates: 3 for one object in the plane, 6 in space, plus the coordinates of joints and other bodies.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Size(usize);

/// Number of coordinates of one object in space. Vectors and matrices of up to this many coordinates are stored in place, and their loops have
/// this fixed length, with zeros in the plane. Adding zeros costs less than a length that the compiler does not know.
pub(crate) const WHOLE: usize = 6;

impl Size {
    #[inline]
    pub(crate) const fn of(count: usize) -> Self {
        Self(count)
    }

    #[inline]
    pub(crate) const fn count(self) -> usize {
        self.0
    }

    /// The identity permutation.
    pub(crate) fn in_order(self) -> Indices {
        Indices::in_order(self.0)
    }
}
