//! The search for a sufficient amount (of squeeze, friction, load, arm or angle), and then for a neighbouring insufficient amount: together a bracket
//! of the bound, the least or greatest sufficient amount. `threshold` narrows this bracket.
//!
//! An amount is sufficient if the grasp meets the demand with it, e.g. holds the object; this is the result of its [`Trial`]. Easier amounts are
//! larger if the least amount is sought, smaller if the greatest is sought; harder amounts are the opposite. The carried part of the load is the load
//! factor up to which the demand is met. Motions are small within the limits up to which the linear theory is trusted.

use super::between::refined;
use super::range::Range;
use super::threshold::{Threshold, WidthSchedule};
use super::tolerances::{FAR_APART, FAR_FROM_START, LAST_DIGITS, NEAR_AN_END};
use super::trial::{NOT_AT_REST, Trial};
use crate::error::Error;
use crate::prelude::*;

/// The functions with which a search finds out whether an amount is sufficient. They differ in the time that a trial takes and in what it can decide.
#[derive(Clone, Copy)]
pub(super) struct TrialFunctions<'t> {
    /// The full trial of an amount. If no other search finds an equilibrium at rest, it enumerates combinations of contact states.
    pub(super) whole: TrialOf<'t>,
    /// A full trial whose load paths end at the loads of the question. For a sufficient amount it does not tell how far the amount is from the bound.
    /// A force of any direction is tried only in directions that are known to be weak.
    pub(super) short: TrialOf<'t>,
    /// The quick trial of an amount omits the enumeration of many contact states, which is slowest if no equilibrium exists. If only the enumeration
    /// can decide, the trial is undecided. If the flag is `true`, load paths end at the loads of the question.
    pub(super) quick: &'t dyn Fn(f64, bool) -> Result<Trial, Error>,
    /// Whether another path leads to the verdict with one amount than with another, both with full trials: contact states at rest (before the loads
    /// act), jumps, or the kind of proof that no equilibrium at rest exists.
    pub(super) differ: &'t dyn Fn(f64, f64) -> bool,
    /// An estimate of the amount, between a sufficient and an insufficient one, at which the first contact at rest changes its state.
    pub(super) rest_ends: &'t dyn Fn(f64, f64) -> Option<f64>,
    /// Whether the question has a force of any direction. A full trial may then find a direction in which the force is not carried; later quick
    /// trials test this direction, too.
    pub(super) learns: bool,
    /// Whether the grasp is planar. In the plane the amounts at which contact states change are computed up to rounding; in space an iteration leaves
    /// a larger error.
    pub(super) is_planar: bool,
}

pub(super) type TrialOf<'t> = &'t dyn Fn(f64) -> Result<Trial, Error>;

impl TrialFunctions<'_> {
    pub(super) fn at(&self, amount: f64) -> Result<Trial, Error> {
        (self.whole)(amount)
    }
}

#[derive(Debug)]
pub(super) enum BoundSearch {
    /// The bound was found between the two amounts of this bracket.
    Threshold(Threshold),
    /// All amounts tried towards harder ones (less squeeze, more load) are sufficient; this is the last of them.
    All(f64),
    /// No amount is sufficient. The list has the amounts known before the search, then the amounts of the search in the order of the trials.
    Nothing(Vec<(f64, Trial)>),
}

/// How the bound is estimated from one trial: with the amount x the part c of the load is carried. With the amount at the bound, c is 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum BoundEstimate {
    /// The bound is about `x c`, because the load itself is the sought quantity.
    Times,
    /// The bound is about `x / c`, as if c were proportional to x.
    Divided,
    /// The bound is not estimated from c: for an arm, and for loads that repeat.
    Nothing,
}

