//! Searches for further fits of the parameters to the observations, in which other contacts slip first. A parameter is a number of the grasp that is
//! sought, such as a coefficient of friction. An observation is a load or angle at which slip was observed. The loss is the function of the residuals
//! that a fit minimises; scatter is the standard deviation of observations.
//!
//! The predicted load is that of the contact that slips first. At parameters for which two contacts slip together, it therefore has a kink as a
//! function of the parameters. On each side of the kink the load depends on the data of one contact alone. A search from one side usually ends at the
//! kink. An assignment says on which parameters the predicted load of each observation depends. To find other assignments, two parameters exchange
//! their values and the search starts anew.

use core::f64::consts::LN_2;

use nalgebra::DMatrix;

use super::answer::{Estimate, Identified};
use super::fit::{FitEnd, Fitted, fitted_from, rank};
use super::model::{Linear, Model};
use super::spread::identified;
use super::tolerances::INDISTINCT;
use crate::error::Error;
use crate::numerics::{Each, IntoList, any_index, chosen, every_index, two_sided};
use crate::prelude::*;

/// Upper limit of the number of pairs of parameters that exchange their values, starting from one fit. It is enough for all pairs of five parameters.
const MOST_PAIRS: usize = 10;
/// Number of values that are tried for the smaller of two parameters after they have exchanged their values. The first is the exchanged value itself.
/// Each further one is half of the value before, down to a sixteenth.
const MOST_HALVINGS: u8 = 5;
/// Upper limit of the number of bisections between two sets of values of the parameters with different assignments. The bisections seek a third
/// assignment of observations to the parameters on which their predicted loads depend.
const MOST_BISECTIONS: usize = 4;
/// Upper limit of the number of fits (local minima of the loss) that are kept, to limit the work.
const MOST_FITS: usize = 12;
/// Upper limit, to limit the work, of the number of predictions in the search for other assignments. Each predicts all observations, with other
/// values of the parameters.
const MOST_LOOKS: usize = 240;

/// If two contacts slip at once, for example at equal friction, the predicted loads have a kink as functions of the parameters, and no derivatives.
/// To find the derivatives next to this kink, the logarithm of one parameter is changed by this step.
const BESIDE_A_KINK: f64 = 1e-3;

/// The search for other assignments (of observations to the parameters on which their predicted loads depend). From each fit found, pairs of
/// parameters exchange their values again.
struct Assignments<'a> {
    model: &'a Model<'a>,
    fits: Vec<Fitted>,
    looks: usize,
}

