//! The influence of a force at a point, of any direction, on each contact.

use nalgebra::{SMatrix, SVector};

use crate::contact::ZERO_SLACK;
use crate::equilibrium::StickingResponse;
use crate::grasp::{Motion, Wrench};
use crate::prelude::*;

/// The matrix A of a contact: its force by 1 N along each coordinate axis, column by column.
pub(super) struct Influence {
    pub(super) of: SMatrix<f64, 3, 3>,
    /// Sum of the sizes of its columns.
    pub(super) size: f64,
}

impl Influence {
    /// `Aᵀa`: the decrease of a condition by 1 N against each axis; zero where it is rounding.
    pub(super) fn felt(&self, row: &SVector<f64, 3>) -> SVector<f64, 3> {
        let felt = self.of.tr_mul(row);
        if felt.norm() > ZERO_SLACK * row.norm() * self.size { felt } else { SVector::zeros() }
    }
}

/// The influence of forces through a point on each contact, or a motion on which one works though nothing resists it.
pub(super) fn influences(
    sticking: &StickingResponse<'_>,
    point: &[f64; 3],
) -> Result<Vec<Influence>, Motion<3>> {
    let mut influences = Vec::new();
    influences.resize_with(sticking.edges.len(), || Influence { of: SMatrix::zeros(), size: 0.0 });
    for axis in 0..3 {
        let unit = core::array::from_fn(|k| if k == axis { 1.0 } else { 0.0 });
        let forces = sticking.by_load(&push(point, &unit))?;
        for ((influence, force), size) in influences.iter_mut().zip(&forces.of).zip(forces.sizes) {
            influence.of.set_column(axis, force);
            influence.size += size;
        }
    }
    Ok(influences)
}

/// A force at a point.
pub(super) fn push(point: &[f64; 3], force: &[f64; 3]) -> Wrench<3> {
    Wrench::force_through(&SVector::from(*point), &SVector::from(*force))
}
