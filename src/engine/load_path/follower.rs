//! The interface of the two methods that follow a load program: piece by piece (a piece is a part of a leg with fixed contact states), or in steps. A
//! leg is a section of the load program; at an event contacts change their states (open, sticking or sliding). Motions are small as long as
//! rotations, slips and openings stay below the limits of the settings. A drive, the spring of a joint or tendon of a hand with its force limit, is
//! treated like a contact.

use core::fmt::Debug;

use nalgebra::SVector;

use super::beyond::Beyond;
use super::energy::LegEnergy;
use super::event::PathEnd;
use super::program_run::ProgramRun;
use super::segment::Segment;
use super::small_motions::EndOfSmallMotions;
use crate::equilibrium::Equilibrium;
use crate::grasp::WholeContact;
use crate::object::Problem;
use crate::prelude::*;
use crate::search::Settings;

#[derive(Debug)]
pub(crate) enum Advance<T> {
    /// The follower has reached an event or the end of a step, which the path returns to the caller.
    Reached(T),
    /// The follower has advanced, or has computed how the path continues, but has nothing yet to return to the caller.
    OnTheWay,
    /// The leg (section of the load program) is complete, and all its events or steps have been returned to the caller.
    EndOfLeg,
}

/// The contact forces at the present point of a path, and `rates`, the complementarity problem for the rates of forces and motion there (rate
/// problem). The solution of the rate problem decides whether contacts on the boundary of their cones stick, slide or open.
#[derive(Debug)]
pub(crate) struct StateAtEdge<'g> {
    pub(super) segment: Segment<'g>,
    pub(super) rates: Problem<'g>,
    pub(super) forces: Vec<SVector<f64, 3>>,
}

/// A method of following a load program: piece by piece for a few contacts, or in steps for thousands. The follower stores the fraction of the
/// present leg that is done, and the accumulated slips; the [`ProgramRun`] stores the legs.
pub(crate) trait Follower<'g>: Debug {
    /// The type of the items that the path returns to its caller: events, or steps.
    type Report;

    /// Starts the present leg of the program.
    ///
    /// # Errors
    /// The end of the path, if the leg cannot start.
    fn start_leg(&mut self, run: &ProgramRun<'g>) -> Result<(), PathEnd<3>>;

    /// Advances to the next event or by one step, or only computes how the path continues from its present point.
    ///
    /// # Errors
    /// The end of the path, if it ends here.
    fn advance(&mut self, run: &ProgramRun<'g>) -> Result<Advance<Self::Report>, PathEnd<3>>;

    /// The fraction of the present leg that is done, from 0 to 1.
    fn fraction(&self) -> f64;

    /// The equilibrium at the present point of the path; `None` if it cannot be computed because of rounding.
    fn state(&self, run: &ProgramRun<'g>) -> Option<Equilibrium<3>>;

    /// Forces of all contacts and drives at the present point of the path, N, in the contact frames.
    fn forces(&self, run: &ProgramRun<'g>) -> Vec<SVector<f64, 3>>;

    /// The contact forces, and the complementarity problem for the rates of forces and motion, at the present point of the path. In this problem
    /// contacts on the boundary of their cones may slide or open.
    fn edge(&self, run: &ProgramRun<'g>) -> StateAtEdge<'g>;

    /// The situation beyond the end of the path, if the path ended in a jump: friction fell to its kinetic value at constant load, and no equilibrium
    /// was found. Otherwise `None`. A follower that does not treat kinetic friction always returns `None`.
    fn beyond_a_jump(&self, _settings: &Settings) -> Option<Beyond<3>> {
        None
    }

    /// Estimated relative error of all steps so far; zero without steps.
    fn step_error(&self) -> f64 {
        0.0
    }

    /// Energies of each leg so far, including the present leg; empty from a follower that does not add them up.
    fn energies(&self) -> &[LegEnergy] {
        &[]
    }

    /// The equilibrium at the fraction `_fraction` of the leg `_leg`. `None` if the path has not passed this fraction, if rounding prevents the
    /// computation, or from a follower that does not store its past.
    fn state_behind(&self, _leg: usize, _fraction: f64) -> Option<Equilibrium<3>> {
        None
    }

    /// Suction cups whose lips are open all around at the present point of the path, so that their vacuum is gone. Empty from a follower that
    /// does not check suction cups.
    fn cups_open(&self, _journey: &ProgramRun<'g>) -> Vec<WholeContact> {
        Vec::new()
    }

    /// The point of the path at which a motion exceeded its limit of small motions. `None` if no motion has exceeded it, or from a follower that
    /// does not check the limits.
    fn end_of_small_motions(&self) -> Option<&EndOfSmallMotions> {
        None
    }

    /// The largest ratio, on the path so far, of a rotation, slip or opening to its limit of small motions. Zero from a follower that does not check
    /// the limits.
    fn farthest(&self) -> f64 {
        0.0
    }

    /// The place (leg and fraction of it) from which on every contact with friction and a normal force slides, up to the place `until`. `None` if
    /// some such contact sticks just before `until`, or from a follower that does not store its past.
    fn all_slide_from(&self, _until: (usize, f64)) -> Option<(usize, f64)> {
        None
    }

    /// The places (leg and fraction of it) at which pieces of the path end on which nothing slides, before a piece on which something does, or before
    /// the present place. Empty from a follower that does not store its past.
    fn sticks_until(&self) -> Vec<(usize, f64)> {
        Vec::new()
    }
}
