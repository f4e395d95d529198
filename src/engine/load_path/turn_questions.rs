//! The onset while a load turns, i.e. the angle at which the first contact slides or opens.
//!
//! While all contacts stick, the force of each is `F(θ) = F⁰ + F^c cos θ + F^s sin θ` at the angle θ of the load. Three linear solves give F⁰, F^c
//! and F^s. The margin of a contact is the distance of its force from the boundary of its friction cone. The contact stops sticking at the first
//! angle at which its margin becomes negative. The margin is a trigonometric polynomial of the angle: of degree one for each facet, of degree two on
//! the round cone.

use super::first_to_leave::{WhileTurning, first_to_leave_on_turn};
use super::onset::Onset;
use super::onset_workspace::OnsetMemory;
use super::trajectory::Trajectory;
use super::turn::{EdgeTouch, Turn};
use crate::error::Error;
use crate::grasp::Engine;
use crate::prelude::*;
use crate::search::{Settings, settle_at_rest};

/// The onset of a turn: the angle at which the first contact stops sticking, and contacts whose forces touch the boundary of their cones before that.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct TurnOnset<const C: usize> {
    /// The onset; its field for the load factor has the angle, rad. [`Onset::Never`] means that all contacts stick up to the last angle of the turn.
    pub onset: Onset<C>,
    /// Contacts and drives that reach the boundary of their cone within rounding, without crossing it, before the onset. If there are any, a change
    /// of the last digits of the given grasp or load may turn such a touch into the onset.
    pub touches: Vec<EdgeTouch>,
    /// The turn of which this is the onset.
    pub turn: Turn<C>,
}

impl Engine {
    pub(crate) fn onset_of_turn(&self, turn: &Turn<3>, settings: &Settings) -> Result<TurnOnset<3>, Error> {
        turn.check_in(self.space())?;
        let inside = turn.inside(self);
        let mut memory = OnsetMemory::default();
        memory.change = self.offset_changes(None, None);
        let segment = memory.segment(self, settings, Trajectory::Turn { load: inside.clone(), angle: 1.0 });
        let (onset, touches) = match first_to_leave_on_turn(&segment, turn, &inside) {
            Some(WhileTurning::Never) => (Onset::Never, Vec::new()),
            Some(WhileTurning::First(first)) => {
                let load = turn.load_at(first.factor);
                (first.onset(segment, load, &mut memory), Vec::new())
            }
            None => {
                let trajectory = Trajectory::Turn { load: turn.load, angle: 1.0 };
                let rest = settle_at_rest(&segment.problem, settings);
                self.onset_with_closing(segment, &rest, (trajectory, turn.angle), settings)
            }
        };
        Ok(TurnOnset { onset, touches, turn: *turn })
    }
}
