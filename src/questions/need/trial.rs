//! The result of trying one amount: whether it meets the demand, and by how much it does or does not.

use super::question::Demand;
use crate::hold::RestingContact;
use crate::prelude::*;

/// The carried part where the load at rest has no equilibrium at all. It has to lie below 0, the part where only the load at rest is carried.
pub(super) const NOT_AT_REST: f64 = -1.0;

/// The result of a trial.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Trial {
    Does {
        /// The multiple of the load that is carried, at least 1; infinite where no loss was found.
        carried: f64,
        /// A second margin: for holding that of small motions, for sticking that of friction at rest; infinite where it is not known.
        other: f64,
    },
    DoesNot {
        /// The sentence of the verdict.
        says: String,
        /// The fraction of the load that is carried; below 0 where the load at rest is not carried in full.
        carried: f64,
        /// The second margin of an amount that does not suffice: it falls below 0 continuously at a bound where the carried part jumps.
        other: f64,
        /// Whether the object is held, but moves farther than small motions.
        is_too_far: bool,
    },
    /// Undecided, with the reason in a sentence.
    Unknown(String),
}

impl Trial {
    /// A refutation where nothing of the load is carried.
    pub(super) fn nothing(says: impl Into<String>) -> Self {
        Self::does_not(says, 0.0)
    }

    /// A refutation with this carried part.
    pub(super) fn does_not(says: impl Into<String>, carried: f64) -> Self {
        Self::DoesNot { says: says.into(), carried, other: f64::INFINITY, is_too_far: false }
    }

    /// A sufficient amount with this carried part.
    pub(super) const fn carries(carried: f64) -> Self {
        Self::Does { carried, other: f64::INFINITY }
    }

    /// A sufficient amount, however large the load.
    pub(super) const fn always() -> Self {
        Self::carries(f64::INFINITY)
    }

    pub(super) fn does(&self) -> bool {
        matches!(self, Self::Does { .. })
    }

    /// Whether a quick trial leaves open whether anything rests: it is undecided, or only the path of the load at rest from zero is lost.
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

    /// The carried part less 1, and the other margin: both vanish at a bound where they do not jump. `None` where a measure is not known.
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

    /// The worse of two trials: a refutation before an undecided one before a sufficient one, and among equals the smaller carried part.
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

/// The trials of one amount by demand: whether the loads are held, and whether nothing slides. `None` where not tried.
#[derive(Debug, Clone, Default)]
pub(super) struct Trials {
    pub(super) held: Option<Trial>,
    pub(super) sticks: Option<Trial>,
    /// The contacts at rest; `None` where nothing rests or they are not known.
    pub(super) at_rest: Option<Vec<RestingContact>>,
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
