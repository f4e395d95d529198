//! Estimates of unknown data of a grasp (friction, squeeze, carried forces, stiffness), with standard errors. They are computed from loads at which
//! the grasp was observed to slip. A carried force is the normal force of a contact before the load of a slip grows. The loss is the function of the
//! residuals that the search minimises.

use super::combination::FreeCombination;
use super::unknown::UnknownKind;
use crate::numerics::largest;
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;
use crate::sweep::Uncertainty;

/// Estimates of unknown data of a grasp, such as coefficients of friction, with standard errors. They are computed from loads at which the grasp was
/// observed to slip. The [`Display`](std::fmt::Display) of this answer is a sentence.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Identified {
    /// The estimates of the unknowns, in the order in which the question lists the unknowns.
    pub estimates: Vec<Estimate>,
    /// How the search for the unknowns ended: converged, out of steps, or with a slip that the model does not predict.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub ending: FitEnding,
    /// Number of observed slips from which the unknowns are estimated.
    pub slips: usize,
    /// Number of groups of slips; slips of one group may share an error, as slips of one specimen do. `None` if the slips have no groups.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub groups: Option<usize>,
    /// The relative standard deviation of the observed loads or angles, estimated from the residuals. `None` if the question gives it, if there are
    /// no [degrees of freedom](Self::degrees_of_freedom), or if the slips agree to all digits.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub scatter: Option<f64>,
    /// Root mean square of the residuals, each divided by the given standard deviation of its slip; the mean is the sum divided by the degrees of
    /// freedom. The expected value is 1. Slips beyond the [bound of outliers](super::Identify::with_outliers_beyond) count less. If this number is
    /// much more than one, the model is wrong, or the given standard deviations are too small. The standard errors are then multiplied by this
    /// number. `None` if no standard deviations were given, or no degrees of freedom remain.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub misfit: Option<f64>,
    /// Number of observations minus the number of independent combinations of unknowns that the observations determine. Observations are the observed
    /// slips, and the sums of unknowns that the question gives as known from other measurements.
    pub degrees_of_freedom: usize,
    /// Combinations of unknowns that may change together while the predicted load of every slip stays the same. The observed slips do not determine
    /// them.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub free: Vec<FreeCombination>,
    /// The estimates of all unknowns in each assignment of slips to unknowns, the best first, if several assignments fit equally well. An assignment
    /// says which contact slips first in each observation. It thus determines the unknowns on which the predicted load of the observation depends.
    /// Empty if only one assignment fits.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub assignments: Vec<Vec<Estimate>>,
    /// Logarithm of the observed over the predicted load or angle, slip by slip; empty if the model does not predict some slip.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Vec<f64>>"))]
    pub residuals: Vec<f64>,
    /// The weight of each slip in the least-squares search: 1, or less if the residual of the slip is large.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Vec<f64>>"))]
    pub weights: Vec<f64>,
    /// Number of slips without exact derivatives with respect to the unknowns. Their derivatives are difference quotients of predictions.
    pub by_differences: usize,
    /// Number of steps of the search that ended at these estimates.
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
    /// Whether the slips determine the unknown, with the same value in all [`Identified::assignments`]. False, too, if its error is known and so
    /// large that no interval is given.
    pub is_fixed: bool,
    /// The standard error of the estimate, in the unit of `value`. `None` if the slips do not determine the unknown, or if the standard deviation of
    /// the observations is not known.
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
    /// The model of the grasp predicts no load (or angle) for one of the observed slips. This happened at the start of the search, or next to the
    /// point where the search had to stop.
    NotPredicted {
        /// The number of the slip for which the model predicts no load, from 0.
        slip: usize,
        /// The reason why the model predicts no load for this slip, as a clause.
        says: String,
    },
}

impl Identified {
    /// The fraction by which friction may be lower than estimated. It is the largest relative decrease from an estimated coefficient of friction to
    /// the lower end of its confidence interval; 0 if no interval is known. [`Need::if_lower_by`](crate::need::Need::if_lower_by) takes this number
    /// as its first argument.
    #[must_use]
    pub fn friction_less(&self) -> f64 {
        self.less(UnknownKind::Friction)
    }

    /// The fraction by which the squeeze may be lower than estimated. It is the largest relative decrease from an estimated squeeze factor to the
    /// lower end of its confidence interval; 0 if no interval is known.
    #[must_use]
    pub fn squeeze_less(&self) -> f64 {
        self.less(UnknownKind::Squeeze)
    }

    fn less(&self, kind: UnknownKind) -> f64 {
        let part = |estimate: &Estimate| estimate.interval.map(|[low, _]| 1.0 - low / estimate.value);
        self.largest(kind, &part)
    }

    /// The standard errors as an [`Uncertainty`] of the grasp, for [`Grasp::reserve`](crate::ask::Grasp::reserve) and similar methods. The relative
    /// errors of friction, squeeze and stiffness are the largest among all unknowns of that kind. Carried forces are treated as squeezes. `seed` is
    /// the seed of the random samples.
    pub fn uncertainty(&self, seed: u64) -> Uncertainty {
        let sigma = |kind| {
            let part = |estimate: &Estimate| estimate.standard_error.map(|error| error / estimate.value);
            self.largest(kind, &part)
        };
        Uncertainty::seeded(seed)
            .with_friction(sigma(UnknownKind::Friction))
            .with_squeeze(sigma(UnknownKind::Squeeze).max(sigma(UnknownKind::Carried)))
            .with_stiffness(sigma(UnknownKind::Stiffness))
    }

    /// The largest value that `part` returns for the estimates of all unknowns of this kind; 0 if none is positive.
    fn largest(&self, kind: UnknownKind, part: &dyn Fn(&Estimate) -> Option<f64>) -> f64 {
        largest(&self.estimates, &|estimate| {
            if estimate.kind == kind { part(estimate) } else { None }.unwrap_or(0.0)
        })
    }
}
