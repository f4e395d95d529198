//! Fits in which contacts slip in another order.
//!
//! Where several contacts may slip first, a predicted slip has a kink: on each side it depends on the data of one contact alone. A search ends on the side on
//! which it began. The side is the assignment of slips to unknowns: those on which each slip depends. Other sides are searched from unknowns that change places.

use core::f64::consts::LN_2;

use nalgebra::DMatrix;

use super::answer::{Estimate, Identified};
use super::fit::{FitEnd, Fitted, fitted_from};
use super::model::{Linear, Model};
use super::spread::told;
use super::tolerances::INDISTINCT;
use crate::error::Error;
use crate::numerics::two_sided;
use crate::prelude::*;

/// Most pairs of unknowns that change places: all pairs of five.
const MOST_PAIRS: usize = 10;
/// Most halvings of an unknown until other slips depend on it: to a sixteenth.
const MOST_HALVINGS: u8 = 5;

/// The answer of the best fit, with the estimates of all assignments that fit as well.
pub(super) fn assigned(model: &Model<'_>, first: Fitted) -> Result<Identified, Error> {
    let mut fits = vec![first];
    for (i, j) in pairs(model, &fits[0]) {
        for (weak, strong) in [(i, j), (j, i)] {
            for halved in 0..MOST_HALVINGS {
                let begin = weakened(model, &fits[0].logs, (weak, strong), halved);
                let is_new = |linear: &Linear| {
                    let is_known = |fit: &Fitted| {
                        fit.linear.as_ref().is_some_and(|known| same_assignment(known, linear))
                    };
                    !fits.iter().any(is_known)
                };
                let Ok(linear) = model.linear(&begin)? else { break };
                if !is_new(&linear) {
                    continue;
                }
                let fit = fitted_from(model, begin, linear)?;
                if matches!(fit.end, FitEnd::Converged) && fit.linear.as_ref().is_some_and(is_new) {
                    fits.push(fit);
                }
                break;
            }
        }
    }
    if fits.len() == 1 {
        return Ok(told(model, &fits[0]));
    }
    let best =
        (1..fits.len()).fold(0, |best, k| if fits_better(model, &fits[k], &fits[best]) { k } else { best });
    fits.swap(0, best);
    let (best, others) = fits.split_at(1);
    let mut as_good: Vec<&Fitted> = vec![&best[0]];
    as_good.extend(others.iter().filter(|other| !fits_better(model, &best[0], other)));
    // A fit from which two contacts slip at once stands on the kink between two assignments.
    let is_on_a_kink = |fit: &Fitted| pairs_of(model).iter().any(|(i, j)| is_on_the_kink(fit, *i, *j));
    let beside: Vec<&Fitted> = as_good.iter().copied().filter(|fit| !is_on_a_kink(fit)).collect();
    if beside.len() > 1 {
        as_good = beside;
    }
    let mut answers = as_good.into_iter().map(|fit| told(model, fit));
    let Some(first) = answers.next() else { return Ok(told(model, &best[0])) };
    Ok(united(first, &answers.collect::<Vec<_>>()))
}

/// The logarithms in which two unknowns have changed places: `weak` has the smaller value, divided by 2 to the power `halved`.
fn weakened(model: &Model<'_>, logs: &[f64], (weak, strong): (usize, usize), halved: u8) -> Vec<f64> {
    let unknowns = &model.asked.unknowns;
    let (low, high) = (logs[weak].min(logs[strong]), logs[weak].max(logs[strong]));
    let mut begin = logs.to_vec();
    begin[strong] = high;
    begin[weak] = low;
    for k in (0..begin.len()).filter(|k| *k != weak) {
        // What is as weak would slip together with the weak one.
        if (begin[k] - low).abs() <= INDISTINCT && unknowns[k].kind == unknowns[weak].kind {
            begin[k] = low + LN_2;
        }
    }
    begin[weak] -= f64::from(halved) * LN_2;
    begin
}

/// All pairs of unknowns of one kind.
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

/// Pairs of which a slip depends on one, and none on both; or between which the fit ended on a kink. Slips that depend on both tell them apart on either side.
fn pairs(model: &Model<'_>, fit: &Fitted) -> Vec<(usize, usize)> {
    let Some(linear) = fit.linear.as_ref().filter(|_| matches!(fit.end, FitEnd::Converged)) else {
        return Vec::new();
    };
    let count = |i: usize, j: usize, row: usize| {
        usize::from(depends(&linear.jacobian, row, i)) + usize::from(depends(&linear.jacobian, row, j))
    };
    let of_one = |i: usize, j: usize| {
        let most = (0..model.asked.slips.len()).map(|row| count(i, j, row)).max();
        most == Some(1)
    };
    let mut pairs = pairs_of(model);
    pairs.retain(|(i, j)| of_one(*i, *j) || is_on_the_kink(fit, *i, *j));
    pairs.truncate(MOST_PAIRS);
    pairs
}

/// Whether two unknowns are equal, and a slip depends on both, as on the mean of two sides of a kink.
fn is_on_the_kink(fit: &Fitted, i: usize, j: usize) -> bool {
    let Some(linear) = &fit.linear else { return false };
    let on_both = |row: usize| depends(&linear.jacobian, row, i) && depends(&linear.jacobian, row, j);
    (fit.logs[i] - fit.logs[j]).abs() <= INDISTINCT && (0..linear.jacobian.nrows()).any(on_both)
}

/// Whether a slip depends on an unknown.
fn depends(jacobian: &DMatrix<f64>, row: usize, unknown: usize) -> bool {
    jacobian[(row, unknown)].abs() > INDISTINCT * jacobian.row(row).amax()
}

/// Whether every slip depends on the same unknowns.
fn same_assignment(one: &Linear, other: &Linear) -> bool {
    let (rows, columns) = one.jacobian.shape();
    (0..rows)
        .all(|row| (0..columns).all(|j| depends(&one.jacobian, row, j) == depends(&other.jacobian, row, j)))
}

/// Whether a fit is better than another by more than scatter explains, at 95 %.
fn fits_better(model: &Model<'_>, one: &Fitted, other: &Fitted) -> bool {
    let (Some(here), Some(there)) = (&one.linear, &other.linear) else { return one.linear.is_some() };
    let degrees = here.residuals.len().saturating_sub(model.asked.unknowns.len()).max(1);
    let degrees = one.scatter.estimated.map(|_| degrees as f64);
    let gain = model.loss(&there.residuals, &one.scatter) - model.loss(&here.residuals, &one.scatter);
    let is_exact = there.residuals.iter().all(|r| r.abs() <= INDISTINCT);
    !is_exact && gain > 0.5 * two_sided(0.95, degrees).powi(2)
}

/// An answer with the estimates of others that fit as well; what they do not agree on is not fixed.
fn united(mut answer: Identified, others: &[Identified]) -> Identified {
    if others.is_empty() {
        return answer;
    }
    let mut all = vec![answer.estimates.clone()];
    all.extend(others.iter().map(|other| other.estimates.clone()));
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

/// Whether two estimates of an unknown are both fixed, and the same within a tenth of their error.
pub(super) fn is_alike(one: &Estimate, other: &Estimate) -> bool {
    let error = one.standard_error.unwrap_or(INDISTINCT * one.value);
    one.is_fixed == other.is_fixed && (!one.is_fixed || (one.value - other.value).abs() <= 0.1 * error)
}
