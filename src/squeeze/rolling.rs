//! Forces of every contact while everything rolls, and what its cone asks of them.

use nalgebra::SVector;

use crate::contact::{Edges, Polygon, ZERO_SLACK};
use crate::grasp::{Grasp, Twist, Wrench, wrench_of};
use crate::object::{Load, Piece, Problem};
use crate::search::Settings;

/// A grasp in which everything rolls.
pub(super) struct Rolling<'g, const D: usize, const C: usize> {
    pub(super) grasp: &'g Grasp<D, C>,
    problem: Problem<'g, D, C>,
    piece: std::sync::Arc<Piece<D, C>>,
    pub(super) edges: Vec<Edges<C>>,
}

/// Forces contact by contact, or the motion on which a load works though nothing resists it.
pub(super) type Forces<const D: usize, const C: usize> = Result<Vec<SVector<f64, C>>, Twist<D, C>>;

impl<'g, const D: usize, const C: usize> Rolling<'g, D, C> {
    pub(super) fn new(grasp: &'g Grasp<D, C>, settings: &Settings) -> Self {
        let polygon = Polygon::shared(&settings.cone);
        let nothing = Load::from(&SVector::zeros());
        let problem = grasp.problem(polygon, settings.is_round::<C>(), grasp.drives(), &nothing);
        let edges = problem.locals().map(|local| local.edges()).collect();
        let piece = problem.trial();
        Self { grasp, problem, piece, edges }
    }

    /// Forces with these drives under a load in inside coordinates.
    pub(super) fn forces(&self, drives: &[SVector<f64, C>], load: &SVector<f64, D>) -> Forces<D, C> {
        match self.piece.solve(self.problem.sites, drives, load) {
            Ok(state) => Ok(state.forces),
            Err(unbalanced) => {
                let motion = unbalanced.motion.unwrap_or_else(SVector::zeros);
                Err(self.grasp.outside(&motion))
            }
        }
    }

    /// What a load alone changes.
    pub(super) fn forces_of(&self, load: &Wrench<D, C>) -> Forces<D, C> {
        self.forces(&vec![SVector::zeros(); self.problem.len()], &self.grasp.inside_unchecked(load))
    }

    /// What a force of 1 N along each coordinate axis changes, contact by contact: column k of A is that of axis k.
    pub(super) fn forces_of_pushes(
        &self,
        point: &[f64; C],
    ) -> Result<Vec<[SVector<f64, C>; C]>, Twist<D, C>> {
        let mut columns = vec![[SVector::zeros(); C]; self.problem.len()];
        for axis in 0..C {
            let push = push(point, &std::array::from_fn(|k| if k == axis { 1.0 } else { 0.0 }));
            for (columns, force) in columns.iter_mut().zip(self.forces_of(&push)?) {
                columns[axis] = force;
            }
        }
        Ok(columns)
    }
}

/// A force at a point.
pub(super) fn push<const D: usize, const C: usize>(point: &[f64; C], force: &[f64; C]) -> Wrench<D, C> {
    Wrench::from_vector(wrench_of::<D, C>(&SVector::from(*point), &SVector::from(*force)))
}

/// `Aᵀa`: how much a condition falls for 1 N along each axis against it.
pub(super) fn felt<const C: usize>(columns: &[SVector<f64, C>; C], row: &SVector<f64, C>) -> SVector<f64, C> {
    SVector::from_fn(|k, _| columns[k].dot(row))
}

/// The row `(limit, -cos φ, -sin φ)` of a round cone.
pub(super) fn round_row<const C: usize>(limit: f64, angle: f64) -> SVector<f64, C> {
    let (sin, cos) = angle.sin_cos();
    SVector::from_fn(|axis, _| [limit, -cos, -sin].get(axis).copied().unwrap_or(0.0))
}

/// The row that a force breaks most, or keeps with the least to spare, with the value of the condition there.
pub(super) fn worst_row<const C: usize>(
    edges: &Edges<C>,
    force: &SVector<f64, C>,
) -> Option<(SVector<f64, C>, f64)> {
    match edges {
        Edges::Rows(rows) => {
            let values = rows.iter().map(|row| (*row, row.dot(force)));
            values.min_by(|(_, a), (_, b)| a.total_cmp(b))
        }
        Edges::Round { limit } => {
            let mut row = -force;
            row[0] = 0.0;
            let friction = row.norm();
            row /= friction.max(f64::MIN_POSITIVE);
            row[0] = *limit;
            Some((row, limit * force[0] - friction))
        }
    }
}

/// Whether a condition with this value is broken by more than rounding of terms of this size.
pub(super) fn is_broken<const C: usize>(value: f64, row: &SVector<f64, C>, size: f64) -> bool {
    value < -ZERO_SLACK * row.norm() * size
}
