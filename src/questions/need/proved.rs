//! Answers of a [`Need`](super::Need) that follow from proofs that no contact forces balance the loads. Such proofs exclude all amounts, all but one,
//! or all beyond the last sufficient one. An amount (of squeeze, friction, load, arm or angle) is sufficient if the grasp meets the demand with it,
//! e.g. holds the object.

use super::answer::{Amount, FarEnd};
use super::needed::nothing_suffices;
use super::search::{SearchPlan, TrialFunctions};
use super::threshold::Threshold;
use super::trial::Trial;
use crate::error::Error;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::prelude::*;

/// The answer if proofs exclude all amounts, or all but one that is sufficient; `None` otherwise.
pub(super) fn by_proof(plan: &SearchPlan, tries: TrialFunctions<'_>) -> Result<Option<Amount>, Error> {
    let only = only_amount(plan, tries)?;
    if only.is_some() || !plan.range.is_empty {
        return Ok(only);
    }
    let trial = tries.at(plan.start)?;
    Ok(Some(nothing_suffices(vec![(plan.start, trial)], plan.limits, Some(&plan.range))))
}

/// The answer if proofs exclude all amounts but one, and this one is sufficient; `None` otherwise. An amount within rounding of 1 is taken as exactly
/// 1: if amounts are multiples, 1 stands for the given squeeze or load, without rounding.
fn only_amount(plan: &SearchPlan, tries: TrialFunctions<'_>) -> Result<Option<Amount>, Error> {
    let Some(only) = plan.range.point() else { return Ok(None) };
    let sufficient = if (only - 1.0).abs() <= NEGLIGIBLE { 1.0 } else { only };
    if !tries.at(sufficient)?.is_sufficient() {
        return Ok(None);
    }
    let otherwise = "no forces of the contacts balance the load".to_owned();
    let end = |way: f64| sufficient * (1.0 + way * NEGLIGIBLE);
    let beyond = FarEnd {
        sufficient,
        insufficient: end(1.0),
        otherwise,
        presses: Vec::new(),
        at_their_limit: Vec::new(),
    };
    Ok(Some(Amount::Bound {
        sufficient,
        insufficient: end(-1.0),
        otherwise: beyond.otherwise.clone(),
        is_too_far: false,
        unknown: None,
        changes: 2,
        until: Some(beyond),
        elsewhere: Vec::new(),
        presses: Vec::new(),
        at_their_limit: Vec::new(),
        tried: None,
    }))
}

/// The bracket (a sufficient amount and its insufficient neighbour) at the end of the range of amounts, if all tried amounts are sufficient. Beyond
/// this end a proof shows that no contact forces balance the loads. The argument `to` is the last amount tried; it is the sufficient amount of the
/// bracket. `None` if this amount is not at the end of the range, or if its neighbour is not found insufficient.
pub(super) fn at_proved_end(
    to: f64,
    plan: &SearchPlan,
    tries: TrialFunctions<'_>,
) -> Result<Option<Threshold>, Error> {
    let (end, outwards) = if plan.is_least { (plan.range.low, -1.0) } else { (plan.range.high, 1.0) };
    // If the last amount tried, `to`, is this near to the end of the range, the two agree up to rounding.
    let Some(end) = end.filter(|end| (end - to).abs() <= NEGLIGIBLE * to) else { return Ok(None) };
    let beyond = end * (1.0 + outwards * NEGLIGIBLE);
    let trial = tries.at(beyond)?;
    let refuted = matches!(trial, Trial::Insufficient { .. });
    Ok(refuted.then_some(Threshold { sufficient: to, insufficient: (beyond, trial), unknown: None }))
}
