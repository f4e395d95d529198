//! Standard errors and confidence intervals of the parameters, from a fit to the observations. A parameter is a number of the grasp that is sought,
//! such as a coefficient of friction. An observation is a load or angle at which slip was observed. A known sum is a sum of parameters that is known
//! from another measurement. The observations of one group may share an error, e.g. because they are of one specimen or of one day.

use nalgebra::DMatrix;

use super::answer::{Estimate, FitEnding, Identified};
use super::combination::FreeCombination;
use super::fit::{FitEnd, Fitted, Scatter, rank, singular};
use super::grouped::Grouped;
use super::model::{Linear, Model};
use super::robust::Huber;
use super::tolerances::INDISTINCT;
use crate::numerics::{IntoList, Reals, all_some, mapped, numbered, two_sided};
use crate::prelude::*;

/// The answer from one fit: estimates with standard errors and intervals, combinations of parameters that the observations do not determine,
/// residuals and weights.
pub(super) fn identified(model: &Model<'_>, fit: &Fitted) -> Identified {
    let grasp = &model.layouts[0];
    let names: Vec<String> = mapped(&model.asked.unknowns, &|unknown| unknown.called(grasp));
    let spread = fit.linear.as_ref().map(|linear| Spread::of(model, linear, &fit.scatter));
    let estimates = numbered(names.len(), &|j| {
        let (name, value) = (&names[j], fit.logs[j].exp());
        let known = spread.as_ref().and_then(|spread| spread.of_unknown(j));
        let (error, degrees) = known.unwrap_or((f64::INFINITY, None));
        // The error is the standard error of a logarithm. If it exceeds one, the interval spans nearly two powers of ten, over which the problem is
        // not linear, and no error is given.
        let is_known = error.is_finite() && error <= 1.0;
        // 0.95 is the probability with which the interval contains the true value.
        let factor = (two_sided(0.95, degrees) * error).exp();
        Estimate {
            name: name.clone(),
            kind: model.asked.unknowns[j].kind,
            value,
            is_fixed: spread.as_ref().is_some_and(|spread| spread.fixes(j))
                && (is_known || !error.is_finite()),
            standard_error: is_known.then_some(value * error),
            interval: is_known.then_some([value / factor, value * factor]),
            degrees_of_freedom: degrees.filter(|_| is_known),
        }
    });
    let ending = match fit.end {
        FitEnd::Converged => FitEnding::Converged,
        FitEnd::Limit => FitEnding::NotConverged { iterations: fit.iterations },
        FitEnd::NoSlip(slip, why) => FitEnding::NotPredicted { slip, says: why.says().to_owned() },
    };
    let stays = |times: &[f64]| {
        let there: Vec<_> = fit.logs.iter().zip(times).map(|(log, times)| log + times.ln()).list();
        let (Ok(Ok(there)), Some(here)) = (model.residuals(&there), &fit.linear) else { return false };
        there.iter().zip(&here.residuals).all(|(there, here)| (there - here).abs() <= INDISTINCT)
    };
    let values: Vec<_> = mapped(&fit.logs, &|log| log.exp());
    let among = |spread: &Spread| FreeCombination::among(spread.free(), (&names, &values), &stays);
    let free = spread.as_ref().map_or_else(Vec::new, among);
    let (residuals, by_differences) = fit.linear.as_ref().map_or_else(Default::default, |linear| {
        (linear.residuals[..model.asked.slips.len()].to_vec(), linear.by_differences)
    });
    let is_given = model.asked.slips[0].scatter.is_some();
    let scale = Some(fit.scatter.scale).filter(|_| spread.is_some() && fit.scatter.degrees > 0);
    let sigma = fit.scatter.rows.iter();
    let weights = residuals.iter().zip(sigma).map(|(r, sigma)| model.huber().weight(r / sigma)).list();
    Identified {
        estimates,
        ending,
        slips: model.asked.slips.len(),
        groups: groups(model)
            .map(|groups| (0..groups.len()).filter(|k| !groups[..*k].contains(&groups[*k])).count()),
        scatter: scale.filter(|scale| !is_given && *scale > INDISTINCT),
        misfit: scale.filter(|_| is_given),
        degrees_of_freedom: fit.scatter.degrees,
        free,
        assignments: Vec::new(),
        residuals,
        weights,
        by_differences,
        iterations: fit.iterations,
    }
}

