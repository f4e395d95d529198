//! Advance from event to event, leg by leg.

use nalgebra::SVector;

use super::bounds_ahead::PieceLength;
use super::patch_event::PatchEvent;
use super::patch_path::{Due, Patch};
use crate::equilibrium::Equilibrium;
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::load_path::event::PathEnd;
use crate::load_path::follower::{Came, Follower, StandAtEdge};
use crate::load_path::following::Following;
use crate::load_path::journey::Journey;
use crate::load_path::leg::Leg;
use crate::load_path::path::{PatchPath, Path};
use crate::prelude::*;
use crate::search::Settings;

/// Most steps of zero length in a row that still count as events of one node: with more, rounding goes in circles.
const MOST_STALLS: usize = 64;

impl<const C: usize> Engine<C> {
    /// [`Grasp::follow_patch`](crate::ask::Grasp::follow_patch).
    pub(crate) fn follow_patch(
        &self,
        start: &Wrench<C>,
        legs: &[Leg<C>],
        settings: &Settings,
    ) -> Result<PatchPath<'_, C>, Error> {
        self.refuse_hands("follow_patch")?;
        self.refuse_kinetic("follow_patch")?;
        let settings = settings.on_the_polygon();
        Ok(Path::new(Box::new(Following::start(self, (start, legs), &settings, Patch::at_start)?)))
    }
}

impl<'g, const C: usize> Follower<'g, C> for Patch<C> {
    type Report = PatchEvent<C>;

    const STRAIGHT_ONLY: Option<&'static str> = Some("follow_patch");

    fn set_out(&mut self, journey: &Journey<'g, C>) -> Result<(), PathEnd<C>> {
        self.begin_leg(journey)
    }

    fn go_on(&mut self, journey: &Journey<'g, C>) -> Result<Came<PatchEvent<C>>, PathEnd<C>> {
        self.go_up_to(journey, 1.0)
    }

    fn go_up_to(&mut self, journey: &Journey<'g, C>, most: f64) -> Result<Came<PatchEvent<C>>, PathEnd<C>> {
        if let Some(event) = self.told.pop() {
            return Ok(Came::To(event));
        }
        let leg_done = match core::mem::take(&mut self.due) {
            Due::Nothing => self.advance(journey, most)?,
            due => {
                self.decide(journey, due)?;
                if due == Due::Start {
                    self.ahead.set_out(&mut self.balance);
                } else {
                    self.ahead.requeue(&mut self.balance);
                }
                false
            }
        };
        Ok(if leg_done { Came::ToTheEndOfTheLeg } else { Came::OnTheWay })
    }

    fn has_nothing_due(&self) -> bool {
        self.told.is_empty() && self.due == Due::Nothing
    }

    fn contacts_looked_at(&self) -> usize {
        self.balance.looked_at
    }

    fn fraction(&self) -> f64 {
        self.balance.tau
    }

    fn state(&self, journey: &Journey<'g, C>) -> Option<Equilibrium<C>> {
        Some(self.equilibrium(journey))
    }

    fn forces(&self, journey: &Journey<'g, C>) -> Vec<SVector<f64, C>> {
        self.forces_at(journey.grasp.sites(), &self.balance.balanced())
    }

    fn edge(&self, journey: &Journey<'g, C>) -> StandAtEdge<'g, C> {
        self.all_contacts(journey)
    }
}

impl<'g, const C: usize> Patch<C> {
    /// Advances to the next event of the leg, or up to this fraction of it. Whether the leg is done.
    fn advance(&mut self, journey: &Journey<'g, C>, most: f64) -> Result<bool, PathEnd<C>> {
        let before = self.balance.tau;
        match self.ahead.first_exits(&mut self.balance, most - before) {
            PieceLength::ToAnEdge(step) => {
                self.ahead.go_to(&mut self.balance, before + step);
                self.ahead.correct(&mut self.balance, before);
                self.stalls = if self.balance.tau > before { 0 } else { self.stalls + 1 };
                if self.stalls > MOST_STALLS {
                    return Err(self.undecided(journey));
                }
                self.stand();
                self.due = Due::Event;
                Ok(false)
            }
            PieceLength::ToTheEnd => {
                self.ahead.go_to(&mut self.balance, most);
                if most < 1.0 {
                    self.ahead.requeue(&mut self.balance);
                }
                Ok(most >= 1.0)
            }
        }
    }

    /// Collects the evaluated contacts that are on an edge now.
    fn stand(&mut self) {
        let Self { stands, ahead, balance, .. } = self;
        stands.clear();
        let exits = &mut ahead.exits;
        exits.sort_unstable_by_key(|exit| exit.contact);
        for exit in exits.iter() {
            if stands.last().is_none_or(|stand| stand.contact != exit.contact) {
                stands.push(balance.stand_of(exit.contact));
            }
            if let Some(stand) = stands.last_mut() {
                stand.reach(exit.bound);
            }
        }
        let reached = stands.len();
        for &contact in ahead.looked() {
            if stands[..reached].binary_search_by_key(&contact, |stand| stand.contact).is_err() {
                let stand = balance.stand_of(contact);
                // A sliding contact is on its own facets, and is decided anew only if it is on more.
                let own = stand.was.own_facets(C).iter().flatten().count();
                if stand.apex || stand.facets().len() > own {
                    stands.push(stand);
                }
            }
        }
    }
}
