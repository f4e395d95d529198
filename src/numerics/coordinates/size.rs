//! The number of coordinates.

use super::indices::Indices;

/// The number of coordinates: 3 of one object in the plane, 6 of one in space, then those of joints and of other bodies.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Size(usize);

/// Coordinates of one object in space. Vectors and matrices over up to as many lie in place, and their loops have this fixed length, with zeros in the
/// plane: sums of zeros cost less than a length that the compiler does not know.
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
