//! The search for the parameters with the least Huber loss, by damped Gauss-Newton steps in the logarithms of the parameters. This loss is quadratic
//! in small residuals and linear in large ones. A parameter is a number of the grasp that is sought, such as a coefficient of friction. An
//! observation is a load or angle at which slip was observed. A known sum is a sum of parameters that is known from another measurement. The scatter
//! of an observation is its relative standard deviation.

use nalgebra::{DMatrix, DVector};

use super::assignments::gain;
use super::model::{Linear, Model, PredictionFailure};
use super::robust::Huber;
use super::tolerances::{CONVERGED_GAIN, CONVERGED_STEP, INDISTINCT};
use super::unknown::UnknownKind;
use crate::error::Error;
use crate::numerics::{
    IntoList, Reals, Singular, chosen, counted, every_index, highest, mapped, matrix_of, two_sided, vector_of,
};
use crate::prelude::*;

/// The parameters with the least loss, as found by a search: `logs` are their logarithms. `linear` has the residuals of all observations and known
/// sums at these values, and their derivatives. `linear` is `None` if the model does not predict slip for all observations.
pub(super) struct Fitted {
    pub(super) logs: Vec<f64>,
    pub(super) linear: Option<Linear>,
    /// Relative standard deviations of the observations (given or estimated) and of the known sums of parameters.
    pub(super) scatter: Scatter,
    pub(super) iterations: usize,
    pub(super) end: FitEnd,
}

pub(super) enum FitEnd {
    Converged,
    Limit,
    /// The model predicts no slip for the observation with this index, at the start of the search, or at the shortest step from the point where it
    /// stopped.
    NoSlip(usize, PredictionFailure),
}

/// Relative standard deviations of observations and known sums, by which residuals are divided.
#[derive(Clone, Default)]
pub(super) struct Scatter {
    /// One standard deviation for each observation, then one for each known sum of parameters, relative to the observed value.
    pub(super) rows: Vec<f64>,
    /// Estimated from the residuals: the standard deviation common to all observations or, if standard deviations are given, a common factor on them.
    pub(super) scale: f64,
    /// Whether the standard deviations `rows` contain the factor `scale`. They do if no standard deviations are given, or if the residuals exceed the
    /// given ones at 95 %.
    pub(super) is_estimated: bool,
    /// Degrees of freedom: the number of observations and known sums minus the number of combinations of parameters that they determine.
    pub(super) degrees: usize,
}

impl Scatter {
    /// Whether the residuals exceed the given standard deviations at 95 %, by the distribution of chi-square in the approximation of Wilson and
    /// Hilferty.
    fn is_exceeded(&self) -> bool {
        let part = 2.0 / (9.0 * self.degrees as f64);
        self.degrees > 0 && self.scale > (1.0 - part + two_sided(0.9, None) * part.sqrt()).powf(1.5)
    }
}

impl Model<'_> {
    pub(super) fn huber(&self) -> Huber {
        Huber(self.asked.outliers())
    }

    /// Relative standard deviations of observations and known sums. The question gives them for known sums of parameters, and for all observations or
    /// for none. If for none, or if `is_estimated`, a factor common to all observations is estimated from the residuals.
    fn scatter(&self, linear: &Linear, is_estimated: bool) -> Scatter {
        let (slips, known) = (&self.asked.slips, &self.asked.known);
        let given: Vec<_> = mapped(slips, &|slip| slip.scatter.unwrap_or(1.0));
        let scaled: Vec<f64> = linear.residuals.iter().zip(&given).map(|(r, sigma)| r / sigma).list();
        let degrees = linear.residuals.len().saturating_sub(rank(linear));
        let scale = self.huber().scale(&scaled, degrees);
        let is_estimated = is_estimated || slips[0].scatter.is_none();
        let times = if is_estimated { scale } else { 1.0 };
        let of_slips = given.into_iter().map(|sigma| times * sigma);
        let rows = of_slips.chain(known.iter().map(|known| known.scatter)).list();
        Scatter { rows, scale, is_estimated, degrees }
    }

    /// The weight of residual number `row`, which is `u` standard deviations: Huber's weight for observations. It is 1 for known sums of parameters,
    /// which come after the observations.
    fn weight(&self, row: usize, u: f64) -> f64 {
        if row < self.asked.slips.len() { self.huber().weight(u) } else { 1.0 }
    }

    pub(super) fn loss(&self, residuals: &[f64], scatter: &Scatter) -> f64 {
        let of_row = |(row, (r, sigma)): (usize, (&f64, &f64))| {
            let u = r / sigma;
            if row < self.asked.slips.len() { self.huber().loss(u) } else { 0.5 * u * u }
        };
        residuals.iter().zip(&scatter.rows).enumerate().map(of_row).added()
    }
}

