//! Estimates of parameters of a grasp (friction, squeeze, carried forces, stiffness), with standard errors. They follow from observations, i.e. loads
//! or angles at which the grasp was observed to slip. A carried force is the normal force of a contact before the load of an observation grows. The
//! loss is the function of the residuals that the search minimises.

use super::combination::FreeCombination;
use super::unknown::UnknownKind;
use crate::numerics::largest;
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;
use crate::sweep::Uncertainty;

/// Estimates of parameters of a grasp, such as coefficients of friction, with standard errors. They follow from observations: loads or angles at
/// which the grasp was observed to slip. The [`Display`](std::fmt::Display) of this answer is a sentence.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Identified {
    /// The estimates of the parameters, in the order in which the question lists them.
    pub estimates: Vec<Estimate>,
    /// How the search for the parameters ended: converged, out of steps, or with an observation for which the model predicts no slip.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub ending: FitEnding,
    /// Number of observations from which the parameters are estimated.
    pub slips: usize,
    /// Number of groups of observations that may share an error, as those of one specimen do. `None` if the observations have no groups.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub groups: Option<usize>,
    /// The relative standard deviation of the observed loads or angles, estimated from the residuals. `None` if the question gives it, if there are
    /// no [degrees of freedom](Self::degrees_of_freedom), or if the observations agree to all digits.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub scatter: Option<f64>,
    /// Root mean square of the residuals, each divided by the given standard deviation of its observation; the mean is the sum divided by the degrees
    /// of freedom. The expected value is 1. Observations beyond the [bound of outliers](super::Identify::with_outliers_beyond) count less. If this
    /// number is much more than one, the model is wrong, or the given standard deviations are too small. The standard errors are then multiplied by
    /// this number. `None` if no standard deviations were given, or no degrees of freedom remain.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub misfit: Option<f64>,
    /// Number of observations and known sums, minus the number of independent combinations of parameters that these determine. Known sums are sums of
    /// parameters that the question gives as known from other measurements.
    pub degrees_of_freedom: usize,
    /// Combinations of parameters that may change together while the predicted load of every observation stays the same. The observations do not
    /// determine them.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub free: Vec<FreeCombination>,
    /// The estimates of all parameters for each assignment of observations to parameters, the best first, if several assignments fit equally well. An
    /// assignment says which contact slips first in each observation. It thus determines the parameters on which the predicted load of the
    /// observation depends. Empty if only one assignment fits.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub assignments: Vec<Vec<Estimate>>,
    /// Logarithm of the observed over the predicted load or angle, for each observation. Empty if the model predicts no slip for some observation.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Vec<f64>>"))]
    pub residuals: Vec<f64>,
    /// The weight of each observation in the least-squares search: 1, or less if its residual is large.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Vec<f64>>"))]
    pub weights: Vec<f64>,
    /// Number of observations without exact derivatives with respect to the parameters. Their derivatives are difference quotients of predictions.
    pub by_differences: usize,
    /// Number of steps of the search that ended at these estimates.
    pub iterations: usize,
}

/// The estimate of one parameter, with its error.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Estimate {
    /// The name of the parameter, such as "friction of left".
    pub name: String,
    /// The kind of the parameter: a coefficient of friction, a force in N, or a factor on the given value.
    pub kind: UnknownKind,
    /// The estimate. If the observations do not determine the parameter, it is one of many values that fit the observations equally well.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub value: f64,
    /// Whether the observations determine the parameter, with the same value in all [`Identified::assignments`]. False, too, if its error is known
    /// and so large that no interval is given.
    pub is_fixed: bool,
    /// The standard error of the estimate, in the unit of `value`. `None` if the observations do not determine the parameter, or if the standard
    /// deviation of the observations is not known.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub standard_error: Option<f64>,
    /// The confidence interval of 95 % for the parameter; `None` without a standard error.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub interval: Option<[f64; 2]>,
    /// The degrees of freedom of Student's distribution in the interval; `None` if the distribution is normal, or if there is no interval. If
    /// observations share errors in groups, the degrees of freedom depend on the number of groups, not on the number of observations. Few degrees of
    /// freedom make the interval wide.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub degrees_of_freedom: Option<f64>,
}

/// How the search for the parameters ended.
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
    /// The model of the grasp predicts no load (or angle) for one of the observations. This happened at the start of the search, or at the shortest
    /// step from the point where the search had to stop.
    NotPredicted {
        /// The number of the observation for which the model predicts no slip, from 0.
        slip: usize,
        /// The reason why the model predicts no slip for this observation, as a clause.
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
    /// errors of friction, squeeze and stiffness are the largest among all parameters of that kind. Carried forces count as squeeze. `seed` is the
    /// seed of the random samples.
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

    /// The largest value that `part` returns for the estimates of all parameters of this kind; 0 if none is positive.
    fn largest(&self, kind: UnknownKind, part: &dyn Fn(&Estimate) -> Option<f64>) -> f64 {
        largest(&self.estimates, &|estimate| {
            if estimate.kind == kind { part(estimate) } else { None }.unwrap_or(0.0)
        })
    }
}
