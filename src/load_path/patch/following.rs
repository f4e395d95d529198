//! From event to event, leg by leg.

use std::sync::Arc;

use super::bounds_ahead::Piece;
use super::patch_event::PatchEvent;
use super::patch_path::{Due, PatchPath};
use crate::contact::{Polygon, PolygonCone};
use crate::error::Error;
use crate::grasp::{Grasp, Wrench};
use crate::load_path::event::PathEnd;
use crate::load_path::leg::{Leg, Program};
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
    /// As for [`Self::follow`].
    pub fn follow_patch(
        &self,
        start: &Wrench<D, C>,
        legs: &[Leg<D, C>],
    ) -> Result<PatchPath<'_, D, C>, Error> {
        self.follow_patch_on(start, legs, PolygonCone::default())
    }

    /// The same on another polygonal cone; in the plane it is not looked at.
    ///
    /// # Errors
    /// As for [`Self::follow`].
    pub fn follow_patch_on(
        &self,
        start: &Wrench<D, C>,
        legs: &[Leg<D, C>],
        cone: PolygonCone,
    ) -> Result<PatchPath<'_, D, C>, Error> {
        self.refuse_hands("follow_patch")?;
        let wrench = self.load_alone(start, "start load")?;
        let mut program = Program::new(self, *start);
        program.extend_straight(self, legs, "follow_patch")?;
        let (polygon, settings) = (Arc::new(Polygon::new(&cone)), Settings::default().with_cone(cone));
        Ok(PatchPath::new(self, program, polygon, settings.on_the_polygon(), &wrench))
    }
}

impl<const D: usize, const C: usize> PatchPath<'_, D, C> {
    /// Appends legs to the program; a completed path goes on, one that has ended otherwise does
    /// not.
    ///
    /// # Errors
    /// As for [`Grasp::follow`].
    pub fn continue_with(&mut self, legs: &[Leg<D, C>]) -> Result<(), Error> {
        self.program.extend_straight(self.grasp, legs, "continue_with of a patch")?;
        if matches!(self.end, Some(PathEnd::Completed)) && !legs.is_empty() {
            self.end = None;
            self.begin_leg();
        }
        Ok(())
    }

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
        while self.told.is_empty() && self.end.is_none() {
            match std::mem::take(&mut self.due) {
                Due::Nothing => {
                    let here = (self.program.leg, self.balance.tau);
                    if here.0 > leg || (here.0 == leg && here.1 >= fraction) {
                        return None;
                    }
                    self.advance(if here.0 == leg { fraction.min(1.0) } else { 1.0 });
                }
                due => match self.decide(due) {
                    Err(end) => self.end = Some(end),
                    Ok(()) if due == Due::Start => self.ahead.set_out(&mut self.balance),
                    Ok(()) => self.ahead.requeue(&mut self.balance),
                },
            }
        }
        self.told.pop()
    }

    /// Goes on to the next event of the leg, or up to this fraction of it.
    fn advance(&mut self, most: f64) {
        let before = self.balance.tau;
        match self.ahead.first_exits(&mut self.balance, most - before) {
            Piece::ToAnEdge(step) => {
                self.ahead.go_to(&mut self.balance, before + step);
                self.ahead.correct(&mut self.balance, before);
                self.stalls = if self.balance.tau > before { 0 } else { self.stalls + 1 };
                if self.stalls > MOST_STALLS {
                    self.end = Some(self.undecided());
                    return;
                }
                self.stand();
                self.due = Due::Event;
            }
            Piece::ToTheEnd => {
                self.ahead.go_to(&mut self.balance, most);
                if most < 1.0 {
                    self.ahead.requeue(&mut self.balance);
                    return;
                }
                self.program.leg += 1;
                self.begin_leg();
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

impl<const D: usize, const C: usize> Iterator for PatchPath<'_, D, C> {
    type Item = PatchEvent<D, C>;

    fn next(&mut self) -> Option<PatchEvent<D, C>> {
        self.next_before(usize::MAX, 0.0)
    }
}
