//! The trial of one amount (of squeeze, friction, load, arm or angle): whether the grasp meets the demand with it, and the distance to the bound, the
//! least or greatest sufficient amount. At rest means under the loads that act before the loads of the question. The carried part of the load is the
//! load factor up to which the demand is met with an amount. The verdict is sufficient, insufficient or undecided. In a jump the object moves
//! suddenly under constant load. Motions are small within the limits up to which the linear theory is trusted.

use core::cell::{Cell, RefCell};

use super::question::Demand;
use crate::hold::AtRest;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Each, dot};
use crate::prelude::*;

/// The value of the carried part of the load if no equilibrium exists under the load at rest. Any negative carried part means that not even the load
/// at rest is carried in full.
pub(super) const NOT_AT_REST: f64 = -1.0;

/// In the list of directions in which a force was not carried, a new direction replaces the directions within this angle of it, rad. With a smaller
/// angle the list fills with directions near one minimum of the carried load; with a larger one a second minimum is forgotten.
const SAME_DIRECTION: f64 = 5e-3;

/// The result of the trial of an amount: it is sufficient, insufficient, or this is undecided.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Trial {
    Sufficient {
        /// The multiple of the load that is carried with the amount, at least 1; infinite if no loss was found.
        carried: f64,
        /// The second margin; the first margin is the carried part of the load less 1. If the loads need only be held ([`Demand::Held`]), it is 1
        /// less the largest ratio of a motion to its limit of small motions. If nothing may slide ([`Demand::Sticks`]), it tells how far contacts are
        /// from sliding or opening at rest. It is then the least distance of a contact force from the boundary of its friction cone or from zero
        /// normal force, divided by the largest contact force. Infinite if it is not known.
        other: f64,
    },
    Insufficient {
        /// The reason why the amount is insufficient: the verdict on the grasp, in a sentence.
        says: String,
        /// The fraction of the load that is carried with the amount; below 0 if the load at rest is not carried in full.
        carried: f64,
        /// The second margin. For [`Demand::Held`] it is 1 less the largest ratio of a motion to its limit of small motions. For [`Demand::Sticks`]
        /// it is the distance, at rest, of a contact force from the boundary of its friction cone or from zero normal force, divided by the largest
        /// contact force. If the carried part jumps at the bound, this margin may still decrease below 0 continuously. Infinite if it is not known.
        other: f64,
        /// True if the object is held, but some motion exceeds its limit of small motions.
        is_too_far: bool,
    },
    /// It is undecided whether the amount is sufficient. The text is the reason, in a sentence.
    Unknown(String),
}

impl Trial {
    /// The result for an insufficient amount with which nothing of the load is carried.
    pub(super) fn nothing(says: impl Into<String>) -> Self {
        Self::insufficient(says, 0.0)
    }

    /// The result for an insufficient amount with which this part of the load is carried.
    pub(super) fn insufficient(says: impl Into<String>, carried: f64) -> Self {
        Self::Insufficient { says: says.into(), carried, other: f64::INFINITY, is_too_far: false }
    }

    /// The result for a sufficient amount with which this multiple of the load is carried.
    pub(super) const fn carries(carried: f64) -> Self {
        Self::Sufficient { carried, other: f64::INFINITY }
    }

    /// The result for an amount that is sufficient however large the load is.
    pub(super) const fn always() -> Self {
        Self::carries(f64::INFINITY)
    }

    pub(super) fn is_sufficient(&self) -> bool {
        matches!(self, Self::Sufficient { .. })
    }

    /// Whether only the enumeration of contact states can decide if an equilibrium at rest exists. This is so if the trial is undecided, or if a load
    /// path from zero loses the object before the load at rest is reached.
    pub(super) fn needs_enumeration(&self) -> bool {
        self.carried().is_none_or(|carried| carried > NOT_AT_REST && carried < 0.0)
    }

    /// The carried multiple of the load; `None` if the trial is undecided.
    pub(super) fn carried(&self) -> Option<f64> {
        match self {
            Self::Sufficient { carried, .. } | Self::Insufficient { carried, .. } => Some(*carried),
            Self::Unknown(_) => None,
        }
    }

    /// A number by which insufficient amounts are compared: the carried multiple of the load. If the object moves too far already at rest, the number
    /// is between -1 and 0; it grows as the motions come closer to their limits.
    pub(super) fn nearness(&self) -> Option<f64> {
        match self {
            Self::Insufficient { carried, other, is_too_far: true, .. }
                if *carried <= 0.0 && *other < 0.0 =>
            {
                Some(other / (1.0 - other))
            }
            _ => self.carried(),
        }
    }