/// Logarithms of the parameters, and the model's prediction of all observations with these parameters. The error holds the index, from 0, of the
/// first observation in the list for which no slip is predicted, and the reason.
type StartingFit = (Vec<f64>, Result<Linear, (usize, PredictionFailure)>);

/// For each parameter, whether it may be multiplied by a factor in the search for starting values. True for coefficients of friction. If no friction
/// is sought, true for factors on the squeeze and carried forces (normal forces before the load grows).
fn changing(model: &Model<'_>) -> Vec<bool> {
    let unknowns = &model.asked.unknowns;
    let has_friction = unknowns.iter().any(|unknown| unknown.kind == UnknownKind::Friction);
    mapped(unknowns, &|unknown| match unknown.kind {
        UnknownKind::Friction => true,
        UnknownKind::Squeeze | UnknownKind::Carried => !has_friction,
        UnknownKind::Stiffness => false,
    })
}

/// The first point, in the logarithms of the parameters, at which the model predicts slip for all observations. It is given by the start values of
/// the parameters, perhaps with all friction that is sought multiplied by a common factor. The factor is halved if the object holds however far the
/// load goes, and doubled if the object is lost before the load grows. Once both have occurred, the logarithm of the factor is bisected. If no
/// friction is sought, the factors on the squeeze and the carried forces are multiplied instead.
fn starting_fit(model: &Model<'_>) -> Result<StartingFit, Error> {
    let unknowns = &model.asked.unknowns;
    let begin: Vec<f64> = mapped(unknowns, &|unknown| unknown.begins_at(model.layouts).ln());
    let first = model.linear(&begin)?;
    let Err((_, mut why)) = first else { return Ok((begin, first)) };
    let changes = changing(model);
    let (mut too_little, mut too_much, mut by) = (None, None, 0.0);
    // Twelve further trials reach factors down to 1/4096 if the grasp always holds too well, or up to 4096 if it always holds too little.
    for _ in 0..12 {
        match why {
            PredictionFailure::HoldsTooWell(_) => too_much = Some(by),
            PredictionFailure::HoldsTooLittle(_) => too_little = Some(by),
        }
        by = match (too_little, too_much) {
            (Some(low), Some(high)) => 0.5 * (low + high),
            (None, _) => by - core::f64::consts::LN_2,
            (_, None) => by + core::f64::consts::LN_2,
        };
        let mut moved = begin.clone();
        for (log, _) in moved.iter_mut().zip(&changes).filter(|(_, changes)| **changes) {
            *log += by;
        }
        match model.linear(&moved)? {
            Ok(linear) => return Ok((moved, Ok(linear))),
            Err((_, other)) => why = other,
        }
    }
    Ok((begin, first))
}

/// The logarithms of the parameters with the least loss (Huber's, of the residuals in standard deviations), by a search from the start values of the
/// question.
pub(super) fn fitted(model: &Model<'_>) -> Result<Fitted, Error> {
    let (begin, linear) = starting_fit(model)?;
    let fit = match linear {
        Ok(linear) => fitted_from(model, begin, linear)?,
        Err((slip, why)) => return Ok(Fitted::from(begin, FitEnd::NoSlip(slip, why))),
    };
    if let Some((begin, linear)) = off_the_plateau(model, &fit)? {
        let other = fitted_from(model, begin, linear)?;
        if gain(model, &other, &fit) > 0.5 * two_sided(0.95, None).powi(2) {
            return Ok(other);
        }
    }
    Ok(fit)
}

/// A start for a second search; `None` if `fit` needs none. Some parameters may be multiplied ([`changing`]): coefficients of friction or, if no
/// friction is sought, factors on the squeeze and carried forces. A second search is needed if the predicted load of some observation differs from
/// the observed one, but depends on none of these parameters. An example is a box of which the model predicts that it tips. With less friction it
/// slides before it tips.
///
/// These parameters are halved if the observed load is below its prediction, else doubled, until the prediction depends on them; at most twelve
/// times.
fn off_the_plateau(model: &Model<'_>, fit: &Fitted) -> Result<Option<(Vec<f64>, Linear)>, Error> {
    let (changes, Some(here)) = (changing(model), &fit.linear) else { return Ok(None) };
    let is_flat = |linear: &Linear, k: usize| {
        every_index(changes.len(), &|j| !changes[j] || linear.jacobian[(k, j)] == 0.0)
    };
    let off = |k: &usize| here.residuals[*k].abs();
    let flat = chosen(model.asked.slips.len(), &|k| off(k) > INDISTINCT && is_flat(here, *k));
    let Some(&slip) = highest(&flat, &off) else { return Ok(None) };
    let mut logs = fit.logs.clone();
    for _ in 0..if changes.contains(&true) { 12 } else { 0 } {
        for (log, _) in logs.iter_mut().zip(&changes).filter(|(_, changes)| **changes) {
            *log += core::f64::consts::LN_2.copysign(here.residuals[slip]);
        }
        match model.linear(&logs)? {
            Ok(linear) if is_flat(&linear, slip) => {}
            linear => return Ok(linear.ok().map(|linear| (logs, linear))),
        }
    }
    Ok(None)
}

