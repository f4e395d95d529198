//! Steps as long as the error asked for allows.

use nalgebra::SVector;

use super::one_step::{SHORTEST, Standing};
use super::stepped_path::{Step, Steps};
use crate::grasp::Site;
use crate::load_path::event::PathEnd;
use crate::load_path::follower::Came;
use crate::load_path::journey::Journey;
use crate::search::Doubt;

/// An error below this part of the largest force is rounding.
const ROUNDING: f64 = 1e-13;
/// A step is followed by one that is this many times as long at least, and at most.
const SLOWER: f64 = 0.2;
const FASTER: f64 = 2.0;
/// The next step is as long as would make this part of the error allowed.
const CAREFUL: f64 = 0.7;
/// A step where there is no equilibrium is followed by one this many times as long.
const NOWHERE: f64 = 0.25;
/// Where a contact changes its state halves and whole may err alike, by what the object is off the straight way in the middle. It happens to a
/// contact a few times a leg: each time this part of the error is allowed.
const AT_A_CHANGE: f64 = 0.3;
/// A step is a jump if the object is farther than this part of it from its middle halfway …
const LEAP: f64 = 0.25;
/// … and if springs would feel the step by more than this part of the largest force.
const FELT: f64 = 0.05;

/// What a step makes wrong, over the largest force.
#[derive(Debug, Clone, Copy)]
struct StepError {
    /// Where contacts keep their states.
    smooth: f64,
    /// Where they change them.
    change: f64,
    /// How far forces have gone.
    way: f64,
    /// How far springs that stick would feel the object to have gone, N.
    felt: f64,
}

impl<'g, const D: usize, const C: usize> Steps<'g, D, C> {
    /// Tries a step; what it is if it errs by no more than is allowed.
    pub(super) fn try_a_step(
        &mut self,
        journey: &Journey<'g, D, C>,
    ) -> Result<Came<Step<D, C>>, PathEnd<D, C>> {
        let from = self.standing.fraction;
        if self.pace.tried == journey.settings.most_steps {
            return Err(journey.undecided(from, Doubt::OutOfSteps));
        }
        self.pace.tried += 1;
        let rest = 1.0 - from;
        let step = self.pace.step.min(self.pace.longest);
        let length = if step > 0.9 * rest { rest } else { step };
        let Some((to, error)) = self.twice(length) else {
            self.pace.step = length * NOWHERE;
            return if self.pace.step < SHORTEST {
                Err(self.end_here(journey, Doubt::OnTheBoundary))
            } else {
                Ok(Came::OnTheWay)
            };
        };
        let parts = [
            error.smooth / (self.error * length.max(error.way)).max(ROUNDING),
            error.change / (self.error * AT_A_CHANGE).max(ROUNDING),
        ];
        let part = parts[0].max(parts[1]);
        let fastest = if self.pace.refused { 1.0 } else { FASTER };
        self.pace.refused = part > 1.0;
        self.pace.step = length * (CAREFUL / part.sqrt()).clamp(SLOWER, fastest);
        if part > 1.0 {
            // Rounding may forbid an error that is so small.
            return if self.pace.step < SHORTEST {
                Err(self.end_here(journey, Doubt::Inaccurate))
            } else {
                Ok(Came::OnTheWay)
            };
        }
        self.pace.rate = Some((to.twist - self.standing.twist) / length);
        self.pace.speeds.note(to.fraction, error.felt / length);
        Ok(Came::To(self.arrive(journey, to, error)))
    }

    /// A step in two halves, with its estimated error; `None` where one of them finds no equilibrium, or only one
    /// elsewhere.
    fn twice(&mut self, length: f64) -> Option<(Standing<D, C>, StepError)> {
        let Self { along, standing: from, .. } = self;
        let rate = self.pace.rate.unwrap_or_else(SVector::zeros);
        let near = |at: &Standing<D, C>, rate: &SVector<f64, D>, length: f64| at.twist + rate * length;
        let middle = along.step(from, 0.5 * length, near(from, &rate, 0.5 * length))?;
        let rate = (middle.twist - from.twist) / (0.5 * length);
        let to = along.step(&middle, 0.5 * length, near(&middle, &rate, 0.5 * length))?;
        let largest = to.largest_force().max(from.largest_force());
        let off = middle.twist - (from.twist + to.twist) * 0.5;
        let sites = along.problem.sites;
        let felt = most_felt(sites, &(to.twist - from.twist));
        if felt > FELT * largest && most_felt(sites, &off) > LEAP * felt {
            return None;
        }
        if largest == 0.0 {
            return Some((to, StepError { smooth: 0.0, change: 0.0, way: 0.0, felt }));
        }
        let local = |i: usize| along.problem.local(i);
        let changes = |i: usize, pull: f64| {
            let [a, b, c] = [from, &middle, &to];
            if !a.states[i].is_kind_of(&b.states[i]) || !b.states[i].is_kind_of(&c.states[i]) {
                return true;
            }
            // Rolls at all three, but as near to its edge as the way is off a straight one.
            let margin = |at: &Standing<D, C>| local(i).margin(&at.forces[i]);
            local(i).may_slide()
                && b.states[i].is_rolling()
                && margin(a).min(margin(b)).min(margin(c)) < pull * local(i).cone().round_weight()
        };
        let change_of = |i: usize| {
            let pull = pull(&sites[i], &off);
            if changes(i, pull) { pull } else { 0.0 }
        };
        let change = (0..sites.len()).map(change_of).fold(0.0, f64::max) / largest;
        if change > AT_A_CHANGE * self.error {
            return Some((to, StepError { smooth: 0.0, change, way: 0.0, felt }));
        }
        let at_once = along.step(from, length, to.twist)?;
        // Halves err by a third of the difference where slips along the step are exact, by all of it with two tangential stiffnesses.
        let smooth = to.apart(&at_once) / largest;
        let error = StepError { smooth, change, way: to.apart(from) / largest, felt };
        (smooth.is_finite() && change.is_finite()).then_some((to, error))
    }

    fn arrive(&mut self, journey: &Journey<'g, D, C>, to: Standing<D, C>, error: StepError) -> Step<D, C> {
        let (leg, fraction) = (journey.program.leg, to.fraction);
        let step = Step {
            leg,
            fraction,
            load: journey.program.load_at(fraction),
            sliding: to.states.iter().filter(|state| state.slides()).count(),
            open: to.states.iter().filter(|state| state.is_open()).count(),
            error: error.smooth.max(error.change),
        };
        self.step_error += error.smooth;
        self.change_error = self.change_error.max(error.change);
        self.standing = to;
        step
    }
}

/// What the springs that feel a motion most would make of it, N.
fn most_felt<const D: usize, const C: usize>(sites: &[Site<D, C>], motion: &SVector<f64, D>) -> f64 {
    sites.iter().map(|site| pull(site, motion)).fold(0.0, f64::max)
}

/// What the springs of a contact that sticks make of a motion, N.
fn pull<const D: usize, const C: usize>(site: &Site<D, C>, motion: &SVector<f64, D>) -> f64 {
    site.springs.force(&site.map.tr_mul(motion)).norm()
}
