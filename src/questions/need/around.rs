//! A scan of amounts around a bound: how far amounts beyond it suffice, and which other amounts do.

use super::answer::AmountWindow;
use super::search::{SearchPlan, Tries};
use super::threshold::Threshold;
use super::tolerances::{BETWEEN, BETWEEN_STATES};
use super::trial::Trial;
use crate::error::Error;
use crate::numerics::{increasing, mapped, moved};
use crate::prelude::*;

/// The result of a scan around a bound.
#[derive(Debug)]
pub(super) struct Around {
    /// Number of changes of verdict, the bound included.
    pub(super) changes: usize,
    /// Far end of the sufficient amounts that begin at the bound; `None` if all scanned ones suffice.
    pub(super) until: Option<Threshold>,
    /// Windows of other sufficient amounts.
    pub(super) elsewhere: Vec<AmountWindow>,
}

impl SearchPlan {
    /// `count` amounts beyond `from`, upwards or downwards, inside the range that forces can balance. With `coarse` the list also has the amount at a
    /// ratio of 16 to `from`.
    fn scanned(&self, from: f64, up: bool, count: usize, coarse: bool) -> Vec<f64> {
        // The k-th of n amounts is at the ratio 4^((k/n)³). A larger ratio scans more coarsely near the start.
        let fine = (1..=count).map(|k| 4.0_f64.powf((k as f64 / count as f64).powi(3)));
        // A drive may reach its limit only at a far larger squeeze or force, which a ratio of 4 would miss.
        let coarse = (coarse && count > 0).then_some(16.0);
        let parts = fine.chain(coarse).map(|part| if up { from * part } else { from / part });
        parts.filter(|amount| self.contains(*amount)).collect()
    }

    /// Amounts just inside and outside an end of the statics range; none without that end.
    fn at_the_end(&self, up: bool) -> Vec<f64> {
        let end = |end: f64| {
            // With a smaller offset than the error of the end, both amounts could fall on one side of it.
            let off = 1e-8;
            [1.0 - off, 1.0 + off].map(|part| if up { end * part } else { end / part })
        };
        self.end(up).map_or(Vec::new(), |at| end(at).to_vec())
    }
}

impl Around {
    /// Tries `scan` amounts on both sides of a bound, beside those `known`, inside the range that forces can balance. With `far` the scan also tries
    /// the amount at a ratio of 16 to the bound.
    pub(super) fn of(
        bound: &Threshold,
        scan: usize,
        far: bool,
        plan: &SearchPlan,
        known: &[(f64, Trial)],
        tries: Tries<'_>,
    ) -> Result<Self, Error> {
        let mut around = Self { changes: 1, until: None, elsewhere: Vec::new() };
        if plan.is_monotone {
            return Ok(around);
        }
        let half = scan / 2;
        for (up, count) in [(false, half), (true, scan - half)] {
            let is_beyond = up == plan.is_least;
            let mut amounts = plan.scanned(bound.does, up, count, far && is_beyond);
            amounts.extend(plan.at_the_end(up).into_iter().filter(|_| is_beyond));
            if scan > 0 {
                amounts.extend(mapped(known, &|(at, _)| *at));
            }
            in_order(&mut amounts, up);
            let from = if is_beyond {
                (bound.does, None)
            } else {
                (bound.does_not.0, Some(bound.does_not.1.clone()))
            };
            around.side(from, up, is_beyond, &amounts, tries)?;
        }
        let lows: Vec<f64> = mapped(&around.elsewhere, &low);
        around.elsewhere = moved(increasing(&lows), &|i| around.elsewhere[i]);
        Ok(around)
    }

    /// The far end of the sufficient amounts, in the case that all amounts as far as `to` suffice. The search for it goes from `to` back through the
    /// known amounts, then through `scan` amounts beyond the first one of the search.
    pub(super) fn far_end(
        to: f64,
        scan: usize,
        plan: &SearchPlan,
        known: &[(f64, Trial)],
        tries: Tries<'_>,
    ) -> Result<Option<Threshold>, Error> {
        let mut around = Self { changes: 0, until: None, elsewhere: Vec::new() };
        let up = plan.is_least;
        let mut amounts: Vec<f64> = mapped(known, &|(at, _)| *at);
        amounts.extend(plan.at_the_end(up));
        // If every larger amount carries the load, a far one only shows whether the part moves too far.
        let count = if plan.is_monotone { scan.min(1) } else { scan };
        amounts.extend(plan.scanned(plan.begin(), up, count, true));
        in_order(&mut amounts, up);
        around.side((to, None), up, true, &amounts, tries)?;
        Ok(around.until)
    }