impl Fitted {
    fn from(logs: Vec<f64>, end: FitEnd) -> Self {
        Self { logs, linear: None, scatter: Scatter::default(), iterations: 0, end }
    }
}

/// The logarithms of the parameters with the least loss, by a search from the logarithms `begin` at which the model predicts slip for all
/// observations. If the residuals exceed the given standard deviations at 95 %, these deviations are multiplied by a common factor, and the search
/// continues.
pub(super) fn fitted_from(model: &Model<'_>, begin: Vec<f64>, linear: Linear) -> Result<Fitted, Error> {
    let mut fit = fitted_with(model, begin, linear, false)?;
    if !fit.scatter.is_estimated
        && fit.scatter.is_exceeded()
        && let Some(linear) = fit.linear.take()
    {
        fit = fitted_with(model, fit.logs, linear, true)?;
    }
    loosened(model, fit)
}

/// Returns `fit`, or another fit that explains the observations as well. If a single observation determines a parameter, its load may be low by
/// scatter alone. The search is therefore repeated with this parameter doubled, so that its contact slips first in no observation. The new fit is
/// returned unless `fit` is better at 95 %. Any of the observations may be low by scatter, so the level of the test is corrected for their number
/// (Bonferroni).
fn loosened(model: &Model<'_>, mut fit: Fitted) -> Result<Fitted, Error> {
    let probability = 1.0 - 0.05 / model.asked.slips.len() as f64;
    for unknown in 0..fit.logs.len() {
        let rows = |linear: &Linear| counted(linear.jacobian.column(unknown).as_slice(), &|x| *x != 0.0);
        // With a single degree of freedom the estimate of the scatter is too uncertain for this comparison.
        if fit.scatter.degrees < 2 || fit.linear.as_ref().is_none_or(|here| rows(here) != 1) {
            continue;
        }
        let mut doubled = fit.logs.clone();
        doubled[unknown] += core::f64::consts::LN_2;
        let Some(linear) = model.linear(&doubled)?.ok().filter(|there| rows(there) == 0) else { continue };
        let other = fitted_with(model, doubled, linear, fit.scatter.is_estimated)?;
        let degrees = fit.scatter.is_estimated.then_some(fit.scatter.degrees as f64);
        if other.linear.as_ref().is_some_and(|there| rows(there) == 0)
            && gain(model, &fit, &other) <= 0.5 * two_sided(probability, degrees).powi(2)
        {
            fit = other;
        }
    }
    Ok(fit)
}

/// One search for the least loss, from the logarithms `begin`; [`fitted_from`] may run several. If `is_estimated`, a common factor on the given
/// standard deviations is estimated from the residuals.
fn fitted_with(
    model: &Model<'_>,
    begin: Vec<f64>,
    mut linear: Linear,
    is_estimated: bool,
) -> Result<Fitted, Error> {
    let mut fit = Fitted::from(begin, FitEnd::Limit);
    // Levenberg's damping, as a fraction of the square of the largest singular value of the weighted derivatives.
    let mut damping = 1e-3;
    loop {
        fit.scatter = model.scatter(&linear, is_estimated);
        let steps = LinearisedFit::of(model, &linear, &fit.scatter);
        let loss = model.loss(&linear.residuals, &fit.scatter);
        let full = steps.step(0.0);
        let is_little = |step: &DVector<f64>| {
            step.amax() <= CONVERGED_STEP || steps.promise(step) <= CONVERGED_GAIN * loss
        };
        if is_little(&full) {
            fit.end = FitEnd::Converged;
            break;
        }
        if fit.iterations == model.asked.iterations() {
            break;
        }
        fit.iterations += 1;
        let mut unseen = None;
        let better = loop {
            let mut step = steps.step(damping);
            if is_little(&step) {
                break None;
            }
            // No logarithm changes by more than one in a step, since the linearisation is not valid farther away.
            step *= (1.0 / step.amax()).min(1.0);
            let stepped: Vec<f64> = fit.logs.iter().zip(step.iter()).map(|(x, dx)| x + dx).list();
            match model.linear(&stepped)? {
                Ok(linear) if model.loss(&linear.residuals, &fit.scatter) < loss => {
                    break Some((stepped, linear));
                }
                // Damping grows, so the steps that are tried become shorter. Only the last and shortest step shows whether this point is at the
                // boundary of the region in which the model predicts slip for all observations.
                Ok(_) => unseen = None,
                Err(none) => unseen = Some(none),
            }
            damping *= 10.0;
        };
        let Some((stepped, better)) = better else {
            // Not even the shortest step decreases the loss. The minimum is at a kink, or at the boundary of the region where the model predicts slip
            // for all observations.
            fit.end = unseen.map_or(FitEnd::Converged, |(slip, why)| FitEnd::NoSlip(slip, why));
            break;
        };
        (fit.logs, linear) = (stepped, better);
        damping = (damping * 0.1).max(f64::EPSILON);
    }
    // Derivatives, and with them errors, are kept only if the model predicts slip for all observations at the end.
    fit.linear = Some(linear).filter(|_| !matches!(fit.end, FitEnd::NoSlip(..)));
    Ok(fit)
}