impl Assignments<'_> {
    /// Predicts all observations, and their derivatives with respect to the parameters, for parameters with the logarithms `logs`. `None` if the
    /// model predicts no slip for some observation, or a limit of the work is reached.
    fn evaluate(&mut self, logs: &[f64]) -> Result<Option<Linear>, Error> {
        if self.looks == MOST_LOOKS || self.fits.len() == MOST_FITS {
            return Ok(None);
        }
        self.looks += 1;
        Ok(self.model.linear(logs)?.ok())
    }

    fn is_known(&self, linear: &Linear) -> bool {
        self.fits.iter().any(|fit| fit.linear.as_ref().is_some_and(|known| same_assignment(known, linear)))
    }

    /// Starts a search for a fit from the logarithms `begin` of the parameters, if the assignment there is new. Keeps the fit if its assignment is
    /// new, too. Returns whether the assignment at `begin` is new.
    fn fit(&mut self, begin: Vec<f64>, linear: Linear) -> Result<bool, Error> {
        if self.is_known(&linear) {
            return Ok(false);
        }
        let fit = fitted_from(self.model, begin, linear)?;
        let is_new = fit.linear.as_ref().is_some_and(|linear| !self.is_known(linear));
        if matches!(fit.end, FitEnd::Converged) && is_new {
            self.fits.push(fit);
        }
        Ok(true)
    }

    /// Searches by bisection between the points `low` and `high` (logarithms of the parameters) for a third assignment of observations to parameters.
    /// If bisection finds one, a search for a fit starts there. From `low` to `high` one parameter decreases, so that one predicted load after
    /// another begins to depend on it.
    fn between(&mut self, mut low: Vec<f64>, mut high: Vec<f64>, ends: [&Linear; 2]) -> Result<(), Error> {
        for _ in 0..MOST_BISECTIONS {
            let middle: Vec<f64> = low.iter().zip(&high).map(|(a, b)| 0.5 * (a + b)).list();
            let Some(linear) = self.evaluate(&middle)? else { break };
            if same_assignment(&linear, ends[0]) {
                low = middle;
            } else if same_assignment(&linear, ends[1]) {
                high = middle;
            } else {
                self.fit(middle, linear)?;
                break;
            }
        }
        Ok(())
    }

    /// Exchanges the values of two parameters of the fit at index `at`. Then halves the smaller one until the assignment of observations to
    /// parameters is one not found before. Starts searches for fits from the values reached.
    fn weaken(&mut self, at: usize, pair: (usize, usize)) -> Result<(), Error> {
        let Some(mut before) = self.fits[at].linear.clone() else { return Ok(()) };
        let mut from = self.fits[at].logs.clone();
        for halved in 0..MOST_HALVINGS {
            let begin = weakened(self.model, &self.fits[at].logs, pair, halved);
            let Some(linear) = self.evaluate(&begin)? else { break };
            if changes_in_steps(&before, &linear) {
                self.between(from, begin.clone(), [&before, &linear])?;
            }
            if self.fit(begin.clone(), linear.clone())? {
                break;
            }
            (from, before) = (begin, linear);
        }
        Ok(())
    }
}

/// The answer: the best fit, and the estimates for all assignments of observations to parameters that fit equally well.
pub(super) fn assigned(model: &Model<'_>, first: Fitted) -> Result<Identified, Error> {
    let mut search = Assignments { model, fits: vec![first], looks: 0 };
    let mut at = 0;
    while at < search.fits.len() {
        for (i, j) in pairs(model, &search.fits[at])? {
            for pair in [(i, j), (j, i)] {
                search.weaken(at, pair)?;
            }
        }
        at += 1;
    }
    let mut fits = search.fits;
    if fits.len() == 1 {
        return Ok(identified(model, &fits[0]));
    }
    let best =
        (1..fits.len()).fold(0, |best, k| if fits_better(model, &fits[k], &fits[best]) { k } else { best });
    fits.swap(0, best);
    let (best, others) = fits.split_at(1);
    let mut as_good: Vec<&Fitted> = vec![&best[0]];
    as_good.extend(others.iter().filter(|other| !fits_better(model, &best[0], other)));
    // A fit at which two contacts slip at once lies on the kink between two assignments. Such fits are discarded if at least two equally good fits do
    // not lie on a kink.
    let mut beside: Vec<&Fitted> = Vec::new();
    for fit in &as_good {
        let mut is_on_a_kink = false;
        for (i, j) in pairs_of(model) {
            is_on_a_kink = is_on_a_kink || is_on_the_kink(model, fit, i, j)?;
        }
        if !is_on_a_kink {
            beside.push(fit);
        }
    }
    if beside.len() > 1 {
        as_good = beside;
    }
    let mut answers = as_good.into_iter().map(|fit| identified(model, fit));
    let Some(first) = answers.next() else { return Ok(identified(model, &best[0])) };
    Ok(united(first, &answers.list()))
}

