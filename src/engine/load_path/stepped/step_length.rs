//! Step control of a path followed in steps: tries steps that are as long as the allowed error of contact forces permits. Each step is made twice, in
//! two halves and at once (in a single step of the same length), and the difference measures its error. A leg is a section of the load program. A
//! second path makes all its steps at once; its distance from this path measures errors that accumulate. A jump is a motion of the object, at
//! constant load, to another equilibrium.

use super::one_step::SteppedState;
use super::step_doubling::StepDoubling;
use super::stepped_path::{Step, SteppedFollower};
use crate::contact::State;
use crate::grasp::Site;
use crate::load_path::event::PathEnd;
use crate::load_path::follower::Advance;
use crate::load_path::program_run::ProgramRun;
use crate::load_path::tolerances::SHORTEST_STEP;
use crate::numerics::{Reals, Vector, counted, largest};
#[cfg(not(feature = "std"))]
use crate::prelude::*;
use crate::search::Doubt;

/// Forces and errors of a step made both in two halves and at once. Forces and twist after each half, and after the same step made at once, are in
/// [`StepDoubling`].
#[derive(Debug)]
struct DoubledStepSizes {
    /// The largest contact force at either end of the step, N.
    largest: f64,
    /// The largest error of a contact force that both forms of the step, at once and in two halves, may have in common, divided by the largest
    /// contact force. Their difference does not show this error.
    shared_error: f64,
    /// The largest change of a contact force, N, that the object's motion in the step would cause if all contacts stuck.
    force_change: f64,
}

impl<'g> SteppedFollower<'g> {
    /// Tries a step and chooses the length of the next step. Returns the step if its error is at most the allowed error, or `OnTheWay` if a
    /// shorter step is to be tried next. An `Err` is the end of the path, if steps become too short or too many.
    pub(super) fn try_step(&mut self, run: &ProgramRun<'g>) -> Result<Advance<Step<3>>, PathEnd<3>> {
        let from = self.present.fraction;
        if self.pace.tried == run.settings.most_steps {
            return Err(run.undecided(from, Doubt::OutOfSteps));
        }
        self.pace.tried += 1;
        let rest = 1.0 - from;
        let step = self.pace.step.min(self.pace.longest);
        let length = if step > 0.9 * rest { rest } else { step };
        let Some(twice) = self.twice(length) else {
            // If no equilibrium was found at the end of a step, a step of a quarter of the length is tried.
            self.pace.step = length * 0.25;
            return if self.pace.step < SHORTEST_STEP {
                Err(self.end_here(run, Doubt::OnTheBoundary))
            } else {
                Ok(Advance::OnTheWay)
            };
        };
        let part = self.error_over_allowed(&twice);
        // The next step is at most twice as long as the present step; right after a refused step it may not grow.
        let fastest = if self.pace.refused { 1.0 } else { 2.0 };
        self.pace.refused = part > 1.0;
        // If the error grows with the square of the length, it equals the allowed error at the length `length / √part`. The next step has 0.7 of that
        // length, but at least a fifth of the present length.
        self.pace.step = length * (0.7 / part.sqrt()).clamp(0.2, fastest);
        if part > 1.0 {
            // The step is refused. If the next step is shorter than the shortest allowed step, rounding errors exceed the allowed error, and the path
            // ends.
            return if self.pace.step < SHORTEST_STEP {
                Err(self.end_here(run, Doubt::Inaccurate))
            } else {
                Ok(Advance::OnTheWay)
            };
        }
        let to = &self.places.to;
        self.pace.rate = Some((&to.twist - &self.present.twist) / length);
        self.pace.speeds.note(to.fraction, twice.force_change / length);
        self.pace.changed = to.distance_to(&self.present) / twice.force_change;
        Ok(Advance::Reached(self.accept_step(run, &twice)))
    }