/// Number of independent combinations of parameters that observations and known sums determine.
pub(super) fn rank(linear: &Linear) -> usize {
    let (values, ..) = singular(&linear.jacobian, &linear.residuals, &vec![1.0; linear.residuals.len()]);
    let most = values.iter().copied().most();
    values.iter().filter(|value| **value > INDISTINCT * most).count()
}

/// The linearised least-squares problem at one set of values of the parameters, as a singular value decomposition, from which damped steps follow.
struct LinearisedFit {
    /// Singular values of the weighted derivatives.
    values: Vec<f64>,
    /// Right singular vectors of the weighted derivatives, as columns.
    directions: DMatrix<f64>,
    /// Components of the weighted residuals along the left singular vectors.
    along: Vec<f64>,
}

impl LinearisedFit {
    /// The linearised least-squares problem at the point of `linear`. Each residual is weighted by the inverse of its standard deviation and by the
    /// root of Huber's weight.
    fn of(model: &Model<'_>, linear: &Linear, scatter: &Scatter) -> Self {
        let row = |(k, (r, sigma)): (usize, (&f64, &f64))| model.weight(k, r / sigma).sqrt() / sigma;
        let weights: Vec<_> = linear.residuals.iter().zip(&scatter.rows).enumerate().map(row).list();
        let (values, directions, along) = singular(&linear.jacobian, &linear.residuals, &weights);
        Self { values, directions, along }
    }

    /// The step in the logarithms of the parameters for the damping `damping`, a fraction of the square of the largest singular value. The step is
    /// zero along combinations of parameters that the observations do not determine.
    fn step(&self, damping: f64) -> DVector<f64> {
        let most = self.values.iter().copied().most();
        let mut step = DVector::zeros(self.directions.nrows());
        for (k, value) in self.values.iter().enumerate().filter(|(_, value)| **value > INDISTINCT * most) {
            let along = value * self.along[k] / (value * value + damping * most * most);
            step += self.directions.column(k) * along;
        }
        step
    }

    /// The decrease of the loss by a step, as the linearised problem predicts it.
    fn promise(&self, step: &DVector<f64>) -> f64 {
        let part = |(k, value): (usize, &f64)| {
            let component = value * self.directions.column(k).dot(&step.column(0));
            component * self.along[k] - 0.5 * component * component
        };
        self.values.iter().enumerate().map(part).added()
    }
}

/// The singular values of the matrix of weighted derivatives, its right singular vectors as columns, and the components of the weighted residuals
/// along the left singular vectors. Each of the three lists has one entry for every parameter.
pub(super) fn singular(
    jacobian: &DMatrix<f64>,
    residuals: &[f64],
    weights: &[f64],
) -> (Vec<f64>, DMatrix<f64>, Vec<f64>) {
    let columns = jacobian.ncols();
    let rows = jacobian.nrows();
    let weighted = |i: usize, x: f64| if i < weights.len() { weights[i] * x } else { 0.0 };
    let matrix = matrix_of(rows, columns, &|i, j| weighted(i, jacobian[(i, j)]));
    let right = vector_of(rows, &|i| weighted(i, residuals.get(i).copied().unwrap_or(0.0)));
    let parts = Singular::new(&matrix);
    let along = parts.along(&right);
    (parts.values, parts.right, along)
}
