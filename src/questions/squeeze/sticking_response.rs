//! The response of a grasp whose contacts all stick: linear in commands and loads, so that one factorisation serves every source.
//!
//! Each source gives forces of all sites, contacts first and then the drives of a hand. [`Edges`] are the conditions of sticking on their sum.

use nalgebra::SVector;

use crate::contact::{Edges, LocalLaw, Polygon, ZERO_SLACK};
use crate::grasp::{Engine, Motion, Wrench};
use crate::numerics::{Harmonic, Vector};
use crate::object::{Load, Piece, Problem};
use crate::prelude::*;
use crate::search::Settings;

/// The linear response of a grasp whose contacts all stick.
pub(crate) struct StickingResponse<'g> {
    pub(super) grasp: &'g Engine,
    problem: Problem<'g>,
    piece: alloc::sync::Arc<Piece>,
    pub(crate) edges: Vec<Edges>,
}

/// Forces contact by contact, and the sizes that scale their rounding.
#[derive(Debug, Clone)]
pub(crate) struct ContactForces {
    pub(crate) of: Vec<SVector<f64, 3>>,
    pub(super) sizes: Vec<f64>,
}

/// Changes at one contact by a force of 1 N along each coordinate axis.
pub(super) struct Push {
    /// A, column by column.
    pub(super) columns: [SVector<f64, 3>; 3],
    /// Sum of the sizes of its columns.
    pub(super) size: f64,
}

impl Push {
    /// `Aᵀa`: the decrease of a condition by 1 N against each axis; zero where it is rounding.
    pub(super) fn felt(&self, row: &SVector<f64, 3>) -> SVector<f64, 3> {
        let felt = SVector::<f64, 3>::from_fn(|k, _| self.columns[k].dot(row));
        if felt.norm() > ZERO_SLACK * row.norm() * self.size { felt } else { SVector::zeros() }
    }

    /// `Aᵀa` times a number, for the facets `a = (limit, -cos φ, -sin φ)` of a round cone as functions of φ.
    pub(super) fn turning(&self, limit: f64, times: f64) -> Harmonic<SVector<f64, 3>> {
        round_parts(limit).map(|&(part, axis)| SVector::from_fn(|k, _| times * part * self.columns[k][axis]))
    }
}

/// The facets of a round cone as functions of φ: the factor and the axis of a force in the constant, the cosine and the sine.
pub(super) fn round_parts(limit: f64) -> Harmonic<(f64, usize)> {
    Harmonic { constant: (limit, 0), cosine: (-1.0, 1), sine: (-1.0, 2) }
}

impl<'g> StickingResponse<'g> {
    pub(crate) fn new(grasp: &'g Engine, settings: &Settings) -> Self {
        let polygon = Polygon::shared(grasp.space(), &settings.cone);
        let nothing = Load::from(&Vector::zeros());
        let problem = grasp.problem(polygon, settings.is_round(grasp.space()), grasp.drives(), &nothing);
        let edges = problem.each(|local| local.edges());
        let piece = problem.trial();
        Self { grasp, problem, piece, edges }
    }

    /// The law of a contact.
    pub(crate) fn law(&self, contact: usize) -> LocalLaw<'_> {
        self.problem.local(contact)
    }

    /// Forces with these drives under a load in inside coordinates, or a motion on which the load works though nothing resists it.
    pub(crate) fn forces(
        &self,
        drives: &[SVector<f64, 3>],
        load: &Vector,
    ) -> Result<ContactForces, Motion<3>> {
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
    pub(super) fn pushes(&self, point: &[f64; 3]) -> Result<Vec<Push>, Motion<3>> {
        let at_rest = vec![SVector::zeros(); self.problem.len()];
        let mut pushes: Vec<_> =
            at_rest.iter().map(|_| Push { columns: [SVector::zeros(); 3], size: 0.0 }).collect();
        for axis in 0..3 {
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

impl Engine {
    /// The least value of a condition of sticking under a load, if every contact stuck, relative to the largest force. `None` where nothing resists the
    /// load, and without forces.
    pub(crate) fn sticking_margin(&self, load: &Wrench<3>, settings: &Settings) -> Option<f64> {
        let sticking = StickingResponse::new(self, settings);
        let forces = sticking.forces(&self.drives(), &self.load_alone(load, "load").ok()?).ok()?.of;
        let largest = forces.iter().map(SVector::norm).fold(0.0, f64::max);
        let worst = |(edges, force): (&Edges, &SVector<f64, 3>)| Some(edges.worst(force)?.1);
        let least = sticking.edges.iter().zip(&forces).filter_map(worst).min_by(f64::total_cmp)?;
        (largest > 0.0).then(|| least / largest)
    }
}

/// A force at a point.
pub(super) fn push(point: &[f64; 3], force: &[f64; 3]) -> Wrench<3> {
    Wrench::force_through(&SVector::from(*point), &SVector::from(*force))
}

/// The row `(limit, -cos φ, -sin φ)` of a round cone.
pub(super) fn round_row(limit: f64, angle: f64) -> SVector<f64, 3> {
    let (sin, cos) = angle.sin_cos();
    SVector::from_fn(|axis, _| [limit, -cos, -sin].get(axis).copied().unwrap_or(0.0))
}

/// Whether a condition with this value is broken by more than rounding of terms of this size.
pub(super) fn is_broken(value: f64, row: &SVector<f64, 3>, size: f64) -> bool {
    value < -ZERO_SLACK * row.norm() * size
}