    /// The largest ratio, over all contacts, of the error that a step makes in the contact force to the error that this step may make. The error is
    /// estimated by the difference between the step in two halves and the step made at once. If the ratio exceeds 1, the step is too long.
    fn error_over_allowed(&self, twice: &DoubledStepSizes) -> f64 {
        let (from, StepDoubling { to, at_once, .. }, largest) = (&self.present, &self.places, twice.largest);
        let length = to.fraction - from.fraction;
        let relative_change = to.distance_to(from) / largest;
        // Half of the allowed error is divided among the steps in proportion to the largest of three measures of a step. The first is the fraction of
        // the leg that the step covers. The second is the change of contact forces in the step, divided by the largest force. The third is the change
        // of contact forces by the object's motion if all contacts stuck, also divided by the largest force. It counts because friction forces turn
        // towards the directions of slip as the object moves. By the time the third measures of successive steps add up to one, an error in the
        // direction of a friction force has decayed. The next steps may therefore make errors of the same magnitude again.
        let even = 0.5 * self.error * length.max(relative_change).max(twice.force_change / largest);
        // The allowed difference of a contact's force between this path and the second path. The error of this path is about a third of this
        // difference. The allowed difference grows with the sum of the relative changes of forces along the path, up to twice the allowed error. This
        // sum is `self.relative_force_changes` before the step, and the step adds `relative_change`.
        let budget = self.error * (self.relative_force_changes + relative_change).min(2.0);
        // An error below this fraction of the largest force is rounding.
        let rounding = 1e-13;
        let part = |i: usize| {
            let accumulated = (from.forces[i] - self.coarse.present.forces[i]).norm() / largest;
            // Each step may use up this fraction of what remains of a contact's allowed difference. If the fraction is larger, a few steps use all of
            // it, and later steps have too little. If it is smaller, steps are shorter than necessary.
            let allowed = even.max(0.05 * (budget - accumulated)).max(rounding);
            (to.forces[i] - at_once.forces[i]).norm() / largest / allowed
        };
        let used = (0..to.forces.len()).map(part).most();
        // The error that both forms of the step have in common may be a tenth of the allowed error. This is far more than the share of one step. It
        // is allowed because a contact makes such an error only a few times on a leg: when it starts or stops sliding, opens or closes.
        used.max(twice.shared_error / (0.1 * self.error).max(rounding))
    }

    /// Makes a step over the fraction `length` of the leg both in two halves and at once, and stores the path points reached in the field `places`.
    /// `None` if one of these steps finds no equilibrium, or only one to which a jump leads.
    fn twice(&mut self, length: f64) -> Option<DoubledStepSizes> {
        let Self { along, present: from, places: StepDoubling { middle, to, at_once, .. }, .. } = self;
        let rate = self.pace.rate.clone().unwrap_or_else(Vector::zeros);
        let near = |at: &SteppedState, rate: &Vector, length: f64| &at.twist + rate * length;
        along.step(from, (0.5 * length, near(from, &rate, 0.5 * length)), middle)?;
        let rate = (&middle.twist - &from.twist) / (0.5 * length);
        along.step(middle, (0.5 * length, near(middle, &rate, 0.5 * length)), to)?;
        let largest = to.largest_force().max(from.largest_force()).max(f64::MIN_POSITIVE);
        let off = &middle.twist - (&from.twist + &to.twist) * 0.5;
        let sites = along.problem.sites;
        let force_change = largest_force_of_motion(sites, &(&to.twist - &from.twist));
        // Motions are measured by the forces by which they stretch the springs if all contacts stick. After the first half of a step, the object may
        // be off the straight line between the ends of the step. The step is a jump if this distance is more than a quarter of the step's motion. The
        // motion must also be large: more than a twentieth of the largest force.
        if force_change > 0.05 * largest && largest_force_of_motion(sites, &off) > 0.25 * force_change {
            return None;
        }
        let shared_error = along.shared_error([from, middle, to]) / largest;
        along.step(from, (length, to.twist.clone()), at_once)?;
        let finite = shared_error.is_finite() && (to.distance_to(at_once) / largest).is_finite();
        finite.then_some(DoubledStepSizes { largest, shared_error, force_change })
    }

    fn accept_step(&mut self, run: &ProgramRun<'g>, twice: &DoubledStepSizes) -> Step<3> {
        let DoubledStepSizes { largest, shared_error, .. } = *twice;
        let StepDoubling { to, at_once, beside, .. } = &mut self.places;
        self.coarse.follow(&mut self.along, [&self.present, to, at_once], beside);
        self.shared_error = self.shared_error.max(shared_error);
        self.relative_force_changes += to.distance_to(&self.present) / largest;
        let error = (to.distance_to(at_once) / largest).max(shared_error);
        core::mem::swap(&mut self.present, to);
        let to = &self.present;
        let (leg, fraction) = (run.program.leg, to.fraction);
        Step {
            leg,
            fraction,
            load: run.program.load_at(fraction),
            sliding: counted(&to.states, &State::slides),
            open: counted(&to.states, &State::is_open),
            error,
        }
    }
}

/// The largest contact force, N, that a motion of the object would cause if all contacts stuck.
fn largest_force_of_motion(sites: &[Site], motion: &Vector) -> f64 {
    largest(sites, &|site| pull(site, motion))
}

/// The magnitude of the force, N, that a motion of the object causes at a contact that sticks.
fn pull(site: &Site, motion: &Vector) -> f64 {
    site.springs.force(&site.map.tr_mul(motion)).norm()
}
