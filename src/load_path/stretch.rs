//! One straight piece of a path: every contact keeps its state, and everything is affine in the fraction of the leg.

use nalgebra::SVector;

use super::segment::Here;
use crate::equilibrium::{Cone, Effort, Equilibrium, Found, Rung};
use crate::formulation::{Problem, State};
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
}

impl<const D: usize, const C: usize> Stretch<'_, D, C> {
    /// The equilibrium at a fraction of the leg.
    pub(super) fn state_at(&self, grasp: &Grasp<D, C>, cone: Cone, fraction: f64) -> Equilibrium<D, C> {
        let step = fraction - self.from;
        let found = Found {
            states: self.states.clone(),
            forces: self.here.lines.iter().map(|line| line.force + line.rate * step).collect(),
            twist: self.here.twist + self.here.twist_rate * step,
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
