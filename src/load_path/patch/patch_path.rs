//! The follower of thousands of contacts: its state, and the end of its path.

use super::active_set::FacetsReached;
use super::balance::Balance;
use super::bounds_ahead::BoundsAhead;
use super::patch_event::PatchEvent;
use super::sliding_on::SlidingOn;
use super::trial_leg::TrialLeg;
use crate::load_path::event::{Loss, LossKind, PathEnd};
use crate::load_path::journey::Journey;
use crate::numerics::Vector;
use crate::prelude::*;
use crate::search::Doubt;

/// The decision needed before the path continues.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Due {
    #[default]
    Nothing,
    /// The beginning of a leg.
    Start,
    /// The continuation after an event.
    Event,
}

/// The follower of a [`PatchPath`](crate::load_path::PatchPath).
#[derive(Debug)]
pub(crate) struct Patch<const C: usize> {
    pub(super) trial: TrialLeg<C>,
    pub(super) balance: Balance<C>,
    pub(super) ahead: BoundsAhead,
    pub(super) sliding: SlidingOn,
    /// The contacts on an edge at the present event.
    pub(super) stands: Vec<FacetsReached<C>>,
    pub(super) due: Due,
    /// Whether the trial state already belongs to the present leg, the first one.
    pub(super) is_laid: bool,
    /// Number of successive steps of zero length.
    pub(super) stalls: usize,
    /// Events still to be reported, the next one last.
    pub(super) told: Vec<PatchEvent<C>>,
}

impl<const C: usize> Patch<C> {
    /// Adds a sliding contact, or one on an edge, to the contacts decided here.
    pub(super) fn join(&mut self, contact: u32) {
        self.stands.push(self.balance.stand_of(contact));
        self.balance.remember(contact);
    }

    /// Whether a contact is among the contacts decided here.
    pub(super) fn stands_here(&self, contact: u32) -> bool {
        self.stands.iter().any(|stand| stand.contact == contact)
    }

    /// The loss of equilibrium here; the object leaves with this motion.
    pub(super) fn loss(&self, journey: &Journey<'_, C>, kind: LossKind, motion: Option<&Vector>) -> Loss<C> {
        let mut contacts: Vec<usize> = self.stands.iter().map(|stand| stand.contact as usize).collect();
        let all = &self.balance.contacts;
        contacts.extend((0..all.len()).filter(|&i| all[i].state.slides()));
        contacts.sort_unstable();
        contacts.dedup();
        journey.loss(self.balance.tau, kind, contacts, motion)
    }

    /// The end of a path that rounding keeps from being followed further.
    pub(super) fn undecided(&self, journey: &Journey<'_, C>) -> PathEnd<C> {
        journey.undecided(self.balance.tau, Doubt::OnTheBoundary)
    }

    /// The unit motion of the object, if it moves, in inside coordinates.
    pub(super) fn unit_motion(&self) -> Option<Vector> {
        let rate = self.balance.twist_rate(&self.trial);
        (rate.norm() > 0.0).then(|| rate.normalize())
    }
}