/// The plan of a search: its first amount, the range of amounts, whether the least or greatest amount is sought, and the width of the bracket at
/// which it ends.
#[derive(Debug)]
pub(super) struct SearchPlan {
    /// The amount with which the search begins, if forces can balance the loads with it; otherwise [`Self::begin`] takes an amount inside the range.
    pub(super) start: f64,
    /// The least and the greatest amount that the search may try.
    pub(super) limits: [f64; 2],
    /// The range of amounts outside which all amounts are proved insufficient, because contact forces cannot balance the loads.
    pub(super) range: Range,
    /// True if the least sufficient amount is sought, false if the greatest is sought.
    pub(super) is_least: bool,
    /// How the bound is estimated from the carried part of the load in one trial.
    pub(super) guess: BoundEstimate,
    /// Whether it is known that with a sufficient amount every easier one (such as more squeeze or less load) is sufficient, too. This holds as far
    /// as motions are small.
    pub(super) is_monotone: bool,
    /// True if the search for a sufficient amount goes in both directions and between the amounts tried. False if it tries only a few easier amounts,
    /// such as more squeeze or less load.
    pub(super) everywhere: bool,
    /// The relative width of the bracket at which the search ends, as a function of the number of steps made.
    pub(super) enough: WidthSchedule,
}

impl SearchPlan {
    fn low(&self) -> f64 {
        self.range.low.unwrap_or(self.limits[0])
    }

    fn high(&self) -> f64 {
        self.range.high.unwrap_or(self.limits[1])
    }

    pub(super) fn contains(&self, amount: f64) -> bool {
        self.low() <= amount && amount <= self.high()
    }

    /// The upper end of the range if `up`, else the lower end. With every amount beyond this end it is proved that no contact forces balance the
    /// loads. `None` if nothing is proved on this side.
    pub(super) fn end(&self, up: bool) -> Option<f64> {
        if up { self.range.high } else { self.range.low }
    }

    /// Whether a proof that contact forces do not balance the loads excludes all amounts above (if `up`) or below this amount, to the accuracy of the
    /// proof.
    pub(super) fn is_the_end(&self, amount: f64, up: bool) -> bool {
        let [.., nearby] = NEAR_AN_END;
        self.end(up).is_some_and(|end| (amount - end).abs() <= nearby * end.abs())
    }

    pub(super) fn guessed(&self, at: f64, trial: &Trial) -> Option<f64> {
        let carried = trial.carried().filter(|carried| *carried > 0.0 && carried.is_finite())?;
        let guess = match self.guess {
            BoundEstimate::Times => at * carried,
            BoundEstimate::Divided => at / carried,
            BoundEstimate::Nothing => return None,
        };
        self.contains(guess).then_some(guess)
    }

    /// Whether the amount `one` is harder than `other`: smaller if the least amount is sought, larger if the greatest is sought.
    pub(super) fn is_harder(&self, one: f64, other: f64) -> bool {
        if self.is_least { one < other } else { one > other }
    }

    /// The amount at the relative distance `part` beyond the proved end of the range on the harder side (less squeeze, more load); inside the range
    /// if `part` is negative. `None` if no such end is known, or if it is easier than the amount `sufficient`.
    fn beside_the_end(&self, sufficient: f64, part: f64) -> Option<f64> {
        let end = self.end(!self.is_least).filter(|end| self.is_harder(*end, sufficient))?;
        Some(if self.is_least { end * (1.0 - part) } else { end * (1.0 + part) })
    }

    /// Estimates of the bound, in the order in which they are tried. First come estimates from the carried part of the load at both ends of a
    /// bracket. Then follow amounts on both sides of the proved end of the range, beyond which contact forces cannot balance the loads. If friction
    /// is sought, two of them lie next to an estimate of the least coefficient (`likely`), which secants gave.
    fn guesses(
        &self,
        (sufficient, trial): (f64, &Trial),
        insufficient: Option<&(f64, Trial)>,
    ) -> impl Iterator<Item = f64> + use<> {
        let beyond = |at: f64, trial: &Trial, part: f64| {
            let guess = self.guessed(at, trial).filter(|guess| !self.is_harder(sufficient, *guess));
            guess.map(|guess| if self.is_least { guess * (1.0 - part) } else { guess * (1.0 + part) })
        };
        let from_beyond = |part: f64| insufficient.and_then(|(at, trial)| beyond(*at, trial, part));
        let [nearest, near_enough, nearby] = NEAR_AN_END;
        let likely = |part: f64| self.range.likely.filter(|_| self.is_least).map(|at| at * part);
        // Relative distance from the estimate of least friction at which an amount on either side is tried. If this distance were smaller than the
        // error of that estimate, both amounts would be on one side of the bound.
        let off = 3e-12;
        let near = |part: f64| self.beside_the_end(sufficient, part);
        let guesses = [
            beyond(sufficient, trial, LAST_DIGITS),
            from_beyond(LAST_DIGITS),
            from_beyond(64.0 * LAST_DIGITS),
            near(-nearby),
            likely(1.0 + off),
            likely(1.0 - off),
            near(-nearest),
            near(-near_enough),
            near(nearest),
            near(near_enough),
        ];
        guesses.into_iter().flatten()
    }

