//! The follower of thousands of contacts: where it stands, and what ends its path there.

use super::active_set::FacetsReached;
use super::balance::Balance;
use super::bounds_ahead::BoundsAhead;
use super::patch_event::PatchEvent;
use super::sliding_on::SlidingOn;
use super::trial_leg::TrialLeg;
use crate::load_path::event::{Loss, LossKind, PathEnd};
use crate::load_path::journey::Journey;
use crate::numerics::{Size, Vector};
use crate::prelude::*;
use crate::search::Doubt;

/// What has to be decided before the path goes on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Due {
    #[default]
    Nothing,
    /// How a leg begins.
    Start,
    /// How the path goes on from an event.
    Event,
}

/// The follower of a [`PatchPath`](crate::load_path::PatchPath).
#[derive(Debug)]
pub(crate) struct Patch<D: Size, const C: usize> {
    pub(super) trial: TrialLeg<D, C>,
    pub(super) balance: Balance<D, C>,
    pub(super) ahead: BoundsAhead<D>,
    pub(super) sliding: SlidingOn<D>,
    /// The contacts that stand on an edge at the present event.
    pub(super) stands: Vec<FacetsReached<C>>,
    pub(super) due: Due,
    /// Whether the trial state is that of the present leg already: of the first one.
    pub(super) is_laid: bool,
    /// Steps of no length in a row.
    pub(super) stalls: usize,
    /// Events that have happened and were not told yet, the next one last.
    pub(super) told: Vec<PatchEvent<C>>,
}

impl<D: Size, const C: usize> Patch<D, C> {
    /// A contact that slides or stands elsewhere joins those that stand here.
    pub(super) fn join(&mut self, contact: u32) {
        self.stands.push(self.balance.stand_of(contact));
        self.balance.remember(contact);
    }

    /// Whether a contact is among those that stand here.
    pub(super) fn stands_here(&self, contact: u32) -> bool {
        self.stands.iter().any(|stand| stand.contact == contact)
    }

    /// Equilibrium is lost here, the object leaving with this motion.
    pub(super) fn loss(
        &self,
        journey: &Journey<'_, D, C>,
        kind: LossKind,
        motion: Option<&Vector<D>>,
    ) -> Loss<C> {
        let mut contacts: Vec<usize> = self.stands.iter().map(|stand| stand.contact as usize).collect();
        let all = &self.balance.contacts;
        contacts.extend((0..all.len()).filter(|&i| all[i].state.slides()));
        contacts.sort_unstable();
        contacts.dedup();
        journey.loss(self.balance.tau, kind, contacts, motion)
    }

    /// Where rounding keeps the path from being followed further.
    pub(super) fn undecided(&self, journey: &Journey<'_, D, C>) -> PathEnd<C> {
        journey.undecided(self.balance.tau, Doubt::OnTheBoundary)
    }

    /// The unit motion in which the object goes on, if it moves, in inside coordinates.
    pub(super) fn unit_motion(&self) -> Option<Vector<D>> {
        let rate = self.balance.twist_rate(&self.trial);
        (rate.norm() > 0.0).then(|| rate.normalize())
    }
}
