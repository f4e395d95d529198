//! One straight piece of a path: every contact keeps its state, and everything is affine in the fraction of the leg.

use nalgebra::SVector;

use super::margin::Line;
use super::segment::Here;
use crate::equilibrium::{Cone, Effort, Equilibrium, Found, Rung};
use crate::formulation::{PieceState, Problem, State};
use crate::grasp::{Grasp, Wrench};

/// What is needed to tell the state at any fraction on the way.
pub(super) struct Stretch<'g, const D: usize, const C: usize> {
    pub(super) leg: usize,
    pub(super) from: f64,
    pub(super) to: f64,
    /// The local problem at fraction 0 of the leg, with the slip so far, and its rates.
    pub(super) problem: Problem<'g, D, C>,
    pub(super) change: Vec<SVector<f64, C>>,
    pub(super) direction: SVector<f64, D>,
    /// Load at the beginning and at the end of the leg.
    pub(super) load: [Wrench<D>; 2],
    pub(super) states: Vec<State>,
    /// At `from`, with rates.
    pub(super) here: Here<D, C>,
    /// At `to`.
    pub(super) there: PieceState<D, C>,
}

impl<const D: usize, const C: usize> Stretch<'_, D, C> {
    /// The equilibrium at a fraction of the leg.
    pub(super) fn state_at(&self, grasp: &Grasp<D, C>, cone: Cone, fraction: f64) -> Equilibrium<D, C> {
        let step = fraction - self.from;
        // Between the ends, each of which is solved where it is.
        let part = if self.to > self.from { step / (self.to - self.from) } else { 0.0 };
        let between = |line: &Line<C>, there: &SVector<f64, C>| line.force * (1.0 - part) + there * part;
        let found = Found {
            states: self.states.clone(),
            forces: self.here.lines.iter().zip(&self.there.forces).map(|(a, b)| between(a, b)).collect(),
            twist: self.here.twist * (1.0 - part) + self.there.twist * part,
            free_motions: self.here.free_motions.clone(),
            neutral_motions: self.here.neutral_motions.clone(),
            sizes: [0, 1].map(|k| self.here.sizes[k] + step * self.here.rate_sizes[k]),
            slides: Vec::new(),
            from_polygon: None,
        };
        let load = self.load[0] + (self.load[1] - self.load[0]) * fraction;
        let problem = Problem {
            drives: self.problem.drives.iter().zip(&self.change).map(|(a, da)| a + da * fraction).collect(),
            wrench: self.problem.wrench + self.direction * fraction,
            ..self.problem.clone()
        };
        grasp.equilibrium(&problem, &load, &found, Rung::LoadPath, &Effort::default(), cone)
    }
}
