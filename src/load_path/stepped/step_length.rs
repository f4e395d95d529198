//! Steps as long as the error asked for allows.

use super::one_step::{SHORTEST, SteppedState};
use super::places::Places;
use super::stepped_path::{Step, Steps};
use crate::grasp::Site;
use crate::load_path::event::PathEnd;
use crate::load_path::follower::Came;
use crate::load_path::journey::Journey;
use crate::numerics::{Size, Vector};
#[cfg(not(feature = "std"))]
use crate::prelude::*;
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
/// What steps and their halves miss alike happens to a contact a few times a leg: each time this part of the error is allowed.
const UNSEEN: f64 = 0.1;
/// Of the error that a step would make if all made the same, for the way they go: forces may go farther than the leg is long, and the object farther
/// than forces. What is wrong of a direction is forgotten while springs that stick would feel the object to go as far as the largest force.
const EVEN: f64 = 0.5;
/// Of the error that the steps before have left to a contact a step may make this part. With more a few steps use it up, and the others have as
/// little as if nothing were ever forgotten; with less they are shorter than the error asks for.
const OF_WHAT_IS_LEFT: f64 = 0.05;
/// The error is left to a contact in proportion to the way that forces have gone, over the largest one, up to so many times the error: it is a third of
/// what two paths are apart. With more it would outgrow what was asked for.
const ALTOGETHER: f64 = 2.0;
/// A step is a jump if the object is farther than this part of it from its middle halfway …
const LEAP: f64 = 0.25;
/// … and if springs would feel the step by more than this part of the largest force.
const FELT: f64 = 0.05;

/// What a step that is made twice tells.
#[derive(Debug)]
struct Twice {
    /// The largest contact force on the way, N.
    largest: f64,
    /// What both miss alike, over the largest force.
    unseen: f64,
    /// How far springs that stick would feel the object to have gone, N.
    felt: f64,
}

impl<'g, D: Size, const C: usize> Steps<'g, D, C> {
    /// Tries a step; what it is if it errs by no more than is allowed.
    pub(super) fn try_a_step(&mut self, journey: &Journey<'g, D, C>) -> Result<Came<Step<C>>, PathEnd<C>> {
        let from = self.standing.fraction;
        if self.pace.tried == journey.settings.most_steps {
            return Err(journey.undecided(from, Doubt::OutOfSteps));
        }
        self.pace.tried += 1;
        let rest = 1.0 - from;
        let step = self.pace.step.min(self.pace.longest);
        let length = if step > 0.9 * rest { rest } else { step };
        let Some(twice) = self.twice(length) else {
            self.pace.step = length * NOWHERE;
            return if self.pace.step < SHORTEST {
                Err(self.end_here(journey, Doubt::OnTheBoundary))
            } else {
                Ok(Came::OnTheWay)
            };
        };
        let part = self.part_of_what_is_allowed(&twice);
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
        let to = &self.places.to;
        self.pace.rate = Some((&to.twist - &self.standing.twist) / length);
        self.pace.speeds.note(to.fraction, twice.felt / length);
        self.pace.changed = to.apart(&self.standing) / twice.felt;
        Ok(Came::To(self.arrive(journey, &twice)))
    }

    /// The error of a step, as a part of what it may be.
    fn part_of_what_is_allowed(&self, twice: &Twice) -> f64 {
        let (from, Places { to, at_once, .. }, largest) = (&self.standing, &self.places, twice.largest);
        let length = to.fraction - from.fraction;
        let way = to.apart(from) / largest;
        let even = EVEN * self.error * length.max(way).max(twice.felt / largest);
        let budget = self.error * (self.way + way).min(ALTOGETHER);
        let part = |i: usize| {
            let so_far = (from.forces[i] - self.coarse.standing.forces[i]).norm() / largest;
            let allowed = even.max(OF_WHAT_IS_LEFT * (budget - so_far)).max(ROUNDING);
            (to.forces[i] - at_once.forces[i]).norm() / largest / allowed
        };
        let seen = (0..to.forces.len()).map(part).fold(0.0, f64::max);
        seen.max(twice.unseen / (UNSEEN * self.error).max(ROUNDING))
    }

    /// A step in two halves and at once; `None` where one of them finds no equilibrium, or only one
    /// elsewhere.
    fn twice(&mut self, length: f64) -> Option<Twice> {
        let Self { along, standing: from, places: Places { middle, to, at_once, .. }, .. } = self;
        let rate = self.pace.rate.clone().unwrap_or_else(Vector::zeros);
        let near = |at: &SteppedState<D, C>, rate: &Vector<D>, length: f64| &at.twist + rate * length;
        along.step(from, (0.5 * length, near(from, &rate, 0.5 * length)), middle)?;
        let rate = (&middle.twist - &from.twist) / (0.5 * length);
        along.step(middle, (0.5 * length, near(middle, &rate, 0.5 * length)), to)?;
        let largest = to.largest_force().max(from.largest_force()).max(f64::MIN_POSITIVE);
        let off = &middle.twist - (&from.twist + &to.twist) * 0.5;
        let sites = along.problem.sites;
        let felt = most_felt(sites, &(&to.twist - &from.twist));
        if felt > FELT * largest && most_felt(sites, &off) > LEAP * felt {
            return None;
        }
        let unseen = along.unseen([from, middle, to]) / largest;
        along.step(from, (length, to.twist.clone()), at_once)?;
        let finite = unseen.is_finite() && (to.apart(at_once) / largest).is_finite();
        finite.then_some(Twice { largest, unseen, felt })
    }

    fn arrive(&mut self, journey: &Journey<'g, D, C>, twice: &Twice) -> Step<C> {
        let Twice { largest, unseen, .. } = *twice;
        let Places { to, at_once, beside, .. } = &mut self.places;
        self.coarse.follow(&mut self.along, [&self.standing, to, at_once], beside);
        self.unseen = self.unseen.max(unseen);
        self.way += to.apart(&self.standing) / largest;
        let error = (to.apart(at_once) / largest).max(unseen);
        core::mem::swap(&mut self.standing, to);
        let to = &self.standing;
        let (leg, fraction) = (journey.program.leg, to.fraction);
        Step {
            leg,
            fraction,
            load: journey.program.load_at(fraction),
            sliding: to.states.iter().filter(|state| state.slides()).count(),
            open: to.states.iter().filter(|state| state.is_open()).count(),
            error,
        }
    }
}

/// What the springs that feel a motion most would make of it, N.
fn most_felt<D: Size, const C: usize>(sites: &[Site<D, C>], motion: &Vector<D>) -> f64 {
    sites.iter().map(|site| pull(site, motion)).fold(0.0, f64::max)
}

/// What the springs of a contact that sticks make of a motion, N.
fn pull<D: Size, const C: usize>(site: &Site<D, C>, motion: &Vector<D>) -> f64 {
    site.springs.force(&site.map.tr_mul(motion)).norm()
}