    /// The distance from another verdict, at most 1. Of a sufficient amount it is the smaller measure, of an insufficient amount the part of the load
    /// that is not carried. `None` if the trial is undecided.
    pub(super) fn margin(&self) -> Option<f64> {
        let margin = match self {
            Self::Sufficient { carried, other } => (carried - 1.0).min(*other),
            _ => 1.0 - self.nearness()?,
        };
        Some(margin.clamp(NEGLIGIBLE, 1.0))
    }

    /// Two measures of the distance from the bound of the sufficient amounts: the carried part of the load less 1, and the second margin. Each
    /// measure is zero at the bound, unless it jumps at the bound. `None` for a measure that is not known.
    pub(super) fn measures(&self) -> [Option<f64>; 2] {
        match self {
            Self::Sufficient { carried, other } | Self::Insufficient { carried, other, .. } => {
                [carried - 1.0, *other].each(|measure| Some(measure).filter(|measure| measure.is_finite()))
            }
            Self::Unknown(_) => [None; 2],
        }
    }

    fn other(&self) -> f64 {
        self.measures()[1].unwrap_or(f64::INFINITY)
    }

    /// The worse of two results: insufficient is worse than undecided, and undecided worse than sufficient. Of two results of the same kind, the one
    /// with the smaller carried part of the load is worse.
    pub(super) fn or_worse(self, other: Self) -> Self {
        let rank = |trial: &Self| match trial {
            Self::Insufficient { .. } => 0,
            Self::Unknown(_) => 1,
            Self::Sufficient { .. } => 2,
        };
        let order = rank(&self).cmp(&rank(&other));
        let by_load = || self.carried().unwrap_or(0.0).total_cmp(&other.carried().unwrap_or(0.0));
        let least = self.other().min(other.other());
        let mut worse = if order.then_with(by_load).is_le() { self } else { other };
        if let Self::Sufficient { other, .. } | Self::Insufficient { other, .. } = &mut worse {
            *other = least;
        }
        worse
    }
}

/// The results of trials of one amount for two demands: whether the loads are held, and whether nothing slides. `None` for a demand that was not
/// tried.
#[derive(Debug, Clone, Default)]
pub(super) struct Trials {
    pub(super) held: Option<Trial>,
    pub(super) sticks: Option<Trial>,
    /// The contact states at rest; `None` if no equilibrium at rest exists or is known.
    pub(super) at_rest: Option<AtRest>,
    /// Whether a motion proves that no forces of the contacts balance the load at rest.
    pub(super) is_unbalanced: bool,
    /// Whether the object jumps while a load is put on: it slips under constant load until a contact catches it, or snaps over.
    pub(super) jumps: bool,
}

impl Trials {
    pub(super) fn of(&self, demand: Demand) -> Option<&Trial> {
        if demand == Demand::Sticks { self.sticks.as_ref() } else { self.held.as_ref() }
    }

    pub(super) fn only(demand: Demand, trial: Trial) -> Self {
        let (held, sticks) = if demand == Demand::Sticks { (None, Some(trial)) } else { (Some(trial), None) };
        Self { held, sticks, ..Self::default() }
    }
}

/// The loads that refuted earlier amounts, i.e. were not carried with them. As a rule the same load refutes the next amount, so it is applied first.
#[derive(Debug, Default)]
pub(super) struct RefutingLoads {
    /// Index, from 0, of the load that was not carried with the last insufficient amount, or was carried least with the last sufficient amount.
    pub(super) first: Cell<usize>,
    /// For a question about a force of any direction: the directions in which the force was not carried with some amount, or was carried least. Quick
    /// trials, which do not enumerate contact states, are confined to these directions.
    pub(super) directions: RefCell<Vec<[f64; 3]>>,
}

impl RefutingLoads {
    /// Puts a direction first in the list, in place of all directions within the angle [`SAME_DIRECTION`] of it. The list keeps the last six
    /// directions, so that their trials take a small part of the time of all directions.
    pub(super) fn add(&self, direction: [f64; 3]) {
        let mut list = self.directions.borrow_mut();
        list.retain(|other| dot(other, &direction) < SAME_DIRECTION.cos());
        list.insert(0, direction);
        list.truncate(6);
    }
}
