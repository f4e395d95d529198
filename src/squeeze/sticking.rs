//! Forces of every site while all contacts stick, and the conditions of its cone: contacts first, then drives of a hand.

use nalgebra::SVector;

use crate::contact::{Edges, LocalLaw, Polygon, ZERO_SLACK};
use crate::grasp::{Engine, Motion, Wrench};
use crate::numerics::{Harmonic, Vector};
use crate::object::{Load, Piece, Problem};
use crate::prelude::*;
use crate::search::Settings;

/// A grasp whose contacts all stick.
pub(super) struct Sticking<'g, const C: usize> {
    pub(super) grasp: &'g Engine<C>,
    problem: Problem<'g, C>,
    piece: alloc::sync::Arc<Piece<C>>,
    pub(super) edges: Vec<Edges<C>>,
}

/// Forces contact by contact, and the sizes that scale their rounding.
#[derive(Debug, Clone)]
pub(super) struct ContactForces<const C: usize> {
    pub(super) of: Vec<SVector<f64, C>>,
    pub(super) sizes: Vec<f64>,
}

/// Changes at one contact by a force of 1 N along each coordinate axis.
pub(super) struct Push<const C: usize> {
    /// A, column by column.
    pub(super) columns: [SVector<f64, C>; C],
    /// Sum of the sizes of its columns.
    pub(super) size: f64,
}

impl<const C: usize> Push<C> {
    /// `Aᵀa`: the decrease of a condition by 1 N against each axis; zero where it is rounding.
    pub(super) fn felt(&self, row: &SVector<f64, C>) -> SVector<f64, C> {
        let felt = SVector::<f64, C>::from_fn(|k, _| self.columns[k].dot(row));
        if felt.norm() > ZERO_SLACK * row.norm() * self.size { felt } else { SVector::zeros() }
    }

    /// `Aᵀa` times a number, for the facets `a = (limit, -cos φ, -sin φ)` of a round cone as functions of φ.
    pub(super) fn turning(&self, limit: f64, times: f64) -> Harmonic<SVector<f64, C>> {
        round_parts::<C>(limit)
            .map(|&(part, axis)| SVector::from_fn(|k, _| times * part * self.columns[k][axis]))
    }
}

/// The facets of a round cone as functions of φ: the factor and the axis of a force in the constant, the cosine and the sine.
pub(super) fn round_parts<const C: usize>(limit: f64) -> Harmonic<(f64, usize)> {
    Harmonic { constant: (limit, 0), cosine: (-1.0, 1), sine: (-1.0, C - 1) }
}

impl<'g, const C: usize> Sticking<'g, C> {
    pub(super) fn new(grasp: &'g Engine<C>, settings: &Settings) -> Self {
        let polygon = Polygon::shared(&settings.cone);
        let nothing = Load::from(&Vector::zeros());
        let problem = grasp.problem(polygon, settings.is_round::<C>(), grasp.drives(), &nothing);
        let edges = problem.each(|local| local.edges());
        let piece = problem.trial();
        Self { grasp, problem, piece, edges }
    }

    /// The law of a contact.
    pub(super) fn law(&self, contact: usize) -> LocalLaw<'_, C> {
        self.problem.local(contact)
    }

    /// Forces with these drives under a load in inside coordinates, or a motion on which the load works though nothing resists it.
    pub(super) fn forces(
        &self,
        drives: &[SVector<f64, C>],
        load: &Vector,
    ) -> Result<ContactForces<C>, Motion<C>> {
        match self.piece.solve(self.problem.sites, drives, load) {
            Ok(state) => {
                let sizes = self.problem.force_sizes(drives, load.norm(), &state);
                Ok(ContactForces { of: state.forces, sizes })
            }
            Err(unbalanced) => {
                let motion = unbalanced.motion.unwrap_or_else(Vector::zeros);
                Err(self.grasp.motion_outside(&motion))
            }
        }
    }

    /// Changes at each contact by forces through a point.
    pub(super) fn pushes(&self, point: &[f64; C]) -> Result<Vec<Push<C>>, Motion<C>> {
        let at_rest = vec![SVector::zeros(); self.problem.len()];
        let mut pushes: Vec<_> =
            at_rest.iter().map(|_| Push { columns: [SVector::zeros(); C], size: 0.0 }).collect();
        for axis in 0..C {
            let along = push(point, &core::array::from_fn(|k| if k == axis { 1.0 } else { 0.0 }));
            let forces = self.forces(&at_rest, &self.grasp.inside_unchecked(&along))?;
            for ((push, force), size) in pushes.iter_mut().zip(forces.of).zip(forces.sizes) {
                push.columns[axis] = force;
                push.size += size;
            }
        }
        Ok(pushes)
    }
}

/// A force at a point.
pub(super) fn push<const C: usize>(point: &[f64; C], force: &[f64; C]) -> Wrench<C> {
    Wrench::force_through(&SVector::from(*point), &SVector::from(*force))
}

/// The row `(limit, -cos φ, -sin φ)` of a round cone.
pub(super) fn round_row<const C: usize>(limit: f64, angle: f64) -> SVector<f64, C> {
    let (sin, cos) = angle.sin_cos();
    SVector::from_fn(|axis, _| [limit, -cos, -sin].get(axis).copied().unwrap_or(0.0))
}

/// Whether a condition with this value is broken by more than rounding of terms of this size.
pub(super) fn is_broken<const C: usize>(value: f64, row: &SVector<f64, C>, size: f64) -> bool {
    value < -ZERO_SLACK * row.norm() * size
}
