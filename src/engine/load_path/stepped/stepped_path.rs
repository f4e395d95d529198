//! The follower of a load program in steps, i.e. the part of a [`SteppedPath`] that advances: what it stores, and its start. A leg is a section of
//! the load program.

use nalgebra::SVector;

use super::coarse_path::CoarsePath;
use super::one_step::{StepProblem, SteppedState};
use super::pace::StepPace;
use super::step_doubling::StepDoubling;
use crate::equilibrium::Equilibrium;
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::load_path::event::PathEnd;
use crate::load_path::follower::{Advance, Follower, StateAtEdge};
use crate::load_path::following::Following;
use crate::load_path::leg::Leg;
use crate::load_path::path::{Path, SteppedPath};
use crate::load_path::program_run::ProgramRun;
use crate::numerics::indexed;
use crate::object::Problem;
use crate::prelude::*;
use crate::search::{SearchSolution, Settings};
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// The follower of a [`SteppedPath`], which follows a load program in steps.
#[derive(Debug)]
pub(crate) struct SteppedFollower<'g> {
    /// The static problem at the end of a step along the present leg.
    pub(super) along: StepProblem<'g>,
    /// The present path point.
    pub(super) present: SteppedState,
    /// The path points after each half of the last step tried, and after the same step made at once.
    pub(super) places: StepDoubling,
    /// Step control along the present leg: the length of the next step, and the speeds of the object.
    pub(super) pace: StepPace,
    /// The allowed error of contact forces for each leg, divided by the largest contact force.
    pub(super) error: f64,
    /// A second path, which makes each step at once where this path makes two halves. Its distance from this path measures the error of this path.
    pub(super) coarse: CoarsePath,
    /// A step made in two halves and the same step made at once may have an error of a contact force in common, which their difference does not show.
    /// This is the largest estimate of such an error in the steps so far, divided by the largest contact force of its step.
    pub(super) shared_error: f64,
    /// Sum of the relative changes of contact forces on the path so far. Each step adds the largest change of a contact force in the step, divided by
    /// the largest contact force at either end of the step.
    pub(super) relative_force_changes: f64,
}

/// One step of a [`SteppedPath`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Step<const C: usize> {
    /// Index of the leg (section of the load program), from 0.
    pub leg: usize,
    /// Fraction of the leg at the end of the step, up to 1.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub fraction: f64,
    /// The load at the end of the step, about the origin, N and N m.
    pub load: Wrench<C>,
    /// Number of contacts that slide at the end of the step.
    pub sliding: usize,
    /// Number of contacts that are open at the end of the step.
    pub open: usize,
    /// Estimated error of the forces due to this step, divided by the largest force.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub error: f64,
}

/// Returns an error unless `value`, the allowed error of contact forces on a leg, is from 1e-9 to 1; `what` is its name in the message.
pub(crate) fn check_leg_error(what: &'static str, value: f64) -> Result<(), Error> {
    if (1e-9..=1.0).contains(&value) {
        Ok(())
    } else {
        Err(Error::Argument { what, value, allowed: "from 1e-9 to 1" })
    }
}

impl Engine {
    pub(crate) fn follow_in_steps(
        &self,
        start: &Wrench<3>,
        legs: &[Leg<3>],
        error: f64,
        settings: &Settings,
    ) -> Result<SteppedPath<'_, 3>, Error> {
        self.refuse_hands("follow_in_steps")?;
        self.refuse_kinetic("follow_in_steps")?;
        check_leg_error("error of a leg", error)?;
        let settings = Settings { round: true, ..*settings };
        let path = Following::start(self, (start, legs), &settings, |run, problem| {
            let present = at_start(problem, run.start(problem)?);
            let along = StepProblem::along(run);
            let pace = StepPace::along(&along.trajectory);
            let coarse = CoarsePath::starting_at(&present);
            let places = StepDoubling::without_contacts();
            Ok(SteppedFollower {
                along,
                present,
                places,
                pace,
                error,
                coarse,
                shared_error: 0.0,
                relative_force_changes: 0.0,
            })
        })?;
        Ok(Path::new(Box::new(path)))
    }
}

/// The path point at the start of a path, from the solution `found` of `problem`. The slips of sliding and open contacts are stored as accumulated
/// slip.
fn at_start(problem: &Problem<'_>, found: SearchSolution) -> SteppedState {
    let slip = |(i, state): (usize, &crate::contact::State)| {
        let springs = &problem.sites[i].springs;
        if state.is_sticking() || !springs.resists_tangentially() {
            return SVector::zeros();
        }
        springs.slip(&problem.stretch(i, &found.twist), &found.forces[i])
    };
    let slips = indexed(&found.states, &slip);
    SteppedState { fraction: 0.0, twist: found.twist, slips, forces: found.forces, states: found.states }
}

impl<'g> Follower<'g> for SteppedFollower<'g> {
    type Report = Step<3>;

    fn start_leg(&mut self, run: &ProgramRun<'g>) -> Result<(), PathEnd<3>> {
        self.along.start_leg(run);
        self.pace.start_leg(&self.along.trajectory);
        self.present.fraction = 0.0;
        self.coarse.present.fraction = 0.0;
        Ok(())
    }

    fn advance(&mut self, run: &ProgramRun<'g>) -> Result<Advance<Step<3>>, PathEnd<3>> {
        if self.present.fraction >= 1.0 { Ok(Advance::EndOfLeg) } else { self.try_step(run) }
    }

    fn fraction(&self) -> f64 {
        self.present.fraction
    }

    fn state(&self, run: &ProgramRun<'g>) -> Option<Equilibrium<3>> {
        Some(self.present.equilibrium(run))
    }

    fn forces(&self, _: &ProgramRun<'g>) -> Vec<SVector<f64, 3>> {
        self.present.forces.clone()
    }

    fn step_error(&self) -> f64 {
        self.coarse.farthest + self.shared_error
    }

    fn edge(&self, run: &ProgramRun<'g>) -> StateAtEdge<'g> {
        self.present.edge(run)
    }
}
