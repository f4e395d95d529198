//! A stored piece of a load path, along which every contact keeps its state (open, sticking or sliding). If no contact slides on a round cone, forces
//! and motions are affine in the fraction of the leg that is done, or harmonics of the load's angle. Otherwise the piece is a step of the integration
//! along an arc, on which directions of sliding turn. To compute a path point (forces and twist) within the piece, this step is repeated up to the
//! requested fraction. A leg is a section of the load program. A drive is the spring of a joint or tendon of a hand, with its force limit. A jump is
//! a motion of the object, at constant load, to another equilibrium. The offset of a contact's springs is the command of its finger (a displacement)
//! minus clearance and accumulated slip.

use nalgebra::SVector;

use super::body_loads::BodyLoads;
use super::flow::{Flow, Rule, StepGoal};
use super::held_torques::HeldTorques;
use super::path_state::forces_are_rounding;
use super::segment::{PathPoint, Segment};
use super::trajectory::Trajectory;
use crate::contact::{Line, State};
use crate::equilibrium::{AnswerFor, Equilibrium};
use crate::grasp::{Engine, Wrench};
use crate::numerics::{Each, Vector, mapped, paired};
use crate::object::{ForcesAndTwist, Problem};
use crate::prelude::*;
use crate::search::{FoundBy, SearchCounts, SearchSolution, reported_at_rest};

/// A stored piece of the path, from the fraction `from` to the fraction `to` of a leg. Forces and twist at any fraction in this range are computed
/// from it.
#[derive(Debug)]
pub(super) struct StoredPiece<'g> {
    pub(super) leg: usize,
    pub(super) from: f64,
    pub(super) to: f64,
    /// The static problem at fraction 0 of the leg, with the slips accumulated up to this piece.
    pub(super) problem: Problem<'g>,
    /// The rates at which the spring offsets of the contacts change along the leg, m per unit of the fraction.
    pub(super) change: Vec<SVector<f64, 3>>,
    /// The load on the right-hand side of the static problem, in the engine's coordinates: all loads together, as a function of the fraction of the
    /// leg.
    pub(super) trajectory: Trajectory<Vector>,
    /// The load of the load program, in the caller's coordinates, as a function of the fraction of the leg.
    pub(super) load: Trajectory<Wrench<3>>,
    /// Loads on single bodies at the beginning and at the end of the leg.
    pub(super) bodies: BodyLoads,
    /// Constant torques on joints at the beginning and at the end of the leg.
    pub(super) torques: HeldTorques,
    pub(super) states: Vec<State>,
    /// Forces, twist and gaps at the fraction `from` of the leg, with their rates along the piece.
    pub(super) here: PathPoint,
    /// Forces and twist at the fraction `to`.
    pub(super) there: ForcesAndTwist,
    /// The integration step that made this piece; `None` unless a contact slides on the round cone.
    pub(super) arc_step: Option<ArcStep>,
    /// The jump after which this piece, of zero length, was stored; `None` for all other pieces.
    pub(super) jump: Option<Box<JumpRecord>>,
}

/// Slips and states of all contacts and drives in a jump.
#[derive(Debug)]
pub(super) struct JumpRecord {
    /// For each contact or drive its accumulated slip before the jump, m.
    pub(super) slips: Vec<SVector<f64, 3>>,
    /// For each contact or drive: true if it slid in the jump.
    pub(super) slid: Vec<bool>,
    /// Successive lists of the states of all contacts and drives in the jump.
    pub(super) states: Vec<Vec<State>>,
}

/// The integration step that made a piece of the path on an arc, along which directions of sliding turn.
#[derive(Debug, Clone, Copy)]
pub(super) struct ArcStep {
    /// The displacement, m, that counts as much in the arclength as the whole leg.
    pub(super) unit: f64,
    /// Arclength of the integration step.
    pub(super) length: f64,
    pub(super) rule: Rule,
}

impl<'g> StoredPiece<'g> {
    /// The equilibrium at the fraction `fraction` of the leg within this piece. Contacts without force are reported as open, unless all forces are
    /// rounding. `None` if the equilibrium cannot be computed because of rounding.
    pub(super) fn state_at(
        &self,
        grasp: &'g Engine,
        answer_for: AnswerFor,
        fraction: f64,
    ) -> Option<Equilibrium<3>> {
        let (problem, found) = self.found_at(grasp, answer_for, fraction)?;
        // If all forces are rounding, there is nothing with which a small force could be compared, so contacts keep their states.
        let nothing = forces_are_rounding(&problem, &found.forces, &found.twist);
        let found = if nothing { found } else { reported_at_rest(&problem, found) };
        Some(self.answer(grasp, answer_for, fraction, &problem, found))
    }

    /// The equilibrium at the end of this piece, with the contact states along the piece. The event at this end lists the changes of these states.
    /// `None` if the equilibrium cannot be computed.
    pub(super) fn state_before_event(
        &self,
        grasp: &'g Engine,
        answer_for: AnswerFor,
    ) -> Option<Equilibrium<3>> {
        let (problem, found) = self.found_at(grasp, answer_for, self.to)?;
        Some(self.answer(grasp, answer_for, self.to, &problem, found))
    }

    fn answer(
        &self,
        grasp: &Engine,
        answer_for: AnswerFor,
        fraction: f64,
        problem: &Problem<'g>,
        found: SearchSolution,
    ) -> Equilibrium<3> {
        let load = self.load.at(fraction);
        let grasp = self.torques.apply(self.bodies.apply(grasp, fraction), fraction);
        grasp.equilibrium(problem, &load, found, FoundBy::LoadPath, &SearchCounts::default(), answer_for)
    }

