//! Displacements of object, joints and bodies in the engine's coordinates, in the form in which answers store them. In these coordinates every angle
//! is multiplied by a reference length.

use nalgebra::SVector;

use crate::numerics::{Vector, WHOLE};
use crate::prelude::*;

/// Coordinates of the object, then coordinates of joints and of other bodies, all in the engine's units. Up to six coordinates are stored without
/// allocation.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Coordinates {
    count: usize,
    /// The first six coordinates; unused components are zero. The other coordinates are in `more`.
    first: SVector<f64, WHOLE>,
    more: Vec<f64>,
}

impl Coordinates {
    pub(crate) fn of(coordinates: &Vector) -> Self {
        Self::of_in(coordinates, Vec::new())
    }

    /// The coordinates in the form in which answers store them. The list `more`, whose storage is used again, receives the coordinates beyond the
    /// first six.
    pub(crate) fn of_in(coordinates: &Vector, mut more: Vec<f64>) -> Self {
        let all = coordinates.as_slice();
        let (in_place, others) = all.split_at(WHOLE.min(all.len()));
        more.clear();
        more.extend_from_slice(others);
        let mut first = SVector::<f64, WHOLE>::zeros();
        first.as_mut_slice()[..in_place.len()].copy_from_slice(in_place);
        Self { count: all.len(), first, more }
    }

    /// The coordinates as the vector type with which the engine computes.
    pub(crate) fn to(&self) -> Vector {
        let mut coordinates = Vector::zeros();
        let in_place = self.first.iter().take(self.count);
        for (k, x) in in_place.chain(&self.more).enumerate() {
            coordinates[k] = *x;
        }
        coordinates
    }

    /// Moves out the list `more`, which holds the coordinates beyond the first six, so that its storage can be used again.
    pub(crate) fn take_list(&mut self) -> Vec<f64> {
        core::mem::take(&mut self.more)
    }
}
