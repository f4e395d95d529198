//! A scan: trials of further amounts on both sides of the bound (the least or greatest sufficient amount) after a search has found it. An amount (of
//! squeeze, friction, load, arm or angle) is sufficient if the grasp meets the demand with it, e.g. holds the object. The trial of an amount gives
//! the verdict: sufficient, insufficient or undecided. At rest means under the loads that act before the loads of the question.
//!
//! Easier amounts are larger if the least amount is sought, smaller if the greatest is sought; harder amounts are the opposite. The scan finds the
//! far end, which is the last sufficient amount on the easier side of the bound, and further intervals of sufficient amounts. The carried part of the
//! load is the load factor up to which the demand is met. A bracket consists of a sufficient amount and its insufficient neighbour. A proof that
//! contact forces cannot balance the loads may exclude all amounts outside a range; an end of this range is called proved.

use super::answer::AmountWindow;
use super::search::{SearchPlan, TrialFunctions};
use super::threshold::{Threshold, where_it_vanishes};
use super::tolerances::{
    BETWEEN, BETWEEN_STATES, BEYOND_A_MARGIN, FAR_BEHIND, FAR_FROM_START, NEAR_THE_START, STEEP,
    TOWARDS_ZERO, WHERE_MARGINS_VANISH,
};
use super::trial::Trial;
use crate::error::Error;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Each, IntoList, highest, increasing, mapped, moved, numbered, picked, sort_by_number};
use crate::prelude::*;

/// The result of a scan of amounts on both sides of a bound of the sufficient amounts.
#[derive(Debug)]
pub(super) struct BoundScan {
    /// Number of changes between sufficient and insufficient from one amount of the scan to the next, including the change at the bound.
    pub(super) changes: usize,
    /// The far end of the interval of sufficient amounts that starts at the bound: the last sufficient amount and its insufficient neighbour. `None`
    /// if all amounts tried on the easier side of the bound (more squeeze, less load) are sufficient.
    pub(super) until: Option<Threshold>,
    /// Further intervals of sufficient amounts, beside the interval that starts at the bound.
    pub(super) elsewhere: Vec<AmountWindow>,
}

impl SearchPlan {
    /// The amounts to try on one side of `from`: `count` amounts above it if `up`, else below it, up to a factor of 4 away. On the harder side (less
    /// squeeze, more load) they extend only to the proved end of the range, if this end is nearer. If `coarse`, there is one more amount, 16 times as
    /// large or small as `from`. Amounts outside the range of the plan are not tried.
    fn scanned(&self, from: f64, up: bool, count: usize, coarse: bool) -> Vec<f64> {
        let to_the_end = self.end(up).filter(|_| up != self.is_least).map(|end| (end / from).max(from / end));
        let most = to_the_end.filter(|ratio| *ratio > BETWEEN_STATES).map_or(4.0, |ratio| ratio.min(4.0));
        // The k-th of n amounts has the ratio r^((k/n)³) to `from`, with r = `most`, so that amounts lie close together near the bound of the
        // sufficient amounts. With r above 4 they would be so far apart that intervals of insufficient amounts near the bound could be missed.
        let mut parts = numbered(count, &|k| most.powf(((k + 1) as f64 / count as f64).powi(3)));
        // A drive, the spring of a joint or tendon, may reach its force limit only at a far larger squeeze or force. Amounts with ratios up to 4 do
        // not show this.
        parts.extend((coarse && count > 0).then_some(16.0));
        let amount = |part: &f64| if up { from * part } else { from / part };
        picked(&parts, &|part| Some(amount(part)).filter(|amount| self.contains(*amount)))
    }

    /// `from` divided by 16, 256 and 65536 ([`TOWARDS_ZERO`]), as far as these amounts are in the range of the plan. They are tried if a greatest
    /// amount is sought, because a very small amount may be insufficient although larger ones are sufficient.
    fn towards_zero(&self, from: f64) -> Vec<f64> {
        picked(&TOWARDS_ZERO, &|ratio| Some(from / ratio).filter(|amount| self.contains(*amount)))
    }

    /// Two amounts, just inside and just outside the upper (if `up`) or lower end of the range of amounts that no proof excludes. Empty without such
    /// an end.
    fn at_the_end(&self, up: bool) -> Vec<f64> {
        let end = |end: f64| {
            // If this relative offset were smaller than the error of the proved end, both amounts could be on the same side of the true end.
            let off = 1e-8;
            [1.0 - off, 1.0 + off].each(|part| if up { end * part } else { end / part })
        };
        self.end(up).map_or(Vec::new(), |at| end(at).to_vec())
    }
}

