//! Inside coordinates as an answer keeps them, whatever their number.

use nalgebra::SVector;

use super::rotation::of_the_object;

/// Coordinates of the object and of the joints behind them. Without joints nothing is allocated.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Coordinates<const C: usize> {
    object: SVector<f64, 6>,
    joints: Vec<f64>,
}

impl<const C: usize> Coordinates<C> {
    pub(crate) fn of<const D: usize>(coordinates: &SVector<f64, D>) -> Self {
        Self::of_in(coordinates, Vec::new())
    }

    /// [`Self::of`] in a list that is there.
    pub(crate) fn of_in<const D: usize>(coordinates: &SVector<f64, D>, mut joints: Vec<f64>) -> Self {
        let (of_object, of_joints) = coordinates.as_slice().split_at(of_the_object::<C>());
        joints.clear();
        joints.extend_from_slice(of_joints);
        let mut object = SVector::<f64, 6>::zeros();
        object.as_mut_slice()[..of_object.len()].copy_from_slice(of_object);
        Self { object, joints }
    }

    /// As D coordinates; zeros behind those that there are.
    pub(crate) fn to<const D: usize>(&self) -> SVector<f64, D> {
        let mut coordinates = SVector::<f64, D>::zeros();
        let (of_object, of_joints) = coordinates.as_mut_slice().split_at_mut(of_the_object::<C>());
        of_object.copy_from_slice(&self.object.as_slice()[..of_the_object::<C>()]);
        of_joints.iter_mut().zip(&self.joints).for_each(|(to, from)| *to = *from);
        coordinates
    }

    /// Its list, for other coordinates.
    pub(crate) fn take_list(&mut self) -> Vec<f64> {
        std::mem::take(&mut self.joints)
    }
}
