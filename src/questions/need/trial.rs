//! The result of trying one amount: whether it meets the demand, and by how much it does or does not.

use super::question::Demand;
use crate::hold::AtRest;
use crate::prelude::*;

/// Stands for the carried part if the load at rest has no equilibrium at all. It is below 0, which means that only the load at rest is carried.
pub(super) const NOT_AT_REST: f64 = -1.0;

/// The result of trying an amount.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Trial {
    Does {
        /// The multiple of the load that the amount carries, at least 1; infinite if no loss was found.
        carried: f64,
        /// A second margin: for holding that of small motions, for sticking that of friction at rest. Infinite if it is not known.
        other: f64,
    },
    DoesNot {
        /// The verdict in a sentence.
        says: String,
        /// The fraction of the load that is carried; below 0 where the load at rest is not carried in full.
        carried: f64,
        /// The second margin, as for a sufficient amount. At a bound where the carried part jumps, it may still fall below 0 continuously.
        other: f64,
        /// Whether the object is held, but moves farther than small motions.
        is_too_far: bool,
    },
    /// Undecided, with the reason in a sentence.
    Unknown(String),
}

impl Trial {
    /// An amount that does not suffice and carries nothing of the load.
    pub(super) fn nothing(says: impl Into<String>) -> Self {
        Self::does_not(says, 0.0)
    }

    /// An amount that does not suffice and carries this part of the load.
    pub(super) fn does_not(says: impl Into<String>, carried: f64) -> Self {
        Self::DoesNot { says: says.into(), carried, other: f64::INFINITY, is_too_far: false }
    }

    /// An amount that suffices and carries this multiple of the load.
    pub(super) const fn carries(carried: f64) -> Self {
        Self::Does { carried, other: f64::INFINITY }
    }

    /// An amount that suffices however large the load is.
    pub(super) const fn always() -> Self {
        Self::carries(f64::INFINITY)
    }

    pub(super) fn does(&self) -> bool {
        matches!(self, Self::Does { .. })
    }

    /// Whether only the enumeration of contact states could tell if anything rests: the trial is undecided, or the load at rest is lost on a path
    /// from zero.
    pub(super) fn needs_enumeration(&self) -> bool {
        self.carried().is_none_or(|carried| carried > NOT_AT_REST && carried < 0.0)
    }

    /// The carried multiple of the load; `None` where the trial is undecided.
    pub(super) fn carried(&self) -> Option<f64> {
        match self {
            Self::Does { carried, .. } | Self::DoesNot { carried, .. } => Some(*carried),
            Self::Unknown(_) => None,
        }
    }

    /// Two measures of the distance from a bound: the carried part less 1, and the second margin. Each vanishes at the bound unless it jumps there.
    /// `None` if it is not known.
    pub(super) fn measures(&self) -> [Option<f64>; 2] {
        match self {
            Self::Does { carried, other } | Self::DoesNot { carried, other, .. } => {
                [carried - 1.0, *other].map(|measure| Some(measure).filter(|measure| measure.is_finite()))
            }
            Self::Unknown(_) => [None; 2],
        }
    }

    fn other(&self) -> f64 {
        self.measures()[1].unwrap_or(f64::INFINITY)
    }

    /// The worse of two results: an amount that does not suffice is worse than an undecided one, that worse than a sufficient one. Among equals the
    /// one that carries less is worse.
    pub(super) fn or_worse(self, other: Self) -> Self {
        let rank = |trial: &Self| match trial {
            Self::DoesNot { .. } => 0,
            Self::Unknown(_) => 1,
            Self::Does { .. } => 2,
        };
        let order = rank(&self).cmp(&rank(&other));
        let by_load = || self.carried().unwrap_or(0.0).total_cmp(&other.carried().unwrap_or(0.0));
        let least = self.other().min(other.other());
        let mut worse = if order.then_with(by_load).is_le() { self } else { other };
        if let Self::Does { other, .. } | Self::DoesNot { other, .. } = &mut worse {
            *other = least;
        }
        worse
    }
}

/// The results of one amount for both demands: whether the loads are held, and whether nothing slides. `None` where that was not tried.
#[derive(Debug, Clone, Default)]
pub(super) struct Trials {
    pub(super) held: Option<Trial>,
    pub(super) sticks: Option<Trial>,
    /// `None` where nothing rests or it is not known.
    pub(super) at_rest: Option<AtRest>,
}

impl Trials {
    pub(super) fn of(&self, demand: Demand) -> Option<&Trial> {
        if demand == Demand::Sticks { self.sticks.as_ref() } else { self.held.as_ref() }
    }

    pub(super) fn only(demand: Demand, trial: Trial) -> Self {
        let (held, sticks) = if demand == Demand::Sticks { (None, Some(trial)) } else { (Some(trial), None) };
        Self { held, sticks, at_rest: None }
    }
}