impl BoundScan {
    /// Tries amounts on both sides of a bound of the sufficient amounts, within the range in which contact forces can balance the loads. `scan` of
    /// these amounts are new, half of them on each side; the amounts in `known` are included. One more amount, 16 times as large or as small as the
    /// bound, is tried on the harder side (less squeeze, more load), and on the easier side if `far`.
    ///
    /// On the easier side further amounts are tried. Two lie at the proved end of the range. If the first amount of the search is far easier than the
    /// bound, three ([`NEAR_THE_START`]) lie beyond this first amount. If a greatest amount is sought, three lie far below ([`TOWARDS_ZERO`]).
    /// Nothing is tried if `plan.is_monotone`: every easier amount than a sufficient one is then sufficient, too.
    pub(super) fn of(
        bound: &Threshold,
        scan: usize,
        far: bool,
        plan: &SearchPlan,
        known: &[(f64, Trial)],
        tries: TrialFunctions<'_>,
    ) -> Result<Self, Error> {
        let mut around = Self { changes: 1, until: None, elsewhere: Vec::new() };
        if plan.is_monotone {
            return Ok(around);
        }
        let half = scan / 2;
        for (up, count) in [(false, half), (true, scan - half)] {
            let is_beyond = up == plan.is_least;
            let mut amounts = plan.scanned(bound.sufficient, up, count, far || !is_beyond);
            let begin = plan.begin();
            let is_far_behind = if up {
                begin > FAR_BEHIND * bound.sufficient
            } else {
                bound.sufficient > FAR_BEHIND * begin
            };
            if is_beyond && is_far_behind && scan > 0 {
                amounts.extend(plan.scanned(begin, up, NEAR_THE_START, false));
            }
            if is_beyond && !up && scan > 0 {
                amounts.extend(plan.towards_zero(begin.min(bound.sufficient)));
            }
            amounts.extend(plan.at_the_end(up).into_iter().filter(|_| is_beyond));
            if scan > 0 {
                amounts.extend(mapped(known, &|(at, _)| *at));
            }
            in_order(&mut amounts, up);
            // If the question has a force of any direction, the easiest amount (most squeeze, least load) gets a full trial. This trial finds the
            // directions in which the force is not carried; the shorter trials of the other amounts on this side then include them.
            if let (true, true, Some(&last)) = (tries.learns, is_beyond, amounts.last()) {
                tries.at(last)?;
            }
            let from = if is_beyond {
                (bound.sufficient, None)
            } else {
                (bound.insufficient.0, Some(bound.insufficient.1.clone()))
            };
            around.side(from, up, is_beyond, &amounts, tries)?;
        }
        let lows: Vec<f64> = mapped(&around.elsewhere, &low);
        around.elsewhere = moved(increasing(&lows), &|i| around.elsewhere[i]);
        Ok(around)
    }

    /// For searches in which all amounts tried in the harder direction are sufficient, so that there is no bound: the last sufficient amount in the
    /// easier direction (more squeeze, less load) and its insufficient neighbour. `to` is the hardest amount tried. From `to` on, the `known` amounts
    /// and `scan` new amounts are tried; the new amounts are easier than the first amount of the search. `None` if all of them are sufficient.
    pub(super) fn far_end(
        to: f64,
        scan: usize,
        plan: &SearchPlan,
        known: &[(f64, Trial)],
        tries: TrialFunctions<'_>,
    ) -> Result<Option<Threshold>, Error> {
        let mut around = Self { changes: 0, until: None, elsewhere: Vec::new() };
        let up = plan.is_least;
        let mut amounts: Vec<f64> = mapped(known, &|(at, _)| *at);
        amounts.extend(plan.at_the_end(up));
        // If `is_monotone`, every easier amount (more squeeze, less load) is known to be sufficient unless motions become too large. Two amounts far
        // away, with ratios 4 and 16 to the first amount, show whether they do.
        let count = if plan.is_monotone { scan.min(1) } else { scan };
        amounts.extend(plan.scanned(plan.begin(), up, count, true));
        if !up && !plan.is_monotone && scan > 0 {
            amounts.extend(plan.towards_zero(plan.begin()));
        }
        in_order(&mut amounts, up);
        around.side((to, None), up, true, &amounts, tries)?;
        Ok(around.until)
    }

