//! The elastic trial state along a leg: the path if every contact stuck.

use nalgebra::SVector;

use crate::grasp::{Engine, Site};
use crate::load_path::program::Program;
use crate::numerics::{Orthogonal, Vector, without};
use crate::object::{spring_rows, stretched_into, worked_on};
use crate::prelude::*;

/// The springs of all contacts, and the motion of the object if all of them stick.
#[derive(Debug)]
pub(super) struct TrialLeg<const C: usize> {
    /// `K^{1/2}Gᵀ = QR`.
    pub(super) factor: Orthogonal,
    /// Motions that no contact resists.
    pub(super) free: Vec<Vector>,
    /// R q at the beginning of the leg, and its change along it.
    pub(super) travelled: Vector,
    pub(super) rate: Vector,
    /// Drives at the beginning of the leg, and their change along it.
    drives: [Vec<SVector<f64, C>>; 2],
    /// x⁰ there, and its change along the leg, spring by spring.
    pub(super) x: [Vec<f64>; 2],
}

impl<const C: usize> TrialLeg<C> {
    pub(super) fn new(sites: &[Site<C>]) -> Self {
        let factor = Orthogonal::new(sites[0].map.size(), &spring_rows(sites).collect::<Vec<_>>());
        let (travelled, rate) = (Vector::zeros(), Vector::zeros());
        let (drives, x) = ([Vec::new(), Vec::new()], [Vec::new(), Vec::new()]);
        Self { free: factor.null_space(), factor, travelled, rate, drives, x }
    }

    /// Computes the trial state along the present leg of a program.
    pub(super) fn lay(&mut self, grasp: &Engine<C>, program: &Program<C>) {
        let (from, change) = loads(grasp, program);
        program.drives_into(grasp, &mut self.drives);
        for (x, v) in self.x.iter_mut().zip(&self.drives) {
            stretched_into(grasp.sites(), |i| v[i], x);
        }
        self.travelled = self.factor.project(&mut self.x[0], &from);
        self.rate = self.factor.project(&mut self.x[1], &change);
    }

    /// A motion that nothing resists and on which a load does work.
    pub(super) fn worked_on(&self, wrench: &Vector) -> Option<Vector> {
        worked_on(&self.free, wrench)
    }

    /// The twist of least norm with this R q.
    pub(super) fn twist(&self, travelled: &Vector) -> Vector {
        without(self.factor.preimage(travelled), &self.free)
    }
}

/// The load at the beginning of the present leg, in inside coordinates, and its change along the
/// leg.
pub(super) fn loads<const C: usize>(grasp: &Engine<C>, program: &Program<C>) -> (Vector, Vector) {
    let course = program.inside_course(grasp);
    (course.at(0.0), course.rate_at(0.0))
}