    /// Tries `amounts` in order on one side of the bound and narrows each change of verdict. A start without a trial is a sufficient amount. Undecided
    /// amounts are skipped.
    fn side(
        &mut self,
        (mut at, mut trial): (f64, Option<Trial>),
        up: bool,
        mut is_bounds_own: bool,
        amounts: &[f64],
        tries: Tries<'_>,
    ) -> Result<(), Error> {
        let mut window = None;
        for &amount in amounts {
            if (amount > at) != up {
                continue;
            }
            let now = tries.at(amount)?;
            let (did, does) = (trial.as_ref().is_none_or(Trial::does), now.does());
            if let Trial::Unknown(_) = now {
                continue;
            }
            if did != does {
                self.changes += 1;
                // Each narrowing costs a search, so further changes of verdict are only counted.
                if self.changes <= 8 {
                    let (inner, outer) = ((at, trial.clone()), (amount, Some(now.clone())));
                    let (does, does_not) = if did { (inner, outer) } else { (outer, inner) };
                    let measures = does.1.map_or([None; 2], |trial| trial.measures());
                    let Some(does_not) = does_not.1.map(|trial| (does_not.0, trial)) else { continue };
                    let edge = Threshold { does: does.0, does_not, unknown: None }.beside(tries, measures)?;
                    match (did, is_bounds_own) {
                        (true, true) => (self.until, is_bounds_own) = (Some(edge), false),
                        (true, false) => {
                            self.elsewhere
                                .extend(window.take().map(|near| between(near, Some(edge.does), up)));
                        }
                        (false, _) => window = Some(edge.does),
                    }
                }
            }
            (at, trial) = (amount, Some(now));
        }
        self.elsewhere.extend(window.map(|near| between(near, None, up)));
        Ok(())
    }
}

/// Tries [`BETWEEN`] amounts at most between those `known`: each in the middle of the widest two neighbours that have the same verdict, but whose
/// contacts rest in different states. Along the amount the state at rest is smooth while contacts keep their states; where these change, the carried
/// part may jump. Neighbours of which both carry far more than the load are left out. Returns whether one of the amounts has the other verdict.
pub(super) fn between_states(
    known: &[(f64, Trial)],
    is_claimed: &dyn Fn(f64) -> bool,
    tries: Tries<'_>,
) -> Result<bool, Error> {
    let mut list: Vec<(f64, Trial)> = known.iter().filter(|(at, _)| is_claimed(*at)).cloned().collect();
    let mut is_new = false;
    for _ in 0..BETWEEN {
        list.sort_by(|one, other| one.0.total_cmp(&other.0));
        let differ = |pair: &&[(f64, Trial)]| {
            let [(one, trial), (other, next)] = [&pair[0], &pair[1]];
            let [Some(carried), Some(by_next)] = [trial.carried(), next.carried()] else { return false };
            let is_same = trial.does() == next.does() && carried.min(by_next).is_finite();
            is_same && *other > one * BETWEEN_STATES && (tries.rests_otherwise)(*one, *other)
        };
        let ratio = |pair: &&[(f64, Trial)]| pair[1].0 / pair[0].0;
        let widest = list.windows(2).filter(differ).max_by(|a, b| ratio(a).total_cmp(&ratio(b)));
        let Some([(one, trial), (other, _)]) = widest else { break };
        let (at, did) = ((one * other).sqrt(), trial.does());
        let now = tries.at(at)?;
        is_new |= now.carried().is_some() && now.does() != did;
        list.push((at, now));
    }
    Ok(is_new)
}

/// Sorts amounts, in ascending order if `up`, else in descending order.
fn in_order(amounts: &mut [f64], up: bool) {
    amounts.sort_by(f64::total_cmp);
    if !up {
        amounts.reverse();
    }
}

fn between(near: f64, far: Option<f64>, up: bool) -> AmountWindow {
    if up { AmountWindow { from: Some(near), to: far } } else { AmountWindow { from: far, to: Some(near) } }
}

fn low(window: &AmountWindow) -> f64 {
    window.from.unwrap_or(0.0)
}
