//! The interface of the two methods that follow a load program, piece by piece or in steps.

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
use crate::object::Problem;
use crate::prelude::*;
use crate::search::Settings;

/// Result of one call of [`Follower::advance`], with an event or a step of type `T`.
#[derive(Debug)]
pub(crate) enum Advance<T> {
    /// The follower has reached an event or the end of a step, which the path returns to the caller.
    Reached(T),
    /// The follower has advanced, and has no event or step for the caller.
    OnTheWay,
    /// The leg is complete, and all its events or steps have been returned.
    EndOfLeg,
}

/// The state at the present place, and `rates`, the complementarity problem for the rates of forces and motion. Its solution decides whether contacts
/// on the edge of their cones stick, slide or open.
#[derive(Debug)]
pub(crate) struct StateAtEdge<'g> {
    pub(super) segment: Segment<'g>,
    pub(super) rates: Problem<'g>,
    pub(super) forces: Vec<SVector<f64, 3>>,
}

/// A method of following a program: piece by piece for a few contacts, or in steps for thousands. The follower stores its place on the present leg
/// and the slips so far; the [`Journey`] stores the legs.
pub(crate) trait Follower<'g>: Debug {
    /// The type of the items that the path returns: events, or steps.
    type Report;

    /// Starts the present leg of the program.
    ///
    /// # Errors
    /// The end of the path, if the leg cannot start.
    fn start_leg(&mut self, journey: &Journey<'g>) -> Result<(), PathEnd<3>>;

    /// Advances to the next place of an event, or by a step, or decides how the path continues at the present place.
    ///
    /// # Errors
    /// The end of the path, if it ends here.
    fn advance(&mut self, journey: &Journey<'g>) -> Result<Advance<Self::Report>, PathEnd<3>>;

    /// The fraction of the leg already followed.
    fn fraction(&self) -> f64;

    /// The equilibrium at the present place; `None` if it cannot be computed because of rounding.
    fn state(&self, journey: &Journey<'g>) -> Option<Equilibrium<3>>;

    /// Contact forces at the present place, N, in the contact frames.
    fn forces(&self, journey: &Journey<'g>) -> Vec<SVector<f64, 3>>;

    /// The state at the present place, with the complementarity problem for the rates of forces and motion; contacts on the edge of their cones may
    /// slide or open in it.
    fn edge(&self, journey: &Journey<'g>) -> StateAtEdge<'g>;

    /// The situation beyond a jump that found no equilibrium, from a follower that knows kinetic friction; `None` if the path did not end in such a jump.
    fn beyond_a_jump(&self, _settings: &Settings) -> Option<Beyond<3>> {
        None
    }

    /// Estimated error of the steps so far; see [`LoadPath::step_error`](super::LoadPath::step_error).
    fn step_error(&self) -> f64 {
        0.0
    }

    /// Energies of the legs so far; empty from a follower that does not add them up.
    fn energies(&self) -> &[LegEnergy] {
        &[]
    }

    /// Whether this fraction of a leg has been passed; false from a follower that does not store its past.
    fn is_behind(&self, _leg: usize, _fraction: f64) -> bool {
        false
    }

    /// The equilibrium at a fraction of a leg already passed; `None` if it cannot be computed because of rounding.
    fn state_behind(&self, _leg: usize, _fraction: f64) -> Option<Equilibrium<3>> {
        None
    }

    /// Suction cups whose lips are open all around from here on; empty from a follower that does not check them.
    fn cups_open(&self, _journey: &Journey<'g>) -> Vec<WholeContact> {
        Vec::new()
    }

    /// The place where motions cease to be small; `None` from a follower that does not check them.
    fn end_of_small_motions(&self) -> Option<&EndOfSmallMotions> {
        None
    }

    /// The largest ratio so far of a rotation, slip or opening to its limit of small motions; zero from a follower that does not check them.
    fn farthest(&self) -> f64 {
        0.0
    }

    /// The leg and fraction from which every contact with friction and a normal force slides up to `until`, from a follower that stores its past.
    fn all_slide_from(&self, _until: (usize, f64)) -> Option<(usize, f64)> {
        None
    }
}
