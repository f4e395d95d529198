//! What slips tell.

use super::combination::FreeCombination;
use super::unknown::UnknownKind;
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;
use crate::sweep::Uncertainty;

/// What slips that were seen tell of a grasp; its [`Display`](std::fmt::Display) says it in a sentence.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Identified {
    /// The unknowns, in the order in which they were asked for.
    pub estimates: Vec<Estimate>,
    /// How the search ended.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub ending: Ending,
    /// How many slips there were.
    pub slips: usize,
    /// How many groups of slips there were that may share errors; `None` where each slip stands for itself.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub groups: Option<usize>,
    /// The scatter of loads or angles as a part of them, estimated; `None` where it was given, or where there are as many unknowns as slips.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub scatter: Option<f64>,
    /// Where the scatter was given: how many times as far off slips are. Much more than one: the model is wrong, or the scatter was.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub misfit: Option<f64>,
    /// Slips, and what is known besides, less what they fix.
    pub degrees_of_freedom: usize,
    /// Combinations that slips do not fix.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub free: Vec<FreeCombination>,
    /// Logarithm of what was seen over what is predicted, slip by slip; empty where some slip is not predicted.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Vec<f64>>"))]
    pub residuals: Vec<f64>,
    /// What each slip counts: less than 1 where it is far off.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Vec<f64>>"))]
    pub weights: Vec<f64>,
    /// Slips whose derivatives are differences of exact answers, not exact themselves.
    pub by_differences: usize,
    /// Steps of the search.
    pub iterations: usize,
}

/// One unknown.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Estimate {
    /// Its name, such as "friction of left".
    pub name: String,
    /// What it is: a coefficient of friction, a force in N, or a multiple of what was given.
    pub kind: UnknownKind,
    /// Its value; where it is not fixed one of many.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub value: f64,
    /// Whether the slips fix it.
    pub is_fixed: bool,
    /// Its standard error; `None` where it is not fixed, or the scatter of slips is not known.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub standard_error: Option<f64>,
    /// What holds the truth in 95 of 100 cases.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub interval: Option<[f64; 2]>,
    /// The degrees of freedom of Student's distribution that the interval is from; `None` where it is normal, or there is none. Where slips share errors
    /// they are those that groups leave to this number; few of them make the interval wide.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub degrees_of_freedom: Option<f64>,
}

/// How the search ended.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "ending", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Ending {
    /// Nothing nearby is better.
    Converged,
    /// The limit of steps was reached before: what is told may still change.
    NotConverged {
        /// The limit.
        iterations: usize,
    },
    /// A slip is not predicted where the search begins, or where it had to stop.
    NotPredicted {
        /// The slip, from 0.
        slip: usize,
        /// Why.
        says: String,
    },
}

impl Identified {
    /// By which part friction may be less than found, the largest of all coefficients: down to the low end of their intervals. For
    /// [`Need::if_lower_by`](crate::need::Need::if_lower_by); 0 where none is known.
    #[must_use]
    pub fn friction_less(&self) -> f64 {
        self.less(UnknownKind::Friction)
    }

    /// By which part the squeeze may be less than found, likewise.
    #[must_use]
    pub fn squeeze_less(&self) -> f64 {
        self.less(UnknownKind::Squeeze)
    }

    fn less(&self, kind: UnknownKind) -> f64 {
        let part = |estimate: &Estimate| estimate.interval.map(|[low, _]| 1.0 - low / estimate.value);
        self.of(kind).filter_map(part).fold(0.0, f64::max)
    }

    /// Standard errors as the standard deviations of a grasp that is not known exactly, for [`Grasp::reserve`](crate::ask::Grasp::reserve) and its kind: of
    /// friction, squeeze and stiffness the largest of all unknowns of that kind. The seed is that of samples.
    #[must_use]
    pub fn uncertainty(&self, seed: u64) -> Uncertainty {
        let sigma = |kind| {
            let part = |estimate: &Estimate| estimate.standard_error.map(|error| error / estimate.value);
            self.of(kind).filter_map(part).fold(0.0, f64::max)
        };
        Uncertainty::seeded(seed)
            .with_friction(sigma(UnknownKind::Friction))
            .with_squeeze(sigma(UnknownKind::Squeeze).max(sigma(UnknownKind::Carried)))
            .with_stiffness(sigma(UnknownKind::Stiffness))
    }

    fn of(&self, kind: UnknownKind) -> impl Iterator<Item = &Estimate> {
        self.estimates.iter().filter(move |estimate| estimate.kind == kind)
    }
}