/// The logarithms of the parameters of a fit after two of them have exchanged values. The parameter `strong` gets the larger value. The parameter
/// `weak` gets the smaller value, divided by 2 to the power `halved`.
fn weakened(model: &Model<'_>, logs: &[f64], (weak, strong): (usize, usize), halved: u8) -> Vec<f64> {
    let unknowns = &model.asked.unknowns;
    let (low, high) = (logs[weak].min(logs[strong]), logs[weak].max(logs[strong]));
    let mut begin = logs.to_vec();
    begin[strong] = high;
    begin[weak] = low;
    for k in chosen(begin.len(), &|k| *k != weak) {
        // If a third parameter, of the same kind as `weak`, equals the smaller of the two values, it is doubled. Otherwise its contact would slip
        // together with the contact of `weak`.
        if (begin[k] - low).abs() <= INDISTINCT && unknowns[k].kind == unknowns[weak].kind {
            begin[k] = low + LN_2;
        }
    }
    begin[weak] -= f64::from(halved) * LN_2;
    begin
}

/// All pairs of parameters of the same kind, such as two coefficients of friction, as indices.
fn pairs_of(model: &Model<'_>) -> Vec<(usize, usize)> {
    let unknowns = &model.asked.unknowns;
    let mut pairs = Vec::new();
    for j in 0..unknowns.len() {
        for i in 0..j {
            if unknowns[i].kind == unknowns[j].kind {
                pairs.push((i, j));
            }
        }
    }
    pairs
}

/// At most ten pairs ([`MOST_PAIRS`]) of parameters whose exchange may lead to another assignment. A pair is listed if some predicted load depends on
/// one of its parameters and not on the other, while none depends on both.
///
/// An observation whose predicted load depends on both tells the two parameters apart, if the observations determine all parameters. If they leave
/// some parameter undetermined, the pair is listed all the same. A pair is listed, too, if the fit ended on a kink of the predicted loads where both
/// parameters are equal.
fn pairs(model: &Model<'_>, fit: &Fitted) -> Result<Vec<(usize, usize)>, Error> {
    let mut pairs = Vec::new();
    let Some(linear) = fit.linear.as_ref().filter(|_| matches!(fit.end, FitEnd::Converged)) else {
        return Ok(pairs);
    };
    let is_open = rank(linear) < fit.logs.len();
    for (i, j) in pairs_of(model) {
        let on = |row: usize| [i, j].each(|k| depends(&linear.jacobian, row, k));
        let mut rows = 0..model.asked.slips.len();
        let on_one = rows.clone().any(|row| on(row)[0] != on(row)[1]);
        let is_ambiguous = on_one && (is_open || !rows.any(|row| on(row) == [true; 2]));
        if pairs.len() < MOST_PAIRS && (is_ambiguous || is_on_the_kink(model, fit, i, j)?) {
            pairs.push((i, j));
        }
    }
    Ok(pairs)
}

/// Whether the fit is on a kink of the predicted loads, at which these two parameters are equal. On the kink a predicted load depends on both
/// parameters, because its derivative is the mean of one-sided derivatives. Next to the kink it depends on one of the two.
fn is_on_the_kink(model: &Model<'_>, fit: &Fitted, i: usize, j: usize) -> Result<bool, Error> {
    let Some(linear) = &fit.linear else { return Ok(false) };
    let on_both = |row: usize| depends(&linear.jacobian, row, i) && depends(&linear.jacobian, row, j);
    if (fit.logs[i] - fit.logs[j]).abs() > INDISTINCT || !any_index(linear.jacobian.nrows(), &on_both) {
        return Ok(false);
    }
    let mut beside = fit.logs.clone();
    beside[i] -= BESIDE_A_KINK;
    Ok(!model.linear(&beside)?.is_ok_and(|beside| same_assignment(linear, &beside)))
}

/// Whether the prediction in this row of the Jacobian depends on a parameter, beyond rounding.
fn depends(jacobian: &DMatrix<f64>, row: usize, unknown: usize) -> bool {
    jacobian[(row, unknown)].abs() > INDISTINCT * jacobian.row(row).amax()
}

