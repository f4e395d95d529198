//! The onset, i.e. the load factor or angle at which the first contact stops sticking as a load grows or turns, as an answer for the caller. The
//! offset of a contact's springs is the command of its finger (a displacement) minus clearance and accumulated slip. A ramp is a load or a command
//! that grows in proportion to a load factor. A drive, the spring of a joint or tendon of a hand with its force limit, is treated like a contact. The
//! active set of a contact consists of the facets of its friction cone that its force has reached. On the round cone the tangent plane at the force
//! takes the place of a facet.

use crate::numerics::add_times;
use nalgebra::{SMatrix, SVector};

use super::drive_change::PartChange;
use super::segment::Segment;
use crate::contact::{ActiveSet, LocalLaw};
use crate::equilibrium::{Cone, Equilibrium, NoEquilibrium, Undecided};
use crate::error::ContactLabel;
use crate::grasp::{Coordinates, Wrench};
use crate::prelude::*;
use crate::search::{FoundBy, SearchSolution, StoredSolution};
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// The onset: the load factor τ >= 0 at which the first contact stops sticking, or the angle if the load turns.
///
/// For a [`Turn`](super::Turn) every factor here is the angle in rad, and factor 0 is the beginning of the turn.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum Onset<const C: usize> {
    /// The first contact stops sticking at the load factor of this event.
    At(Box<OnsetEvent<C>>),
    /// Everything keeps sticking at every load factor; for a turn, at every angle up to the last angle.
    Never,
    /// A contact slides already at load factor 0, in this equilibrium. (A contact on the boundary of its cone still sticks, and may begin to slide at
    /// load factor 0.)
    AlreadySliding(Box<Equilibrium<C>>),
    /// No equilibrium exists at load factor 0.
    NoBase(NoEquilibrium<C>),
    /// No contact stops sticking, but from this load factor on nothing resists the load.
    GivesWay {
        /// The load factor up to which the grasp holds.
        factor: f64,
        /// The reason why no equilibrium exists beyond this load factor. A work stated in the reason is done by the rate of the load, J per unit of
        /// the load factor (J/rad for a turn).
        reason: NoEquilibrium<C>,
    },
    /// The search for the equilibrium at load factor 0 was undecided, or the path to the onset depends on rounding.
    Undecided(Undecided),
}

impl<const C: usize> Onset<C> {
    /// The onset, if a contact stops sticking.
    #[must_use]
    pub fn event(&self) -> Option<&OnsetEvent<C>> {
        match self {
            Self::At(event) => Some(event),
            _ => None,
        }
    }

    /// The load factor up to which all contacts that touch stick. It is the load factor of the event, or the load factor from which nothing resists
    /// the load. Infinite for [`Self::Never`]. `None` without a sticking equilibrium to start from, or if the answer is undecided.
    #[must_use]
    pub fn factor(&self) -> Option<f64> {
        match self {
            Self::At(event) => Some(event.factor),
            Self::Never => Some(f64::INFINITY),
            Self::GivesWay { factor, .. } => Some(*factor),
            _ => None,
        }
    }
}

/// The event at which the first contact stops sticking. The equilibrium there is computed on request
/// ([`Grasp::state_at_onset`](crate::ask::Grasp::state_at_onset)), and so is the continuation ([`Grasp::beyond`](crate::ask::Grasp::beyond)).
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct OnsetEvent<const C: usize> {
    /// Load factor τ of a ramp, or the angle of a turn in rad, exact up to rounding.
    pub factor: f64,
    /// The load at the onset.
    pub load: Wrench<C>,
    /// The contacts that stop sticking, all at this load factor. Contacts that have closed before and stick are not among them.
    pub leaving: Vec<DepartingContact<C>>,
    /// Changes of a hand's drives at the onset: joints and tendons whose drives yield at their greatest torque or force, and tendons that slacken.
    pub drives: Vec<PartChange>,
    /// The friction cone for which the event was computed.
    pub cone: Cone,
    /// The engine's equilibrium at the onset. The caller's equilibrium and its continuation are computed from it on request.
    pub(super) local: StickingState,
}