    /// Tries `amounts` in order on one side of the bound, and narrows the bracket at each change between sufficient and insufficient. The scan starts
    /// from the amount `at` with the result `trial`; `None` means that `at` is sufficient. `is_bounds_own` tells whether `at` lies in the interval of
    /// sufficient amounts that starts at the bound. Undecided amounts are skipped.
    fn side(
        &mut self,
        (mut at, mut trial): (f64, Option<Trial>),
        up: bool,
        mut is_bounds_own: bool,
        amounts: &[f64],
        tries: TrialFunctions<'_>,
    ) -> Result<(), Error> {
        let mut window = None;
        for &amount in amounts {
            if (amount > at) != up {
                continue;
            }
            let now = (tries.short)(amount)?;
            let (was_sufficient, sufficient) =
                (trial.as_ref().is_none_or(Trial::is_sufficient), now.is_sufficient());
            if let Trial::Unknown(_) = now {
                continue;
            }
            if was_sufficient != sufficient {
                self.changes += 1;
                // Narrowing a bracket costs many trials. Therefore, from the ninth change on, changes are only counted.
                if self.changes <= 8 {
                    let (inner, outer) = ((at, trial.clone()), (amount, Some(now.clone())));
                    let (sufficient, insufficient) =
                        if was_sufficient { (inner, outer) } else { (outer, inner) };
                    let measures = sufficient.1.map_or([None; 2], |trial| trial.measures());
                    let Some(insufficient) = insufficient.1.map(|trial| (insufficient.0, trial)) else {
                        continue;
                    };
                    let edge = Threshold { sufficient: sufficient.0, insufficient, unknown: None }
                        .beside(tries, measures)?;
                    match (was_sufficient, is_bounds_own) {
                        (true, true) => (self.until, is_bounds_own) = (Some(edge), false),
                        (true, false) => {
                            self.elsewhere
                                .extend(window.take().map(|near| between(near, Some(edge.sufficient), up)));
                        }
                        (false, _) => window = Some(edge.sufficient),
                    }
                }
            }
            (at, trial) = (amount, Some(now));
        }
        self.elsewhere.extend(window.map(|near| between(near, None, up)));
        Ok(())
    }
}

/// Tries at most six ([`BETWEEN`]) further amounts. Each lies between two neighbouring `known` amounts with the same verdict (sufficient or not),
/// where an amount with the other verdict may hide. Returns whether one of the further amounts has the other verdict. There are three reasons to try
/// an amount:
///
/// * both neighbours are insufficient, but an amount between them [might carry the whole load](where_all_might_be_carried);
/// * both neighbours are sufficient, but a margin (the carried multiple of the load less 1, or the distance to a limit) is
///   [predicted to be zero](where_a_margin_vanishes) between them;
/// * [another path](paths_differ) leads to the verdict with one neighbour than with the other, and a margin is small.
pub(super) fn between_known(
    known: &[(f64, Trial)],
    is_claimed: &dyn Fn(f64) -> bool,
    (plan, near): (&SearchPlan, f64),
    tries: TrialFunctions<'_>,
) -> Result<bool, Error> {
    let mut list: Vec<(f64, Trial)> = known.iter().filter(|(at, _)| is_claimed(*at)).cloned().list();
    let mut is_new = false;
    for count in 0..BETWEEN {
        sort_by_number(&mut list, &|(at, _)| *at);
        let carries = || where_all_might_be_carried(&list, plan).map(|at| (at, false));
        let vanishes = || where_a_margin_vanishes(&list).map(|at| (at, true));
        let guess = if count < WHERE_MARGINS_VANISH { carries().or_else(vanishes) } else { None };
        let next = guess.or_else(|| paths_differ(&list, near, tries));
        let Some((at, was_sufficient)) = next else { break };
        let now = (tries.short)(at)?;
        is_new |= now.carried().is_some() && now.is_sufficient() != was_sufficient;
        list.push((at, now));
    }
    Ok(is_new)
}

