//! The continuation after an event, decided among the contacts on an edge.
//!
//! In rates each of these contacts responds to a motion of the object by a law of its own. On an edge of the cone a contact slides along or leaves
//! inwards; at the apex it has its whole law again. All other contacts keep their states. Each choice of states for those on an edge gives T and with
//! it the rate of the motion, to which they must respond in these states. Newton's method on the rates finds the choice. It starts from the usual
//! guess, which mostly holds and then costs one solve.
//!
//! Sliding contacts elsewhere are on an edge, too, but usually slide on (see `sliding_on`). They join the contacts decided here once their slip comes
//! to rest.

use nalgebra::SVector;

use super::active_set::FacetsReached;
use super::moving_contact::MovingContact;
use super::patch_event::PatchEvent;
use super::patch_path::{Due, Patch};
use crate::contact::{Mode, PolygonState, State, ZERO_SLACK};
use crate::load_path::event::{LossKind, PathEnd};
use crate::load_path::journey::Journey;
use crate::load_path::transition::change;
use crate::prelude::*;

/// Motions whose lengths differ by less than this part are equal up to rounding.
const LESS: f64 = 1e-9;
/// Newton's method takes a few steps or cycles.
const STEPS: usize = 24;
/// Largest growth of rounding accepted, relative to the rates: more could hide a contact that does move.
const MOST_ROUNDING: f64 = 1e-10;

impl<const C: usize> Patch<C> {
    /// Decides the continuation of the path from here, and queues the changes for report.
    pub(super) fn decide(&mut self, journey: &Journey<'_, C>, due: Due) -> Result<(), PathEnd<C>> {
        let decided = self.decide_among_stands(journey, due);
        if decided.is_ok() {
            self.take_over(journey);
        } else {
            // The path ends in the states in which it arrived.
            self.put_each(|_, stand| stand.was);
            self.balance.refactor();
            self.balance.settle_at(self.balance.tau);
        }
        decided
    }

    fn decide_among_stands(&mut self, journey: &Journey<'_, C>, due: Due) -> Result<(), PathEnd<C>> {
        for stand in &self.stands {
            self.balance.remember(stand.contact);
        }
        let found = if due == Due::Start {
            self.sliding.clear();
            // Either nothing changes, or all contacts on an edge stick at first.
            self.newton() || {
                self.put_each(|_, _| Mode::Sticking);
                self.newton()
            }
        } else {
            self.put_each(MovingContact::guess);
            self.newton()
        };
        if !found {
            self.ask_about_all(journey)?;
        }
        self.part_idle_contacts(journey)?;
        self.check_infinite_friction(journey)
    }

    /// Opens contacts that touch without force and gain none, so that they do not drag the object along. They open where the object then moves less;
    /// forces are the same.
    fn part_idle_contacts(&mut self, journey: &Journey<'_, C>) -> Result<(), PathEnd<C>> {
        let balance = &self.balance;
        let is_idle = |stand: &&FacetsReached<C>| {
            let contact = balance.contact(stand.contact);
            stand.apex
                && contact.fixed.gap
                && !contact.state.is_open()
                && balance.force_rate(contact).norm() <= ZERO_SLACK * balance.rate_level(contact)
        };
        let idle: Vec<u32> = self.stands.iter().filter(is_idle).map(|stand| stand.contact).collect();
        if idle.is_empty() {
            return Ok(());
        }
        let states: Vec<PolygonState> =
            self.stands.iter().map(|stand| balance.contact(stand.contact).state).collect();
        let moved = balance.twist_rate(&self.trial).norm();
        for contact in idle {
            self.balance.put(contact, Mode::Open);
        }
        if self.newton() && self.balance.twist_rate(&self.trial).norm() < moved * (1.0 - LESS) {
            return Ok(());
        }
        // Contacts that have joined meanwhile slide as before.
        for (k, stand) in self.stands.iter().enumerate() {
            self.balance.put(stand.contact, states.get(k).copied().unwrap_or(stand.was));
        }
        if self.balance.solve_rates(&self.trial) { Ok(()) } else { Err(self.undecided(journey)) }
    }

    fn put_each(&mut self, state: impl Fn(&MovingContact<C>, &FacetsReached<C>) -> PolygonState) {
        for stand in &self.stands {
            let state = state(self.balance.contact(stand.contact), stand);
            self.balance.put(stand.contact, state);
        }
    }

