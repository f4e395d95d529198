//! The search for a sufficient amount (of squeeze, friction, load, arm or angle) between amounts that turned out to be insufficient: the grasp does
//! not meet the demand with them. A demand is, for example, that the object is held. The carried part (or fraction) of the load is the load factor up
//! to which the demand is met. At rest means before the loads of the question act. A drive is the spring of a joint or tendon of a hand, with its
//! force limit.

use super::search::{SearchPlan, TrialFunctions};
use super::tolerances::{FAR_FROM_START, LAST_DIGITS, NARROW, NEAR_DOUBLINGS};
use super::trial::Trial;
use crate::error::Error;
use crate::numerics::{increasing, moved, picked, sort_by_number};
use crate::prelude::*;

/// Searches for a sufficient amount between the insufficient amounts in `vain`. The search starts near the amount with which most of the load is
/// carried. Then it divides the widest of the intervals between tried amounts, again and again. Only intervals between 1/16 and 16 times `begin`, the
/// first amount of the whole search, are divided.
pub(super) fn refined(
    tries: TrialFunctions<'_>,
    plan: &SearchPlan,
    begin: f64,
    vain: &mut Vec<(f64, Trial)>,
) -> Result<Option<(f64, Trial)>, Error> {
    if let Some(sufficient) = where_most_is_carried(tries, vain)? {
        return Ok(Some(sufficient));
    }
    let near = |at: f64| begin / FAR_FROM_START <= at && at <= begin * FAR_FROM_START && plan.contains(at);
    // The range from 1/16 to 16 times `begin` ([`FAR_FROM_START`] is 16) consists of eight doublings, so 16 trials put two amounts into each
    // doubling. With fewer trials narrow intervals of sufficient amounts are missed.
    for _ in 0..4 * NEAR_DOUBLINGS {
        let mut amounts = picked(vain, &|(at, _)| Some(*at).filter(|at| near(*at)));
        sort_by_number(&mut amounts, &|at| *at);
        let ratio = |pair: &[f64]| pair[1] / pair[0];
        let Some(widest) = amounts.windows(2).max_by(|a, b| ratio(a).total_cmp(&ratio(b))) else { break };
        let at = (widest[0] * widest[1]).sqrt();
        let trial = tries.at(at)?;
        if trial.is_sufficient() {
            return Ok(Some((at, trial)));
        }
        vain.push((at, trial));
    }
    Ok(None)
}

/// A golden-section search for the amount that carries the largest fraction of the load, around the best amount so far. While contacts and drives
/// keep their states, contact forces are linear in squeeze and load. As friction cones are convex, the carried fraction is then a concave function of
/// the squeeze. Thus the search can end once chords of this function prove that its maximum is below 1.
fn where_most_is_carried(
    tries: TrialFunctions<'_>,
    vain: &mut Vec<(f64, Trial)>,
) -> Result<Option<(f64, Trial)>, Error> {
    let known = vain.iter().filter_map(|(at, trial)| Some((*at, trial.nearness()?)));
    let (amounts, carried): (Vec<f64>, Vec<f64>) = known.unzip();
    let in_order: Vec<_> = moved(increasing(&amounts), &|i| (amounts[i], carried[i]));
    let carries_most = |i: &usize, j: &usize| in_order[*i].1.total_cmp(&in_order[*j].1);
    let Some(best) = (0..in_order.len()).max_by(carries_most) else { return Ok(None) };
    // If all amounts carry the same fraction of the load, it is unknown whether larger or smaller amounts carry more.
    if in_order.iter().all(|(_, carried)| *carried == in_order[best].1) {
        return Ok(None);
    }
    let mut ends = [best.saturating_sub(1), (best + 1).min(in_order.len() - 1)].map(|k| in_order[k]);
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let between = |from: f64, to: f64| from * (to / from).powf(golden);
    let [low, high] = ends.map(|(at, _)| at);
    let mut inner = [between(high, low), between(low, high)];
    let mut parts = [None; 2];
    // Each section keeps 0.618 of the interval of logarithms, so 40 sections leave 4e-9 of it. With fewer, narrow intervals of sufficient amounts are
    // missed.
    for _ in 0..40 {
        for k in 0..2 {
            if parts[k].is_none() {
                let trial = tries.at(inner[k])?;
                if trial.is_sufficient() {
                    return Ok(Some((inner[k], trial)));
                }
                parts[k] = Some(trial.nearness().unwrap_or(f64::NEG_INFINITY));
                vain.push((inner[k], trial));
            }
        }
        let [(low, at_low), (high, at_high)] = ends;
        let [one, other] = parts.map(|part| part.unwrap_or(f64::NEG_INFINITY));
        // The carried fraction as a concave function of the amount lies below the extensions of its chords, so `most` is an upper bound of its
        // maximum between the ends.
        let gap = inner[1] - inner[0];
        let slope = (other - one) / gap;
        let before = one + (-slope).max(0.0) * (inner[0] - low);
        let beyond = other + slope.max(0.0) * (high - inner[1]);
        let rising = one + (one - at_low) / (inner[0] - low) * gap;
        let falling = other + (other - at_high) / (high - inner[1]) * gap;
        let most = before.max(beyond).max(rising.min(falling));
        // A negative value of `one` or `other` is not a carried fraction of the load: the object moves too far already at rest. The search then ends
        // once the interval is narrower than [`NARROW`] (1 %). Otherwise it ends if the carried fraction is below 1 everywhere in the interval.
        let is_known = if one.min(other) < 0.0 { high <= low * (1.0 + NARROW) } else { most < 1.0 };
        if high - low <= LAST_DIGITS * high || slope.is_finite() && is_known {
            break;
        }
        if one < other {
            ends[0] = (inner[0], one);
            (inner, parts) = ([inner[1], between(inner[0], high)], [parts[1], None]);
        } else {
            ends[1] = (inner[1], other);
            (inner, parts) = ([between(inner[1], low), inner[0]], [None, parts[0]]);
        }
    }
    Ok(None)
}