    /// The static problem at the fraction `fraction` of the leg within this piece, and its solution; `None` if it cannot be computed because of
    /// rounding.
    pub(super) fn found_at(
        &self,
        grasp: &'g Engine,
        answer_for: AnswerFor,
        fraction: f64,
    ) -> Option<(Problem<'g>, SearchSolution)> {
        let segment = self.segment(grasp, answer_for);
        if let Some(arc_step) = &self.arc_step {
            return self.found_on_arc(arc_step, &segment, fraction);
        }
        let step = fraction - self.from;
        // The forces are interpolated between both ends of the piece, each of which was solved for directly.
        let part = if self.to > self.from { step / (self.to - self.from) } else { 0.0 };
        let between = |line: &Line, there: &SVector<f64, 3>| line.force * (1.0 - part) + there * part;
        let (forces, twist) = match &self.here.turned {
            Some(_) if part < 1.0 => {
                let at =
                    segment.state(&self.here.linear_problem, fraction, Some(&self.here.after(step).twist))?;
                (at.forces, at.twist)
            }
            _ => (
                paired(&self.here.lines, &self.there.forces, &|(a, b)| between(a, b)),
                &self.here.twist * (1.0 - part) + &self.there.twist * part,
            ),
        };
        // Rounding errors are proportional to the magnitudes of the terms of forces and displacements. On a straight leg these magnitudes grow along
        // the piece. While the load turns, they are already the largest over all angles, so nothing is added.
        let step = if self.here.turned.is_some() { 0.0 } else { step };
        let found = SearchSolution {
            free_motions: self.here.free_motions.clone(),
            neutral_motions: self.here.neutral_motions.clone(),
            sizes: [0, 1].each(|k| self.here.sizes[k] + step * self.here.rate_sizes[k]),
            ..SearchSolution::new(self.states.clone(), forces, twist)
        };
        Some((segment.problem_at(fraction), found))
    }

    fn found_on_arc(
        &self,
        arc_step: &ArcStep,
        segment: &Segment<'g>,
        fraction: f64,
    ) -> Option<(Problem<'g>, SearchSolution)> {
        let at = if fraction >= self.to {
            self.there.clone()
        } else if fraction <= self.from {
            start_of(&self.here)
        } else {
            self.part_of_a_step(arc_step, segment, fraction)?
        };
        let state = |(state, force): (&State, &SVector<f64, 3>)| {
            if state.slides() { State::sliding_along(force) } else { *state }
        };
        let states = paired(&self.states, &at.forces, &state);
        let found = SearchSolution {
            free_motions: self.here.free_motions.clone(),
            neutral_motions: self.here.neutral_motions.clone(),
            sizes: self.here.sizes,
            ..SearchSolution::new(states, at.forces, at.twist)
        };
        let mut problem = segment.problem_at(fraction);
        for (i, (state, site)) in self.states.iter().zip(segment.grasp.sites()).enumerate() {
            if state.slides() {
                let slip =
                    site.springs.slip(&site.stretch(&problem.offsets[i], &found.twist), &found.forces[i]);
                problem.offsets[i] -= slip;
                problem.slips[i] += slip;
            }
        }
        Some((problem, found))
    }

    /// Forces and twist at the fraction `fraction` of the leg within the integration step `arc_step`. If a single step to this fraction fails because
    /// of rounding, several shorter steps lead to it. `None` if these fail, too.
    fn part_of_a_step(
        &self,
        arc_step: &ArcStep,
        segment: &Segment<'g>,
        fraction: f64,
    ) -> Option<ForcesAndTwist> {
        let (mut from, mut point, mut states) = (self.from, self.here.clone(), self.states.clone());
        let mut length = arc_step.length;
        // If the step to this fraction fails, it is made in parts, of which each is half as long as the part before. Sixty halvings reach the limit
        // of rounding.
        for _ in 0..60 {
            let flow = Flow::new(segment, &states, from, &point, arc_step.unit);
            if let Some(reached) = flow.step_to_factor(fraction, length, arc_step.rule) {
                return Some(reached.state());
            }
            length *= 0.5;
            let part = flow.step(length, StepGoal::after(fraction, 0), arc_step.rule);
            if let Some(reached) = part.filter(|reached| reached.to <= fraction) {
                let slid = |(state, line): (&State, &Line)| {
                    if state.slides() { State::sliding_along(&line.force) } else { *state }
                };
                states = paired(&states, &reached.point.lines, &slid);
                (from, point) = (reached.to, reached.point);
                if from == fraction {
                    return Some(start_of(&point));
                }
            }
        }
        // All these steps have failed. The object may move in this step while the load is constant up to rounding. Forces and twist then do not
        // depend on the fraction of the leg, and all those of the step are valid.
        let (to_the_start, to_the_end) = (fraction - self.from, self.to - fraction);
        // At fractions of the leg that differ by less than this, the loads are equal up to rounding.
        let near = to_the_start.min(to_the_end) <= 1e-15;
        near.then(|| if to_the_start < to_the_end { start_of(&self.here) } else { self.there.clone() })
    }

    fn segment(&self, grasp: &'g Engine, answer_for: AnswerFor) -> Segment<'g> {
        let (problem, change) = (self.problem.clone(), self.change.clone());
        Segment { grasp, answer_for, problem, change, trajectory: self.trajectory.clone(), largest: 0.0 }
    }
}

/// Forces and twist of the path point `point`, without its rates.
fn start_of(point: &PathPoint) -> ForcesAndTwist {
    ForcesAndTwist { forces: mapped(&point.lines, &|line| line.force), twist: point.twist.clone() }
}