    /// The first amount tried: the start if forces can balance the loads with it, or else an amount inside the range. If the range has two ends, this
    /// amount is its middle.
    pub(super) fn begin(&self) -> f64 {
        match (self.range.low, self.range.high) {
            _ if self.contains(self.start) => self.start,
            (Some(low), Some(high)) => 0.5 * (low + high),
            (Some(low), None) => (2.0 * low).min(self.limits[1]),
            (None, _) => (self.high() / 2.0).max(self.limits[0]),
        }
    }
}

/// Searches for the bound, the least or greatest sufficient amount. First a sufficient amount is needed: the hardest one in `known`, the trials made
/// before, or else the first amount of the plan. If that is insufficient, easier amounts (more squeeze, less load) are tried, then harder amounts,
/// then amounts between those tried. From the sufficient amount the search goes towards harder amounts until one is insufficient.
pub(super) fn search(
    tries: TrialFunctions<'_>,
    plan: &SearchPlan,
    known: &[(f64, Trial)],
) -> Result<BoundSearch, Error> {
    let more = plan.is_least;
    let (sufficient, mut vain): (Vec<_>, Vec<_>) =
        known.iter().cloned().partition(|(_, trial)| trial.is_sufficient());
    let nearest =
        sufficient.into_iter().reduce(|one, other| if (one.0 < other.0) == more { one } else { other });
    if let Some(sufficient) = nearest {
        return edge_from(tries, plan, sufficient, &vain);
    }
    let first = decided(tries.whole, plan.begin(), None)?;
    if first.1.is_sufficient() {
        return edge_from(tries, plan, first, &vain);
    }
    let is_hopeless =
        plan.is_monotone && plan.guess == BoundEstimate::Times && first.1.carried().is_some_and(|c| c < 0.0);
    vain.push(first.clone());
    if is_hopeless {
        return Ok(BoundSearch::Nothing(vain));
    }
    if let Some(sufficient) = guessed(tries, plan, first.clone(), &mut vain)? {
        return edge_from(tries, plan, sufficient, &vain);
    }
    if plan.everywhere {
        for up in [!more, more] {
            for near in NEAR_AN_END {
                let Some(end) = plan.end(up) else { continue };
                let at = if up { end * (1.0 - near) } else { end * (1.0 + near) };
                let trial = tries.at(at)?;
                if trial.is_sufficient() {
                    return edge_from(tries, plan, (at, trial), &vain);
                }
                vain.push((at, trial));
            }
        }
    }
    // The ratio of successive amounts. With a larger ratio than 2, narrow intervals of sufficient amounts would be missed. A search that need not go
    // everywhere tries fewer amounts, farther apart.
    let factor = if plan.everywhere { 2.0 } else { FAR_APART };
    let begin = first.0;
    // If the start is insufficient because its squeeze moves the object too far, a smaller squeeze may be sufficient. Therefore harder amounts (less
    // squeeze, more load) are tried, too. They are not tried if a greatest amount is sought and every amount easier than a sufficient one is known to
    // be sufficient (`is_monotone`).
    let may_be_less = plan.everywhere && (plan.is_least || !plan.is_monotone);
    for (up, is_asked) in [(more, true), (!more, may_be_less)] {
        if is_asked && let Some(sufficient) = first_sufficient(tries, plan, (begin, up, factor), &mut vain)? {
            return edge_from(tries, plan, sufficient, &vain);
        }
    }
    if plan.everywhere
        && !plan.is_monotone
        && let Some(sufficient) = refined(tries, plan, begin, &mut vain)?
    {
        return edge_from(tries, plan, sufficient, &vain);
    }
    Ok(BoundSearch::Nothing(vain))
}