/// The data at the solution from which the standard errors of the logarithms of the parameters are computed.
struct Spread {
    /// Singular values, the largest first, of the matrix of derivatives of all predictions, each row weighted by the inverse of its standard
    /// deviation.
    values: Vec<f64>,
    /// Right singular vectors, as columns, of the matrix of derivatives of all predictions, each row weighted by the inverse of its standard
    /// deviation. They are directions in the logarithms of the parameters.
    directions: DMatrix<f64>,
    /// Number of independent linear combinations of the parameters that observations and known sums determine.
    rank: usize,
    scatter: Scatter,
    /// The contributions of the groups of observations to the standard errors. `None` unless every observation is in a group.
    grouped: Option<Grouped>,
}

/// The number of the group of each observation; `None` unless every observation is in a group.
fn groups(model: &Model<'_>) -> Option<Vec<usize>> {
    all_some(model.asked.slips.iter().map(|slip| slip.group))
}

impl Spread {
    fn of(model: &Model<'_>, linear: &Linear, scatter: &Scatter) -> Self {
        let (slips, unknowns) = (model.asked.slips.len(), model.asked.unknowns.len());
        let rows = linear.residuals.len();
        let huber = model.huber();
        let all_scaled = numbered(rows, &|k| linear.residuals[k] / scatter.rows[k]);
        let scaled = &all_scaled[..slips];
        let inside = scaled.iter().filter(|u| u.abs() <= huber.0).count();
        let slope = Huber::slope(slips, inside, unknowns);
        let groups = groups(model);
        // Huber's loss clamps large residuals, so that the observations determine the parameters less accurately. The factor `counts` on the weight
        // of each observation accounts for this. With groups the scatter of the clamped residuals enters later, in `Grouped`. Without groups `counts`
        // also contains this scatter: it is divided by the root mean square that clamped residuals have if residuals are normally distributed.
        let counts = if groups.is_some() { slope.sqrt() } else { slope / huber.mean_square().sqrt() };
        let weights = numbered(rows, &|k| (if k < slips { counts } else { 1.0 }) / scatter.rows[k]);
        let (values, directions, _) = singular(&linear.jacobian, &linear.residuals, &weights);
        let mut spread =
            Self { values, directions, rank: rank(linear), scatter: scatter.clone(), grouped: None };
        spread.grouped = groups.map(|groups| {
            let rows =
                DMatrix::from_diagonal(&weights.into()) * &linear.jacobian * spread.scaled_directions();
            let scaled = numbered(rows.nrows(), &|k| {
                if k < slips { huber.pull(all_scaled[k]) / slope.sqrt() } else { all_scaled[k] }
            });
            Grouped::of(&rows, &scaled, &groups)
        });
        spread
    }

    /// The directions, in the logarithms of the parameters, that the observations determine: a basis, as columns. The length of a column is the
    /// standard error along its direction if observations are independent.
    fn scaled_directions(&self) -> DMatrix<f64> {
        let mut directions = self.directions.columns(0, self.rank).into_owned();
        for (mut column, value) in directions.column_iter_mut().zip(&self.values) {
            column /= *value;
        }
        directions
    }

    /// Directions in the logarithms of the parameters that the observations do not determine, as orthonormal columns.
    fn free(&self) -> DMatrix<f64> {
        self.directions.columns(self.rank, self.values.len() - self.rank).into_owned()
    }

    fn fixes(&self, unknown: usize) -> bool {
        self.free().row(unknown).iter().map(|x| x * x).added() <= INDISTINCT
    }

    /// The standard error of the logarithm of a parameter, and the degrees of freedom of Student's interval (`None` for a normal distribution).
    /// `None` if the observations do not determine the parameter, or if its error is not known, for example because the observations agree to all
    /// digits.
    fn of_unknown(&self, unknown: usize) -> Option<(f64, Option<f64>)> {
        let degrees = self.scatter.is_estimated.then_some(self.scatter.degrees as f64);
        let is_known =
            !self.scatter.is_estimated || self.scatter.degrees > 0 && self.scatter.scale > INDISTINCT;
        if !self.fixes(unknown) || !is_known {
            return None;
        }
        let along = self.scaled_directions().row(unknown).transpose();
        let Some(grouped) = &self.grouped else { return Some((along.norm(), degrees)) };
        let error = grouped.of_unknown(&along)?;
        Some((error.variance.sqrt(), Some(error.degrees)))
    }
}
