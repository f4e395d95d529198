//! From event to event, leg by leg.

use nalgebra::SVector;

use super::bounds_ahead::Piece;
use super::patch_event::PatchEvent;
use super::patch_path::{Due, Patch, PatchPath};
use crate::equilibrium::Equilibrium;
use crate::error::Error;
use crate::grasp::{Grasp, Wrench};
use crate::load_path::event::PathEnd;
use crate::load_path::follower::{Came, Edge, Follower};
use crate::load_path::journey::Journey;
use crate::load_path::leg::Leg;
use crate::load_path::path::Path;
use crate::search::Settings;

/// Steps of no length in a row that are still events of one node: with more, rounding goes in
/// circles.
const MOST_STALLS: usize = 64;

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// Follows a load program from the equilibrium under `start` with the finger commands of the
    /// grasp, for any number of contacts. An event costs about as much as the contacts that it
    /// concerns. In space on the default polygonal cone, 8 facets inside the round one; for the round one
    /// there is [`Self::follow_in_steps`]. See [`PatchPath`].
    ///
    /// # Errors
    /// As for [`Self::follow`]; [`Error::NotForHands`]; [`Error::StraightOnly`] if the load of a leg turns.
    pub fn follow_patch(
        &self,
        start: &Wrench<D, C>,
        legs: &[Leg<D, C>],
    ) -> Result<PatchPath<'_, D, C>, Error> {
        self.follow_patch_with(start, legs, &Settings::default())
    }

    /// The same with other [`Settings`]: on another polygonal [cone](Settings::cone). Whether they ask for the round one is not looked at.
    ///
    /// # Errors
    /// As for [`Self::follow_patch`].
    pub fn follow_patch_with(
        &self,
        start: &Wrench<D, C>,
        legs: &[Leg<D, C>],
        settings: &Settings,
    ) -> Result<PatchPath<'_, D, C>, Error> {
        self.refuse_hands("follow_patch")?;
        Path::start(self, (start, legs), &settings.on_the_polygon(), Patch::at_start)
    }
}

impl<const D: usize, const C: usize> PatchPath<'_, D, C> {
    /// The next event up to a fraction (0 to 1) of a leg (from 0); `None` when the path stands
    /// there, or has ended before. To look at a state on the way, take events until there are none,
    /// then ask for [`state`](Self::state).
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};
    ///
    /// // A body of 2 N on two feet of 1 N: the second slides when each carries 0.25 N.
    /// let foot = |x: f64, mu: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(10.0, 10.0).friction(mu);
    /// let grasp = Grasp::new([foot(-1.0, 0.5), foot(1.0, 0.25)])?;
    /// let mut path = grasp.follow_patch(&Wrench::force([0.0, -2.0]), &[Leg::load_by(Wrench::force([0.6, 0.0]))])?;
    ///
    /// assert!(path.next_before(0, 0.5).is_none());
    /// assert!((path.state().expect("on the way").contacts[1].tangential_force() + 0.15).abs() < 1e-15);
    /// let event = path.next_before(0, 1.0).expect("slides");
    /// assert!(event.contact == 1 && (event.load.resultant()[0] - 0.5).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    pub fn next_before(&mut self, leg: usize, fraction: f64) -> Option<PatchEvent<D, C>> {
        loop {
            let patch = self.follower.as_ref()?;
            let (here, stop) = (self.place(), (leg, fraction));
            if self.end().is_some() || (here >= stop && patch.has_nothing_due()) {
                return None;
            }
            let most = if here.0 == leg { fraction.min(1.0) } else { 1.0 };
            if let event @ Some(_) = self.go(|patch, journey| patch.go_up_to(journey, most)) {
                return event;
            }
        }
    }
}

impl<'g, const D: usize, const C: usize> Follower<'g, D, C> for Patch<D, C> {
    type Told = PatchEvent<D, C>;

    const STRAIGHT_ONLY: Option<&'static str> = Some("follow_patch");

    fn set_out(&mut self, journey: &Journey<'g, D, C>) -> Result<(), PathEnd<D, C>> {
        self.begin_leg(journey)
    }

    fn go_on(&mut self, journey: &Journey<'g, D, C>) -> Result<Came<PatchEvent<D, C>>, PathEnd<D, C>> {
        self.go_up_to(journey, 1.0)
    }

    fn fraction(&self) -> f64 {
        self.balance.tau
    }

    fn state(&self, journey: &Journey<'g, D, C>) -> Option<Equilibrium<D, C>> {
        Some(self.equilibrium(journey))
    }

    fn forces(&self, journey: &Journey<'g, D, C>) -> Vec<SVector<f64, C>> {
        self.forces_at(journey.grasp.sites(), &self.balance.balanced())
    }

    fn edge(&self, journey: &Journey<'g, D, C>) -> Edge<'g, D, C> {
        self.all_contacts(journey)
    }
}

impl<'g, const D: usize, const C: usize> Patch<D, C> {
    /// Whether nothing has to be told or decided before the path goes on.
    fn has_nothing_due(&self) -> bool {
        self.told.is_empty() && self.due == Due::Nothing
    }

    /// Goes on up to this fraction of the leg.
    fn go_up_to(
        &mut self,
        journey: &Journey<'g, D, C>,
        most: f64,
    ) -> Result<Came<PatchEvent<D, C>>, PathEnd<D, C>> {
        if let Some(event) = self.told.pop() {
            return Ok(Came::To(event));
        }
        let leg_done = match std::mem::take(&mut self.due) {
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

    /// Goes on to the next event of the leg, or up to this fraction of it. Whether the leg is done.
    fn advance(&mut self, journey: &Journey<'g, D, C>, most: f64) -> Result<bool, PathEnd<D, C>> {
        let before = self.balance.tau;
        match self.ahead.first_exits(&mut self.balance, most - before) {
            Piece::ToAnEdge(step) => {
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
            Piece::ToTheEnd => {
                self.ahead.go_to(&mut self.balance, most);
                if most < 1.0 {
                    self.ahead.requeue(&mut self.balance);
                }
                Ok(most >= 1.0)
            }
        }
    }

    /// What was looked at and stands on an edge now.
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
                // A sliding contact stands on its own facets, and is not asked unless it stands on
                // more.
                let own = stand.was.own_facets(C).iter().flatten().count();
                if stand.apex || stand.facets().len() > own {
                    stands.push(stand);
                }
            }
        }
    }
}
