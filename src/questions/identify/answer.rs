//! Estimates of unknown data of a grasp (friction, squeeze, forces, stiffness) from observed slips, with their errors.

use super::combination::FreeCombination;
use super::unknown::UnknownKind;
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;
use crate::sweep::Uncertainty;

/// The estimates of unknown data of a grasp from observed slips, with their errors; its [`Display`](std::fmt::Display) is a sentence.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Identified {
    /// The estimates of the unknowns, in the order of the question.
    pub estimates: Vec<Estimate>,
    /// How the search for the unknowns ended: converged, out of steps, or with a slip that the model does not predict.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub ending: FitEnding,
    /// Number of observed slips from which the unknowns are estimated.
    pub slips: usize,
    /// Number of groups of slips that may share errors; `None` if the slips have no groups.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub groups: Option<usize>,
    /// The estimated relative scatter of loads or angles. `None` if it was given, or if there are no [degrees of freedom](Self::degrees_of_freedom).
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub scatter: Option<f64>,
    /// Root mean square of the residuals divided by the given scatter; `None` if the scatter was not given. If it is much more than one, the model is
    /// wrong, or the given scatter too small.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub misfit: Option<f64>,
    /// Number of observations minus the number of independent combinations of unknowns that the observations determine. Observations are the observed
    /// slips, and the sums of unknowns that the question gives as known from other measurements.
    pub degrees_of_freedom: usize,
    /// Combinations of unknowns along which no predicted slip changes, so that the slips do not determine them.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub free: Vec<FreeCombination>,
    /// If several assignments of slips to unknowns fit equally well, the estimates of all unknowns in each assignment, the best first. Assignments
    /// differ in which contact slips first. Empty if only one assignment fits.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub assignments: Vec<Vec<Estimate>>,
    /// Logarithm of the observed over the predicted load or angle, slip by slip; empty if the model does not predict some slip.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Vec<f64>>"))]
    pub residuals: Vec<f64>,
    /// The weight of each slip in the search: 1, or less if its residual is large.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Vec<f64>>"))]
    pub weights: Vec<f64>,
    /// Number of slips without exact derivatives with respect to the unknowns. Their derivatives are difference quotients of predictions.
    pub by_differences: usize,
    /// Number of steps of the search from the first starting point to the estimates.
    pub iterations: usize,
}

/// The estimate of one unknown, with its error.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Estimate {
    /// The name of the unknown, such as "friction of left".
    pub name: String,
    /// The kind of the unknown: a coefficient of friction, a force in N, or a factor on the given value.
    pub kind: UnknownKind,
    /// The estimate; if the slips do not determine the unknown, one of many values that fit the slips equally well.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub value: f64,
    /// Whether the slips determine the unknown: accurately enough for an error to be given, and with the same value in all
    /// [`Identified::assignments`].
    pub is_fixed: bool,
    /// The standard error of the estimate, in its unit; `None` if the slips do not determine the unknown, or if their scatter is not known.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub standard_error: Option<f64>,
    /// The confidence interval of 95 % for the unknown; `None` without a standard error.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub interval: Option<[f64; 2]>,
    /// The degrees of freedom of Student's distribution in the interval; `None` if the distribution is normal, or if there is no interval. If slips
    /// share errors in groups, the degrees of freedom depend on the number of groups, not on the number of slips. Few degrees of freedom make the
    /// interval wide.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub degrees_of_freedom: Option<f64>,
}

/// How the search for the unknowns ended.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "ending", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum FitEnding {
    /// The estimates minimise the loss: no step nearby decreases it by more than rounding.
    Converged,
    /// The limit of steps was reached before convergence, so the estimates are not final.
    NotConverged {
        /// The limit of steps of the search.
        iterations: usize,
    },
    /// The model predicts no load for one slip, at the start of the search, or next to the point where the search had to stop.
    NotPredicted {
        /// The number of the slip for which the model predicts no load, from 0.
        slip: usize,
        /// The reason why the model predicts no load for this slip, as a clause.
        says: String,
    },
}

impl Identified {
    /// The largest relative decrease from an estimated coefficient of friction to the low end of its interval; 0 if no interval is known. It is the
    /// argument of [`Need::if_lower_by`](crate::need::Need::if_lower_by).
    #[must_use]
    pub fn friction_less(&self) -> f64 {
        self.less(UnknownKind::Friction)
    }

    /// The largest relative decrease from an estimated squeeze factor to the low end of its interval; 0 if no interval is known.
    #[must_use]
    pub fn squeeze_less(&self) -> f64 {
        self.less(UnknownKind::Squeeze)
    }

    fn less(&self, kind: UnknownKind) -> f64 {
        let part = |estimate: &Estimate| estimate.interval.map(|[low, _]| 1.0 - low / estimate.value);
        self.of(kind).filter_map(part).fold(0.0, f64::max)
    }

    /// The standard errors as an [`Uncertainty`] of the grasp, for [`Grasp::reserve`](crate::ask::Grasp::reserve) and similar methods. The relative
    /// errors of friction, squeeze and stiffness are the largest among all unknowns of that kind. Carried forces are treated as squeezes. `seed` is
    /// the seed of the samples.
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
