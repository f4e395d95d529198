//! The elastic trial state along a leg: where the path would lead if every contact stuck.

use nalgebra::SVector;

use crate::grasp::{Grasp, Site};
use crate::load_path::leg::Program;
use crate::numerics::{Orthogonal, without};
use crate::object::{spring_rows, stretched_into, worked_on};

/// The springs of all contacts, and the motion of the object if all of them hold.
#[derive(Debug)]
pub(super) struct TrialLeg<const D: usize> {
    /// `K^{1/2}Gᵀ = QR`.
    pub(super) factor: Orthogonal<D>,
    /// Motions that no contact resists.
    pub(super) free: Vec<SVector<f64, D>>,
    /// R q at the beginning of the leg, and its change along it.
    pub(super) travelled: SVector<f64, D>,
    pub(super) rate: SVector<f64, D>,
}

impl<const D: usize> TrialLeg<D> {
    pub(super) fn new<const C: usize>(sites: &[Site<D, C>]) -> Self {
        let factor = Orthogonal::new(spring_rows(sites).collect());
        let (travelled, rate) = (SVector::zeros(), SVector::zeros());
        Self { free: factor.null_space(), factor, travelled, rate }
    }

    /// Lays out the present leg of a program. Returns x⁰ at its beginning and its change, spring by
    /// spring.
    pub(super) fn lay<const C: usize>(
        &mut self,
        grasp: &Grasp<D, C>,
        program: &Program<D, C>,
    ) -> [Vec<f64>; 2] {
        let (from, change) = loads(grasp, program);
        let mut x = [Vec::new(), Vec::new()];
        for (x, v) in x.iter_mut().zip(program.drives(grasp)) {
            stretched_into(grasp.sites(), |i| v[i], x);
        }
        self.travelled = self.factor.project(&mut x[0], &from);
        self.rate = self.factor.project(&mut x[1], &change);
        x
    }

    /// The motion on which a load works though nothing resists it.
    pub(super) fn worked_on(&self, wrench: &SVector<f64, D>) -> Option<SVector<f64, D>> {
        worked_on(&self.free, wrench)
    }

    /// The twist of least norm with this R q.
    pub(super) fn twist(&self, travelled: &SVector<f64, D>) -> SVector<f64, D> {
        without(self.factor.preimage(travelled), &self.free)
    }
}

/// The load at the beginning of the present leg, in inside coordinates, and its change along the
/// leg.
pub(super) fn loads<const D: usize, const C: usize>(
    grasp: &Grasp<D, C>,
    program: &Program<D, C>,
) -> (SVector<f64, D>, SVector<f64, D>) {
    let course = program.inside_course(grasp);
    (course.at(0.0), course.rate_at(0.0))
}
