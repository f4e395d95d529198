//! The follower of thousands of contacts: where it stands, and what ends its path there.

use nalgebra::SVector;

use super::balance::Balance;
use super::bounds_ahead::BoundsAhead;
use super::patch_event::PatchEvent;
use super::sliding_on::SlidingOn;
use super::stand::Stand;
use super::trial_leg::TrialLeg;
use crate::grasp::Twist;
use crate::load_path::event::{Loss, LossKind, PathEnd};
use crate::load_path::journey::Journey;
use crate::load_path::path::Path;
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

/// A load program being followed for many contacts: an iterator over its [`PatchEvent`]s, one
/// contact at a time. Made by
/// [`Grasp::follow_patch`](crate::grasp::Grasp::follow_patch); when the iterator has ended,
/// [`end`](Self::end) says how the path did.
///
/// The law is that of [`LoadPath`](crate::load_path::LoadPath), with slip memory, in space **on the
/// polygonal cone**; legs are the same. Between events [`state`](Self::state) tells the equilibrium
/// where the path stands, [`next_before`](Self::next_before) stops anywhere on the way. It does not
/// say whether the continuation is unique, and keeps neither the pieces behind it nor energies. An event allocates nothing.
///
/// ```
/// use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};
///
/// // A pad of a thousand springs under a rigid block, pressed most in the middle, dragged and let go.
/// let n = 1000;
/// let xi = |i: usize| (2 * i + 1) as f64 / n as f64 - 1.0;
/// let spring = |i: usize| {
///     let press = 1.0 - xi(i) * xi(i);
///     Contact::new([xi(i), 0.0], [0.0, 1.0]).series_stiffness(1.0, 0.8).friction(0.3).command([press, 0.0])
/// };
/// let grasp = Grasp::new((0..n).map(spring))?;
/// let pressed: f64 = (0..n).map(|i| 1.0 - xi(i) * xi(i)).sum();
/// let pull = |part: f64| Wrench::new([part * 0.3 * pressed, -pressed], 0.0);
///
/// let mut path = grasp.follow_patch(&pull(0.0), &[Leg::load_to(pull(0.5)), Leg::load_to(pull(0.0))])?;
/// let events: Vec<_> = path.by_ref().collect();
/// assert!(matches!(path.end(), Some(grasp_lcp::load_path::PathEnd::Completed)));
/// // The rim slides on the way there and stays displaced: letting go is not the way back.
/// assert!(events.len() > 300);
/// assert!(path.state().unwrap().twist.translation()[0] > 0.0);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
pub type PatchPath<'g, const D: usize, const C: usize> = Path<'g, D, C, Patch<D, C>>;

/// The follower of a [`PatchPath`].
#[derive(Debug)]
pub struct Patch<const D: usize, const C: usize> {
    pub(super) trial: TrialLeg<D, C>,
    pub(super) balance: Balance<D, C>,
    pub(super) ahead: BoundsAhead<D>,
    pub(super) sliding: SlidingOn<D>,
    /// The contacts that stand on an edge at the present event.
    pub(super) stands: Vec<Stand<C>>,
    pub(super) due: Due,
    /// Whether the trial state is that of the present leg already: of the first one.
    pub(super) is_laid: bool,
    /// Steps of no length in a row.
    pub(super) stalls: usize,
    /// Events that have happened and were not told yet, the next one last.
    pub(super) told: Vec<PatchEvent<D, C>>,
}

impl<const D: usize, const C: usize> PatchPath<'_, D, C> {
    /// How often a contact has been looked at so far: a measure of the work that does not depend on
    /// the machine.
    #[must_use]
    pub fn contacts_looked_at(&self) -> usize {
        self.follower.as_ref().map_or(0, |patch| patch.balance.looked_at)
    }
}

impl<const D: usize, const C: usize> Patch<D, C> {
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
        motion: Option<Twist<D, C>>,
    ) -> Loss<D, C> {
        let mut contacts: Vec<usize> = self.stands.iter().map(|stand| stand.contact as usize).collect();
        let all = &self.balance.contacts;
        contacts.extend((0..all.len()).filter(|&i| all[i].state.slides()));
        contacts.sort_unstable();
        contacts.dedup();
        journey.loss(self.balance.tau, kind, contacts, motion)
    }

    /// Where rounding keeps the path from being followed further.
    pub(super) fn undecided(&self, journey: &Journey<'_, D, C>) -> PathEnd<D, C> {
        journey.undecided(self.balance.tau, Doubt::OnTheBoundary)
    }

    /// The unit motion in which the object goes on, if it moves, in inside coordinates.
    pub(super) fn unit_motion(&self) -> Option<SVector<f64, D>> {
        let rate = self.balance.twist_rate(&self.trial);
        (rate.norm() > 0.0).then(|| rate.normalize())
    }
}