/// The equilibrium at an onset, in which everything that touches sticks and some contacts are on the boundary of their cones. The rates of the load
/// and of the offsets of the contacts' springs are per unit of the load factor. Moments are about the centroid of the contacts.
#[derive(Debug, Clone)]
pub(super) struct StickingState {
    pub(super) found: StoredSolution,
    pub(super) rule: FoundBy,
    /// For each contact or drive its active set. An empty set means that its force lies inside its cone, or that it is open with a positive gap.
    pub(super) active_sets: Vec<ActiveSet>,
    /// Indices of the contacts and drives that stop sticking.
    pub(super) leaving: Vec<usize>,
    pub(super) wrench: Coordinates,
    pub(super) wrench_rate: Coordinates,
    pub(super) offsets: Vec<SVector<f64, 3>>,
    pub(super) offset_rates: Vec<SVector<f64, 3>>,
    /// For each contact its slip up to the onset, m. It is nonzero only for contacts that were open at load factor 0 and have closed since.
    pub(super) slips: Vec<SVector<f64, 3>>,
}

impl OnsetEvent<3> {
    /// The onset at the load factor `factor`, made from the caller's load and the solution `found` at this load factor. `leaving` and `sites` are the
    /// contacts and drives that stop sticking. `lists` are emptied lists whose storage is used again.
    pub(super) fn new(
        segment: Segment<'_>,
        (factor, load): (f64, Wrench<3>),
        (leaving, sites): (Vec<DepartingContact<3>>, Vec<usize>),
        active_sets: Vec<ActiveSet>,
        (found, rule): (SearchSolution, FoundBy),
        lists: &mut [Vec<f64>; 3],
    ) -> Self {
        let mut lists = lists.iter_mut();
        let mut list = || lists.next().map(core::mem::take).unwrap_or_default();
        let Segment { grasp, answer_for, problem, change: offset_rates, trajectory, .. } = segment;
        let mut offsets = problem.offsets;
        add_times(&mut offsets, &offset_rates, factor);
        let local = StickingState {
            found: StoredSolution::of(found, list()),
            rule,
            active_sets,
            leaving: sites,
            wrench: Coordinates::of_in(&trajectory.at(factor), list()),
            wrench_rate: Coordinates::of_in(&trajectory.rate_at(factor), list()),
            offsets,
            offset_rates,
            slips: problem.slips,
        };
        let (leaving, drives) = grasp.leaving_apart(leaving);
        Self { factor, load, leaving, drives, cone: answer_for.cone, local }
    }
}

impl DepartingContact<3> {
    /// The contact or drive with the index `site`, which stops sticking in the way `how`; its label has only this index, and its name is filled in
    /// later.
    pub(super) fn new(site: usize, how: Departure<3>) -> Self {
        Self { contact: ContactLabel { index: site, point: None, name: None, link: None }, how }
    }

    /// The contact or drive with the index `site`, whose way to stop sticking follows from its active set: the contact slides along the sum of the
    /// outward normals of the facets that its force has reached. At the apex (zero force) it opens, or would have to pull if it is kept closed. Used
    /// if no continuation determines the direction of its slip.
    pub(super) fn driven_out(
        site: usize,
        active: &ActiveSet,
        local: &LocalLaw<'_>,
        frame: &SMatrix<f64, 3, 3>,
    ) -> Self {
        let outward = active.facets.iter().fold(SVector::<f64, 3>::zeros(), |sum, h| sum + h);
        let how = if outward.norm() > 0.0 {
            Departure::Slides { direction: frame * outward.normalize() }
        } else if local.may_open() {
            Departure::Opens
        } else {
            Departure::WouldPull
        };
        Self::new(site, how)
    }
}

/// A contact that stops sticking.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct DepartingContact<const C: usize> {
    /// The contact that stops sticking.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub contact: ContactLabel,
    /// The way in which the contact stops sticking.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub how: Departure<C>,
}

/// The way in which a contact stops sticking.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "how", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Departure<const C: usize> {
    /// The contact slides, `|F_t| = μ F_n`.
    Slides {
        /// Unit direction, along the coordinate axes, in which the finger slips over the body; friction pulls the body in this direction.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        direction: SVector<f64, C>,
    },
    /// The contact opens, F_n = 0.
    Opens,
    /// The contact is kept closed, and its normal force has fallen to F_n = 0. If it stayed closed beyond the onset, it would have to pull, and while
    /// it pulls it cannot have a friction force.
    WouldPull,
}