/// Whether each predicted load, and each known sum of parameters, depends on the same parameters at both points.
fn same_assignment(one: &Linear, other: &Linear) -> bool {
    every_index(one.jacobian.nrows(), &|row| depends_alike(one, other, row))
}

fn depends_alike(one: &Linear, other: &Linear, row: usize) -> bool {
    every_index(one.jacobian.ncols(), &|j| depends(&one.jacobian, row, j) == depends(&other.jacobian, row, j))
}

/// Whether at least two predicted loads with different derivatives depend on other parameters at one point than at the other. On the way from one
/// point to the other these loads need not change together, so a third assignment may lie between the two points.
fn changes_in_steps(one: &Linear, other: &Linear) -> bool {
    let rows = chosen(one.jacobian.nrows(), &|row| !depends_alike(one, other, *row));
    let Some((&first, rows)) = rows.split_first() else { return false };
    let is_of_another_kind =
        |linear: &Linear, row: usize| linear.jacobian.row(row) != linear.jacobian.row(first);
    rows.iter().any(|row| is_of_another_kind(one, *row) || is_of_another_kind(other, *row))
}

/// Whether a fit has a smaller loss than another fit by more than the scatter of observations explains, at 95 %. `false` if the other fit predicts
/// all observations exactly, since no fit is better than that.
fn fits_better(model: &Model<'_>, one: &Fitted, other: &Fitted) -> bool {
    let unknowns = model.asked.unknowns.len();
    let degrees = one.linear.as_ref().map_or(1, |here| here.residuals.len().saturating_sub(unknowns).max(1));
    let degrees = one.scatter.is_estimated.then_some(degrees as f64);
    gain(model, one, other) > 0.5 * two_sided(0.95, degrees).powi(2)
}

/// The loss of the second fit minus the loss of the first, for residuals divided by the standard deviations of the first fit. 0 if the second fit
/// predicts all observations exactly. Infinite if the second fit does not predict all observations, and -∞ if the first does not.
pub(super) fn gain(model: &Model<'_>, one: &Fitted, other: &Fitted) -> f64 {
    match (&one.linear, &other.linear) {
        (None, _) => f64::NEG_INFINITY,
        (_, None) => f64::INFINITY,
        (_, Some(there)) if there.residuals.iter().all(|r| r.abs() <= INDISTINCT) => 0.0,
        (Some(here), Some(there)) => {
            model.loss(&there.residuals, &one.scatter) - model.loss(&here.residuals, &one.scatter)
        }
    }
}

/// The answer `answer` with the estimates of the fits `others`, which fit equally well. A parameter on which the fits disagree becomes undetermined.
fn united(mut answer: Identified, others: &[Identified]) -> Identified {
    if others.is_empty() {
        return answer;
    }
    let mut all = vec![answer.estimates.clone()];
    others.iter().map(|other| other.estimates.clone()).append_to(&mut all);
    for (j, estimate) in answer.estimates.iter_mut().enumerate() {
        if !all.iter().all(|other| is_alike(&all[0][j], &other[j])) {
            estimate.is_fixed = false;
            (estimate.standard_error, estimate.interval, estimate.degrees_of_freedom) = (None, None, None);
        }
    }
    let is_free = |of: &Identified, unknowns: &[String]| of.free.iter().any(|free| free.unknowns == unknowns);
    answer.free.retain(|free| others.iter().all(|other| is_free(other, &free.unknowns)));
    answer.assignments = all;
    answer
}

/// Whether two fits agree on a parameter. They agree if the observations determine it in neither fit. If the observations determine it in both, the
/// estimates may differ by a tenth of the standard error. Without a known standard error they may differ by rounding only.
pub(super) fn is_alike(one: &Estimate, other: &Estimate) -> bool {
    let error = one.standard_error.unwrap_or(INDISTINCT * one.value);
    one.is_fixed == other.is_fixed && (!one.is_fixed || (one.value - other.value).abs() <= 0.1 * error)
}
