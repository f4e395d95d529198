//! A load on the object to twice the working precision.

use nalgebra::SVector;

/// A load in inside coordinates, and what rounding took from it when it was moved to the centroid.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Load<const D: usize> {
    pub(crate) wrench: SVector<f64, D>,
    pub(crate) rest: SVector<f64, D>,
}

impl<const D: usize> From<&SVector<f64, D>> for Load<D> {
    fn from(wrench: &SVector<f64, D>) -> Self {
        Self { wrench: *wrench, rest: SVector::zeros() }
    }
}
