//! One piece of a path: every contact keeps its state. Where nothing slides on a round cone everything is affine in the fraction
//! of the leg; where something does the piece is a step of the integration, made again up to where it is asked for.

use nalgebra::SVector;

use super::arc::{Arc, Poised, Rule};
use super::extrapolation::extrapolate;
use super::segment::{Here, Segment};
use crate::contact::{Line, State};
use crate::equilibrium::{Cone, Equilibrium};
use crate::grasp::{Grasp, Wrench};
use crate::object::{PieceState, Problem};
use crate::search::{Effort, Found, Rung};

/// How often a part of a step is made with a ten times larger error where it cannot be made with that of the whole.
const LOOSER: i32 = 4;

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
    pub(super) states: Vec<State<C>>,
    /// At `from`, with rates.
    pub(super) here: Here<D, C>,
    /// At `to`.
    pub(super) there: PieceState<D, C>,
    /// Where something slides on the round cone.
    pub(super) bend: Option<Bend<C>>,
}

/// How a piece was integrated.
#[derive(Debug, Clone)]
pub(super) struct Bend<const C: usize> {
    pub(super) rule: Rule,
    pub(super) tolerance: f64,
    /// Slips from `from` to `to`.
    pub(super) slipped: Vec<SVector<f64, C>>,
}

impl<'g, const D: usize, const C: usize> Stretch<'g, D, C> {
    /// The equilibrium at a fraction of the leg; `None` where rounding keeps a part of a step from being made.
    pub(super) fn state_at(
        &self,
        grasp: &'g Grasp<D, C>,
        cone: Cone,
        fraction: f64,
    ) -> Option<Equilibrium<D, C>> {
        if let Some(bend) = &self.bend {
            return self.on_the_bend(bend, grasp, cone, fraction);
        }
        let step = fraction - self.from;
        // Between the ends, each of which is solved where it is.
        let part = if self.to > self.from { step / (self.to - self.from) } else { 0.0 };
        let between = |line: &Line<C>, there: &SVector<f64, C>| line.force * (1.0 - part) + there * part;
        let forces = self.here.lines.iter().zip(&self.there.forces).map(|(a, b)| between(a, b)).collect();
        let twist = self.here.twist * (1.0 - part) + self.there.twist * part;
        let found = Found {
            free_motions: self.here.free_motions.clone(),
            neutral_motions: self.here.neutral_motions.clone(),
            sizes: [0, 1].map(|k| self.here.sizes[k] + step * self.here.rate_sizes[k]),
            ..Found::new(self.states.clone(), forces, twist)
        };
        Some(self.equilibrium(grasp, cone, fraction, &self.segment(grasp, cone).problem_at(fraction), &found))
    }

    fn on_the_bend(
        &self,
        bend: &Bend<C>,
        grasp: &'g Grasp<D, C>,
        cone: Cone,
        fraction: f64,
    ) -> Option<Equilibrium<D, C>> {
        let segment = self.segment(grasp, cone);
        let start = PieceState {
            forces: self.here.lines.iter().map(|line| line.force).collect(),
            twist: self.here.twist,
        };
        let end = || Poised { at: self.there.clone(), slipped: bend.slipped.clone() };
        let poised = if fraction >= self.to {
            end()
        } else if fraction <= self.from {
            Poised { at: start, slipped: vec![SVector::zeros(); grasp.len()] }
        } else {
            let arc = Arc::new(&segment, &self.states, self.from, start, self.here.twist_rate);
            // What reached the end of the piece reaches a part of it, if not always to the same error: rounding is in the way.
            let errors = (0..LOOSER).map(|k| bend.tolerance * 10.0_f64.powi(k));
            let mut tries = errors.flat_map(|error| [(bend.rule, error), (bend.rule.other(), error)]);
            let reached = tries.find_map(|(rule, error)| extrapolate(&arc, rule, fraction, error));
            reached?.there
        };
        let state = |(state, force): (&State<C>, &SVector<f64, C>)| {
            if state.slides() { State::sliding_along(force) } else { *state }
        };
        let states = self.states.iter().zip(&poised.at.forces).map(state).collect();
        let found = Found {
            free_motions: self.here.free_motions.clone(),
            neutral_motions: self.here.neutral_motions.clone(),
            sizes: self.here.sizes,
            ..Found::new(states, poised.at.forces, poised.at.twist)
        };
        let mut problem = segment.problem_at(fraction);
        for (i, s) in poised.slipped.iter().enumerate() {
            problem.drives[i] -= s;
            problem.slips[i] += s;
        }
        Some(self.equilibrium(grasp, cone, fraction, &problem, &found))
    }

    fn segment(&self, grasp: &'g Grasp<D, C>, cone: Cone) -> Segment<'g, D, C> {
        let (problem, change) = (self.problem.clone(), self.change.clone());
        Segment { grasp, cone, problem, change, direction: self.direction, largest: 0.0 }
    }

    fn equilibrium(
        &self,
        grasp: &Grasp<D, C>,
        cone: Cone,
        fraction: f64,
        problem: &Problem<'g, D, C>,
        found: &Found<D, C>,
    ) -> Equilibrium<D, C> {
        let load = self.load[0] + (self.load[1] - self.load[0]) * fraction;
        grasp.equilibrium(problem, &load, found, Rung::LoadPath, &Effort::default(), cone)
    }
}