/// Tries the amount `at` and, if its verdict is undecided, some neighbouring amounts. Returns the first amount with a decided verdict and its trial,
/// else `at` with its undecided trial. `width` is the width of the bracket in which `at` lies, if a bracket is known. The distances of the neighbours
/// from `at` are fractions of `width`, or else of `at`.
pub(super) fn decided(tries: TrialOf<'_>, at: f64, width: Option<f64>) -> Result<(f64, Trial), Error> {
    let first = tries(at)?;
    if let Trial::Unknown(_) = first {
        let beside = |part: f64| width.map_or(at * (1.0 + part), |width| at + part * width);
        // Neighbours are tried so that one undecided amount does not end the search. As a rule a verdict is undecided because two contacts change
        // their states at the same load. Neighbours that differ from `at` by less than the fraction 1e-9 might be undecided for the same reason. In a
        // narrow bracket only two neighbours are tried.
        let is_narrow = width.is_some_and(|width| width <= 1e-6 * at.abs());
        let offsets: &[f64] = match width {
            Some(_) if is_narrow => &[0.3, -0.3],
            Some(_) => &[0.3, -0.3, 0.1, -0.1, 0.01, -0.01],
            None => &[1e-9, -1e-9, 1e-6, -1e-6, 1e-3, -1e-3],
        };
        for part in offsets {
            let trial = tries(beside(*part))?;
            if !matches!(trial, Trial::Unknown(_)) {
                return Ok((beside(*part), trial));
            }
        }
    }
    Ok((at, first))
}

/// The first sufficient amount among estimates of the bound from the carried part of the load. Each estimate is moved towards easier amounts (more
/// squeeze, less load). The first is moved by twice the relative distance [`LAST_DIGITS`], at which two amounts differ by rounding alone. Each
/// following estimate is moved 64 times as far as the one before.
fn guessed(
    tries: TrialFunctions<'_>,
    plan: &SearchPlan,
    (mut at, mut trial): (f64, Trial),
    vain: &mut Vec<(f64, Trial)>,
) -> Result<Option<(f64, Trial)>, Error> {
    let mut beyond = LAST_DIGITS;
    // If four estimates are insufficient, the carried part of the load is not proportional to the amount, and [`first_sufficient`] continues the
    // search.
    for _ in 0..4 {
        let Some(guess) = plan.guessed(at, &trial) else { break };
        beyond *= 2.0;
        let guess = if plan.is_least { guess * (1.0 + beyond) } else { guess * (1.0 - beyond) };
        (at, trial) = (guess, tries.at(guess)?);
        if trial.is_sufficient() {
            return Ok(Some((at, trial)));
        }
        vain.push((at, trial.clone()));
        beyond *= 32.0;
    }
    Ok(None)
}

/// The first sufficient amount in one direction; from each trial to the next the amount is multiplied or divided by `factor`.
fn first_sufficient(
    tries: TrialFunctions<'_>,
    plan: &SearchPlan,
    (begin, up, factor): (f64, bool, f64),
    vain: &mut Vec<(f64, Trial)>,
) -> Result<Option<(f64, Trial)>, Error> {
    let mut at = begin;
    loop {
        // The farther an interval of sufficient amounts lies from the start, the wider it usually is. Far from the start steps by the factor
        // `FAR_FROM_START` therefore find it, although steps near the start must be smaller.
        let is_far = at > FAR_FROM_START * begin || at * FAR_FROM_START < begin;
        let factor = if is_far { factor.max(FAR_FROM_START) } else { factor };
        at *= if up { factor } else { factor.recip() };
        if !plan.contains(at) {
            return Ok(None);
        }
        let trial = tries.at(at)?;
        if trial.is_sufficient() {
            return Ok(Some((at, trial)));
        }
        vain.push((at, trial));
    }
}

