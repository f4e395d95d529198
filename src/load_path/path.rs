//! A load program being followed, by whichever follower: how it starts, goes from leg to leg, and ends.

use nalgebra::SVector;

use super::beyond::{Beyond, End, beyond_end};
use super::event::PathEnd;
use super::follower::{Came, Edge, Follower};
use super::journey::Journey;
use super::leg::Leg;
use crate::equilibrium::Equilibrium;
use crate::error::Error;
use crate::grasp::{Grasp, Wrench};
use crate::object::Problem;
use crate::search::{Settings, settle};

/// A load program being followed: an iterator over what happens on the way, so that the caller may look at each event or step and stop at any. When the
/// iterator has ended, [`end`](Self::end) says how the path did.
///
/// What there is to tell, and how many contacts are affordable, depends on the follower: [`LoadPath`](super::LoadPath),
/// [`PatchPath`](super::PatchPath) or [`SteppedPath`](super::SteppedPath). The law is one: contacts stick, slide with memory of their slip, open and
/// close again.
#[derive(Debug)]
pub struct Path<'g, const D: usize, const C: usize, F> {
    pub(super) journey: Journey<'g, D, C>,
    /// `None` if there is no equilibrium to start from.
    pub(super) follower: Option<F>,
    end: Option<PathEnd<D, C>>,
}

impl<'g, const D: usize, const C: usize, F: Follower<'g, D, C>> Path<'g, D, C, F> {
    /// A path from rest under a load, where a follower begins at the equilibrium if there is one, with the first leg before it.
    pub(super) fn start(
        grasp: &'g Grasp<D, C>,
        (start, legs): (&Wrench<D, C>, &[Leg<D, C>]),
        settings: &Settings,
        begin: impl FnOnce(&Journey<'g, D, C>, &Problem<'g, D, C>) -> Result<F, PathEnd<D, C>>,
    ) -> Result<Self, Error> {
        let mut journey = Journey::new(grasp, start, settings)?;
        journey.extend(legs, F::STRAIGHT_ONLY)?;
        let problem = journey.problem_at_start();
        let goes = journey.program.begin_leg();
        let mut path = match begin(&journey, &problem) {
            Ok(follower) => Self { journey, follower: Some(follower), end: None },
            Err(end) => Self { journey, follower: None, end: Some(end) },
        };
        path.set_out(goes);
        Ok(path)
    }

    /// How the path ended; `None` while there is more to follow. `Completed` may become `None` again, see [`Self::continue_with`].
    #[must_use]
    pub fn end(&self) -> Option<&PathEnd<D, C>> {
        self.end.as_ref()
    }

    /// Where the path stands: the leg, from 0, and how much of it has been gone, from 0 to 1. A completed path stands at the end of its last leg.
    #[must_use]
    pub fn place(&self) -> (usize, f64) {
        let fraction = self.follower.as_ref().map_or(0.0, Follower::fraction);
        self.journey.program.place(fraction)
    }

    /// The equilibrium where the path stands, with residuals recomputed from the grasp, the load and the slip so far; `None` if there was none to
    /// start from, or where rounding does not allow it to be told. It is not checked against its residuals: look at them. Where an event lies exactly
    /// here, its states may be those before the event or those with which the path goes on.
    #[must_use]
    pub fn state(&self) -> Option<Equilibrium<D, C>> {
        self.follower.as_ref()?.state(&self.journey)
    }

    /// Forces on the object in the contact frames where the path stands, N: (`F_n`, `F_t`…), in the order of the grasp; empty if there was no
    /// equilibrium to start from. Cheaper than [`Self::state`].
    #[must_use]
    pub fn forces(&self) -> Vec<SVector<f64, C>> {
        let mut forces =
            self.follower.as_ref().map(|follower| follower.forces(&self.journey)).unwrap_or_default();
        forces.truncate(self.journey.grasp.len());
        forces
    }

    /// Follows the path to its end and returns what there is to tell on the way.
    pub fn run(&mut self) -> Vec<F::Told> {
        self.by_ref().collect()
    }

    /// Appends legs to the program; a completed path goes on, one that has ended otherwise does not.
    ///
    /// # Errors
    /// As for the method that has made the path.
    pub fn continue_with(&mut self, legs: &[Leg<D, C>]) -> Result<(), Error> {
        self.journey.extend(legs, F::STRAIGHT_ONLY)?;
        if matches!(self.end, Some(PathEnd::Completed)) {
            let goes = self.journey.program.begin_leg();
            self.set_out(goes);
        }
        Ok(())
    }

    /// Whether another equilibrium exists just beyond where this one was lost; `None` where the path has not been lost.
    /// See [`Self::beyond_with`].
    #[must_use]
    pub fn beyond(&self) -> Option<Beyond<D, C>> {
        self.beyond_with(&self.journey.settings)
    }

    /// Whether another equilibrium exists just beyond where this one was lost, with the slip so far, sought as far as these [`Settings`]
    /// allow. That takes longer than the path as a rule, in space up to a proof over all contact states. Among more contacts than all states can be
    /// tried of, a limit load is told from other ends where a motion proves it. `None` where the path has not been lost.
    #[must_use]
    pub fn beyond_with(&self, settings: &Settings) -> Option<Beyond<D, C>> {
        let loss = self.end.as_ref()?.loss()?;
        let Edge { segment, rates, forces } = self.follower.as_ref()?.edge(&self.journey);
        let motion = loss.motion.map(|motion| self.journey.grasp.inside_twist(&motion));
        let end = End { factor: loss.fraction, forces: &forces, motion };
        let (settled, effort) = settle(&rates, settings);
        Some(beyond_end(&segment, &rates, (settled, &effort), &end, settings))
    }

    /// Sets out on the present leg if there is one, or completes the path.
    fn set_out(&mut self, goes: bool) {
        if let Some(follower) = &mut self.follower {
            self.end = if goes { follower.set_out(&self.journey).err() } else { Some(PathEnd::Completed) };
        }
    }

    /// What a follower has to tell when it goes on in this way; `None` where the path has ended or there is nothing to tell yet.
    pub(super) fn go(
        &mut self,
        on: impl FnOnce(&mut F, &Journey<'g, D, C>) -> Result<Came<F::Told>, PathEnd<D, C>>,
    ) -> Option<F::Told> {
        match on(self.follower.as_mut()?, &self.journey) {
            Ok(Came::To(told)) => return Some(told),
            Ok(Came::OnTheWay) => {}
            Ok(Came::ToTheEndOfTheLeg) => {
                let goes = self.journey.program.next_leg();
                self.set_out(goes);
            }
            Err(end) => self.end = Some(end),
        }
        None
    }
}

impl<'g, const D: usize, const C: usize, F: Follower<'g, D, C>> Iterator for Path<'g, D, C, F> {
    type Item = F::Told;

    fn next(&mut self) -> Option<F::Told> {
        while self.end.is_none() {
            if let told @ Some(_) = self.go(F::go_on) {
                return told;
            }
        }
        None
    }
}