/// An amount between two neighbouring insufficient amounts, with which the whole load might be carried. A bound of the sufficient amounts is
/// estimated from the neighbour that carries more of the load. The amount lies a tenth ([`BEYOND_A_MARGIN`]) of the way from this bound to the other
/// neighbour, unless the second margin tells where sufficient amounts end. If there are several such amounts, the one whose neighbour carries most is
/// returned.
fn where_all_might_be_carried(list: &[(f64, Trial)], plan: &SearchPlan) -> Option<f64> {
    let beyond = |here: &(f64, Trial), next: &(f64, Trial)| {
        let fail = !here.1.is_sufficient() && !next.1.is_sufficient();
        let carried =
            here.1.carried().filter(|carried| fail && next.1.carried().is_some_and(|c| c < *carried))?;
        let guess = plan.guessed(here.0, &here.1)?;
        let is_between = (guess - here.0) * (guess - next.0) < 0.0;
        // If only the other neighbour moves the object too far, sufficient amounts end where the second margin is zero. The amount then lies midway.
        let [one, other] = [here, next].map(|(_, trial)| trial.measures()[1].unwrap_or(0.0));
        let end = here.0 + (next.0 - here.0) * one / (one - other);
        let is_end = one > 0.0 && other < 0.0 && (end - guess) * (next.0 - guess) > 0.0;
        let at = if is_end { 0.5 * (guess + end) } else { guess + BEYOND_A_MARGIN * (next.0 - guess) };
        is_between.then_some((carried, at))
    };
    let mut both_ways = Vec::new();
    for pair in list.windows(2) {
        both_ways.extend(beyond(&pair[0], &pair[1]));
        both_ways.extend(beyond(&pair[1], &pair[0]));
    }
    highest(&both_ways, &|(carried, _)| *carried).map(|(_, at)| *at)
}

/// The geometric mean of two neighbouring amounts with the same verdict but [different paths](TrialFunctions::differ), and whether these two amounts
/// are sufficient. Of several such pairs, the steepest is taken, of at least the slope [`STEEP`]. The slope is the logarithm of the ratio of the
/// amounts, at most of 2, times the sum of their inverse [margins](Trial::margin). Pairs that reach into the range from `near / 16` to `16 near`
/// ([`FAR_FROM_START`]) come first.
fn paths_differ(list: &[(f64, Trial)], near: f64, tries: TrialFunctions<'_>) -> Option<(f64, bool)> {
    let slope = |pair: &[(f64, Trial)]| {
        let [(one, trial), (other, next)] = [&pair[0], &pair[1]];
        let (ratio, sum) = (other / one, trial.margin()?.recip() + next.margin()?.recip());
        let slope = ratio.min(2.0).ln() * sum;
        let is_same = trial.is_sufficient() == next.is_sufficient();
        let is_asked = is_same && ratio > BETWEEN_STATES && slope >= STEEP && (tries.differ)(*one, *other);
        let is_near = *one < near * FAR_FROM_START && *other * FAR_FROM_START > near;
        is_asked.then_some(if is_near { slope } else { -slope.recip() })
    };
    let mut pairs = Vec::new();
    for pair in list.windows(2) {
        pairs.extend(slope(pair).map(|slope| (slope, pair)));
    }
    let (_, steepest) = highest(&pairs, &|(slope, _)| *slope)?;
    Some(((steepest[0].0 * steepest[1].0).sqrt(), steepest[0].1.is_sufficient()))
}

/// An amount between two neighbouring sufficient amounts, where one of two [margins](Trial::measures) may be negative. One margin is the carried
/// multiple of the load less 1, the other the distance to the limit of small motions or of sticking at rest. The margin is extrapolated linearly from
/// the first neighbour and the sufficient amount before it. The amount lies a tenth ([`BEYOND_A_MARGIN`]) of the way from its predicted zero to the
/// second neighbour.
fn where_a_margin_vanishes(list: &[(f64, Trial)]) -> Option<f64> {
    let beyond = |[before, here, next]: [&(f64, Trial); 3]| {
        let root = |which: usize| {
            let point = |of: &(f64, Trial)| Some((of.0, of.1.measures()[which]?));
            let is_zero = point(here)?.1.abs() <= NEGLIGIBLE;
            if is_zero { Some(here.0) } else { where_it_vanishes([point(here), point(before), None]) }
        };
        let mut roots = [0, 1].into_iter().filter_map(root);
        let root = roots.find(|root| (root - here.0) * (root - next.0) <= 0.0)?;
        let all_suffice = before.1.is_sufficient() && here.1.is_sufficient() && next.1.is_sufficient();
        let is_apart = (next.0 - root).abs() > (BETWEEN_STATES - 1.0) * root;
        (all_suffice && is_apart).then_some(root + BEYOND_A_MARGIN * (next.0 - root))
    };
    let either_way =
        |of: &[(f64, Trial)]| beyond([&of[0], &of[1], &of[2]]).or_else(|| beyond([&of[2], &of[1], &of[0]]));
    list.windows(3).find_map(either_way)
}

fn in_order(amounts: &mut [f64], up: bool) {
    sort_by_number(amounts, &|at| *at);
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