/// The bracket of the bound, found from a sufficient amount and the result of its trial. Harder amounts (less squeeze, more load) are tried until one
/// is insufficient. Then the bracket is narrowed. `vain` has the insufficient amounts tried before.
fn edge_from(
    tries: TrialFunctions<'_>,
    plan: &SearchPlan,
    (mut sufficient, mut trial): (f64, Trial),
    vain: &[(f64, Trial)],
) -> Result<BoundSearch, Error> {
    let is_harder = |one: f64, other: f64| plan.is_harder(one, other);
    let nearest = vain.iter().filter(|(at, trial)| is_harder(*at, sufficient) && trial.carried().is_some());
    let mut insufficient =
        nearest.reduce(|one, other| if is_harder(one.0, other.0) { other } else { one }).cloned();
    let inside = plan.beside_the_end(sufficient, -NEAR_AN_END[2]);
    for amount in plan.guesses((sufficient, &trial), insufficient.as_ref()) {
        if insufficient.as_ref().is_some_and(|not| !is_harder(not.0, amount))
            || !is_harder(amount, sufficient)
        {
            continue;
        }
        // If the quick trial (without the enumeration of contact states) is undecided, a full trial would take long, so the next estimate is tried
        // instead.
        match (tries.quick)(amount, false)? {
            // A full trial of a force of any direction takes hundreds of verdicts. Therefore only the bound itself is confirmed by one, not this
            // amount.
            Trial::Sufficient { .. } if tries.learns => {}
            Trial::Sufficient { .. } => {
                if let now @ Trial::Sufficient { .. } = tries.at(amount)? {
                    (sufficient, trial) = (amount, now);
                }
            }
            now @ Trial::Insufficient { .. } => insufficient = Some((amount, now)),
            Trial::Unknown(_) => {}
        }
        // If the amount just inside the proved end is not sufficient, the bound is not at this end. The further guesses near this end are skipped.
        if Some(amount) == inside && sufficient != amount {
            break;
        }
    }
    if let Some(insufficient) = insufficient {
        let edge = Threshold { sufficient, insufficient, unknown: None };
        return Ok(BoundSearch::Threshold(edge.narrowed(tries, trial.measures(), plan.enough)?));
    }
    first_insufficient(tries, plan, (sufficient, trial))
}

/// The bracket of the bound beyond a sufficient amount, if no estimate of the bound has led to an insufficient amount. The insufficient amount is
/// sought in growing steps towards harder amounts (less squeeze, more load).
fn first_insufficient(
    tries: TrialFunctions<'_>,
    plan: &SearchPlan,
    (mut sufficient, mut trial): (f64, Trial),
) -> Result<BoundSearch, Error> {
    let (mut at, mut factor, mut unknown) = (sufficient, 1.0, None);
    let insufficient = loop {
        // The ratio of successive amounts grows from step to step. A wide bracket costs little, since the secant steps that follow narrow it quickly.
        // Many small steps would cost more, because a load path on which all contact forces are tiny takes long.
        factor *= FAR_APART;
        at = if plan.is_least { at / factor } else { at * factor };
        if !plan.contains(at) {
            // Beyond an end of the range it is proved that contact forces do not balance the loads, so that no trial is needed.
            let says = || Trial::insufficient("no forces of the contacts balance it", NOT_AT_REST);
            break plan.beside_the_end(sufficient, NEAR_AN_END[1]).map(|end| (end, says()));
        }
        match decided(tries.whole, at, None)? {
            (at, now @ Trial::Sufficient { .. }) => (sufficient, trial) = (at, now),
            (_, Trial::Unknown(why)) => unknown = unknown.or(Some((at, why))),
            (at, now @ Trial::Insufficient { .. }) => break Some((at, now)),
        }
    };
    match (insufficient, unknown) {
        (Some(insufficient), unknown) => {
            let edge = Threshold { sufficient, insufficient, unknown };
            Ok(BoundSearch::Threshold(edge.narrowed(tries, trial.measures(), plan.enough)?))
        }
        (None, Some(why)) if plan.is_harder(why.0, sufficient) => {
            let insufficient = (why.0, Trial::Unknown(why.1.clone()));
            Ok(BoundSearch::Threshold(Threshold { sufficient, insufficient, unknown: Some(why) }))
        }
        (None, _) => Ok(BoundSearch::All(sufficient)),
    }
}
