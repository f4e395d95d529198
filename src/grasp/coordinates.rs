//! Inside coordinates as answers store them, for any number of coordinates.

use nalgebra::SVector;

use super::rotation::of_the_object;
use crate::numerics::Vector;
use crate::prelude::*;

/// Inside coordinates of the object and of the joints behind it. Without joints nothing is allocated.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Coordinates<const C: usize> {
    object: SVector<f64, 6>,
    joints: Vec<f64>,
}

impl<const C: usize> Coordinates<C> {
    pub(crate) fn of(coordinates: &Vector) -> Self {
        Self::of_in(coordinates, Vec::new())
    }

    /// [`Self::of`] in the memory of `joints`.
    pub(crate) fn of_in(coordinates: &Vector, mut joints: Vec<f64>) -> Self {
        let all = coordinates.as_slice();
        let (of_object, of_joints) = all.split_at(of_the_object::<C>().min(all.len()));
        joints.clear();
        joints.extend_from_slice(of_joints);
        let mut object = SVector::<f64, 6>::zeros();
        object.as_mut_slice()[..of_object.len()].copy_from_slice(of_object);
        Self { object, joints }
    }

    /// As coordinates of this size, with zeros behind the stored ones.
    pub(crate) fn to(&self) -> Vector {
        let mut coordinates = Vector::zeros();
        let of_object = self.object.iter().take(of_the_object::<C>());
        for (k, x) in of_object.chain(&self.joints).enumerate() {
            coordinates[k] = *x;
        }
        coordinates
    }

    /// Takes out the list of joints, so that its memory can be used again.
    pub(crate) fn take_list(&mut self) -> Vec<f64> {
        core::mem::take(&mut self.joints)
    }
}
