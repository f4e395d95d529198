//! What every follower of a load program answers, however it finds its way.

use core::fmt::Debug;

use nalgebra::SVector;

use super::beyond::Beyond;
use super::energy::LegEnergy;
use super::event::PathEnd;
use super::journey::Journey;
use super::segment::Segment;
use super::small_motions::EndOfSmallMotions;
use crate::equilibrium::Equilibrium;
use crate::grasp::WholeContact;
use crate::numerics::Size;
use crate::object::Problem;
use crate::prelude::*;
use crate::search::Settings;

/// How far a follower has come.
#[derive(Debug)]
pub(crate) enum Came<T> {
    /// There is something to tell.
    To(T),
    /// Nothing yet.
    OnTheWay,
    /// The leg is done, all of it told.
    ToTheEndOfTheLeg,
}

/// Contacts at the place where they stand, and the rates of what stands on an edge there.
#[derive(Debug)]
pub(crate) struct StandAtEdge<'g, D: Size, const C: usize> {
    pub(super) segment: Segment<'g, D, C>,
    pub(super) rates: Problem<'g, D, C>,
    pub(super) forces: Vec<SVector<f64, C>>,
}

/// A way to follow a program: piece by piece for a few contacts, one event at a time for thousands, in steps. It stands on a leg, and keeps the slip so
/// far; which leg, and what comes after it, is for the path to say.
pub(crate) trait Follower<'g, D: Size, const C: usize>: Debug {
    /// What there is to tell on the way.
    type Report;

    /// The method that takes straight legs alone, if this is its follower.
    const STRAIGHT_ONLY: Option<&'static str> = None;

    /// Sets out on the present leg of the journey.
    ///
    /// # Errors
    /// How the path ends if there is no way to go.
    fn set_out(&mut self, journey: &Journey<'g, D, C>) -> Result<(), PathEnd<C>>;

    /// Goes on to the next place to look at.
    ///
    /// # Errors
    /// How the path ends here.
    fn go_on(&mut self, journey: &Journey<'g, D, C>) -> Result<Came<Self::Report>, PathEnd<C>>;

    /// The fraction of the leg that has been gone.
    fn fraction(&self) -> f64;

    /// The equilibrium there; `None` where rounding does not allow it to be told.
    fn state(&self, journey: &Journey<'g, D, C>) -> Option<Equilibrium<C>>;

    /// Forces there, N, in the contact frames.
    fn forces(&self, journey: &Journey<'g, D, C>) -> Vec<SVector<f64, C>>;

    /// What stands on an edge there.
    fn edge(&self, journey: &Journey<'g, D, C>) -> StandAtEdge<'g, D, C>;

    /// What lies beyond a jump that nothing caught, from a follower whose friction falls; `None` where the path did not end in one.
    fn beyond_a_jump(&self, _settings: &Settings) -> Option<Beyond<C>> {
        None
    }

    /// [`Self::go_on`] no further than a fraction of the leg, for a follower that can stop anywhere.
    ///
    /// # Errors
    /// As for [`Self::go_on`].
    fn go_up_to(
        &mut self,
        journey: &Journey<'g, D, C>,
        _most: f64,
    ) -> Result<Came<Self::Report>, PathEnd<C>> {
        self.go_on(journey)
    }

    /// Whether nothing has to be told or decided before the path goes on.
    fn has_nothing_due(&self) -> bool {
        true
    }

    /// Estimated error of the steps so far; see [`LoadPath::step_error`](super::LoadPath::step_error).
    fn step_error(&self) -> f64 {
        0.0
    }

    /// Energies of the legs so far, from a follower that counts them.
    fn energies(&self) -> &[LegEnergy] {
        &[]
    }

    /// Whether a fraction of a leg lies behind, for a follower that keeps what lies behind.
    fn is_behind(&self, _leg: usize, _fraction: f64) -> bool {
        false
    }

    /// The equilibrium at a fraction of a leg that lies behind; `None` where rounding does not allow it to be told.
    fn state_behind(&self, _leg: usize, _fraction: f64) -> Option<Equilibrium<C>> {
        None
    }

    /// Suction cups whose lips are open all around from here on, for a follower that looks at them.
    fn cups_open(&self, _journey: &Journey<'g, D, C>) -> Vec<WholeContact> {
        Vec::new()
    }

    /// Where motions cease to be small, for a follower that looks at them.
    fn end_of_small_motions(&self) -> Option<&EndOfSmallMotions> {
        None
    }

    /// The leg and its fraction from which on every contact with friction that presses slides, up to a place, for a follower that keeps what lies behind.
    fn all_slide_from(&self, _until: (usize, f64)) -> Option<(usize, f64)> {
        None
    }

    /// How often a contact has been looked at.
    fn contacts_looked_at(&self) -> usize {
        0
    }
}