    /// Whether Newton's method finds states of the contacts on an edge that respond to their own rates.
    fn newton(&mut self) -> bool {
        for _ in 0..STEPS {
            if !self.balance.solve_rates(&self.trial) {
                return false;
            }
            let mut tolerance = ZERO_SLACK;
            let mut changed = false;
            for stand in &self.stands {
                self.balance.looked_at += 1;
                let contact = self.balance.contact(stand.contact);
                let (du, facets) = (self.balance.stretch_rate(contact), self.balance.facets(contact));
                let margin = contact.margin(stand, contact.state, &du, facets);
                let level = self.balance.rate_level(contact);
                if margin < -tolerance * level && margin >= -MOST_ROUNDING * level {
                    tolerance = (ZERO_SLACK * self.balance.growth()).min(MOST_ROUNDING);
                }
                if margin < -tolerance * level {
                    // The state also changes where no state responds without violation: changes of other contacts may help.
                    changed = true;
                    let answer = contact.answer(stand, &du, facets);
                    self.balance.put(stand.contact, answer);
                }
            }
            if !changed && !self.others_come_to_rest() {
                return true;
            }
        }
        false
    }

    /// Adds sliding contacts elsewhere that would slip backwards. Whether there are any.
    fn others_come_to_rest(&mut self) -> bool {
        let stands = &self.stands;
        let is_here = |contact| stands.iter().any(|stand| stand.contact == contact);
        let at_rest = self.sliding.come_to_rest(&mut self.balance, is_here);
        let any = !at_rest.is_empty();
        for contact in at_rest {
            self.join(contact);
        }
        any
    }

    /// Infinite friction keeps its tangential force until the normal force is gone, and then loses it at once.
    fn check_infinite_friction(&mut self, journey: &Journey<'_, C>) -> Result<(), PathEnd<C>> {
        for k in 0..self.stands.len() {
            let FacetsReached { contact, was, .. } = self.stands[k];
            let opens = self.balance.contact(contact).state.is_open() && !was.is_open();
            if !opens || !journey.grasp.sites()[contact as usize].friction.is_infinite() {
                continue;
            }
            // The contact sticks up to here.
            let motion = self.unit_motion();
            self.balance.put(contact, was);
            if self.balance.holds_along(contact) {
                return Err(PathEnd::Lost(Box::new(self.loss(journey, LossKind::LetsGo, motion.as_ref()))));
            }
            self.balance.put(contact, Mode::Open);
        }
        Ok(())
    }

    /// Queues the changes for report, and queues the contacts decided here for their bounds again.
    fn take_over(&mut self, journey: &Journey<'_, C>) {
        let load = journey.program.load_at(self.balance.tau);
        self.told.clear();
        for stand in &self.stands {
            let number = stand.contact as usize;
            let is = self.balance.contacts[number].state;
            let before = (State::from(stand.was), outward(journey, number, stand.was));
            let after = (State::from(is), self.slip_direction(journey, number));
            if let Some(change) = change(before, after) {
                let (leg, fraction) = (journey.program.leg, self.balance.tau);
                self.told.push(PatchEvent { leg, fraction, load, contact: number, change });
            }
            if is.is_open() {
                // Slip counts from where the contact closes.
                self.balance.contacts[number].memory = stand.memory;
            }
            self.ahead.call_back(&mut self.balance, stand.contact);
            if is.slides() {
                self.sliding.wait(&self.balance, stand.contact);
            }
        }
        self.told.sort_unstable_by_key(|event| core::cmp::Reverse(event.contact));
    }

    /// The direction in which a sliding contact slips from here on, coordinate axes; where the slip rate is zero, the direction in which it would
    /// start.
    fn slip_direction(&self, journey: &Journey<'_, C>, contact: usize) -> Option<SVector<f64, C>> {
        let (moving, site) = (&self.balance.contacts[contact], &journey.grasp.sites()[contact]);
        let outward = outward(journey, contact, moving.state)?;
        let mut slip = self.balance.stretch_rate(moving) - self.balance.force_rate(moving);
        slip[0] = 0.0;
        for axis in 1..C {
            slip[axis] /= site.springs.root_along(axis);
        }
        let along = site.frame * slip;
        Some(if slip.norm() > 0.0 && along.dot(&outward) > 0.0 { along.normalize() } else { outward })
    }
}

/// The middle of the possible slip directions of a sliding contact, coordinate axes.
fn outward<const C: usize>(
    journey: &Journey<'_, C>,
    contact: usize,
    state: PolygonState,
) -> Option<SVector<f64, C>> {
    let normals = &journey.polygon.normals;
    let [first, second] = state.own_facets(normals.len());
    let outward = normals[first?] + second.map_or_else(SVector::zeros, |second| normals[second]);
    Some(journey.grasp.sites()[contact].frame * outward.normalize())
}
