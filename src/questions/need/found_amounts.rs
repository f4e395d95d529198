//! Completes the answer of a `need` after a search has found sufficient amounts (of squeeze, friction, load, arm or angle). An amount is sufficient
//! if the grasp meets the demand with it, e.g. holds the object; the bound is the least or greatest sufficient amount.
//!
//! Easier amounts are larger if the least amount is sought, smaller if the greatest is sought; harder amounts are the opposite. The far end is the
//! last sufficient amount on the easier side of the bound. A scan tries further amounts on both sides of a bound that is already found. A safe amount
//! is sufficient also with less friction and squeeze, or with larger loads. At rest means before the loads of the question act. A bracket consists of
//! a sufficient amount and its insufficient neighbour. A drive is the spring of a joint or tendon of a hand, with its force limit.

use super::answer::{Amount, FarEnd};
use super::bound_scan::{BoundScan, between_known};
use super::checked_need::Sought;
use super::press::ContactPress;
use super::pressed_at_rest::presses;
use super::question::Demand;
use super::search::{SearchPlan, TrialFunctions};
use super::threshold::Threshold;
use super::tolerances::{FAR_FROM_START, NARROW, STEPPED_OVER, USUAL_FRICTION};
use super::trial::Trial;
use super::trial_record::{SearchExtent, TrialRecord};
use crate::error::Error;
use crate::numerics::{IntoList, mapped, picked, sort_by_number};
use crate::prelude::*;

/// Completes the answer after a search has found sufficient amounts. It tries further amounts around the bound (the scan), finds the last sufficient
/// amount on the easier side (the far end), and computes the contact forces at rest.
pub(super) struct FoundAmounts<'f, 'q> {
    pub(super) tried: &'f TrialRecord<'q>,
    pub(super) demand: Demand,
    pub(super) tries: TrialFunctions<'f>,
    /// Number of further amounts to try around the bound once it is found (the scan); 0 if no scan is made.
    pub(super) scan: usize,
}

impl FoundAmounts<'_, '_> {
    pub(super) fn known(&self) -> Vec<(f64, Trial)> {
        self.tried.known(self.demand)
    }

    /// The normal forces of the contacts at rest with the squeeze `sufficient`, and the names of drives at their limit; see [`presses`]. Both lists
    /// are empty if another quantity than a squeeze is sought.
    fn presses(&self, sufficient: f64) -> Result<(Vec<ContactPress>, Vec<String>), Error> {
        match self.tried.need.sought {
            Sought::Squeeze | Sought::Overlaps => presses(self.tried.grasp, sufficient, self.tried.need),
            _ => Ok(Default::default()),
        }
    }

    fn far_end(&self, edge: Option<Threshold>) -> Result<Option<FarEnd>, Error> {
        let Some(Threshold { sufficient, insufficient: (insufficient, trial), .. }) = edge else {
            return Ok(None);
        };
        let (Trial::Insufficient { says: otherwise, .. } | Trial::Unknown(otherwise)) = trial else {
            return Ok(None);
        };
        let (presses, at_their_limit) = self.presses(sufficient)?;
        Ok(Some(FarEnd { sufficient, insufficient, otherwise, presses, at_their_limit }))
    }

    /// Tries further amounts, those near `near` first, between neighbouring known amounts with the same verdict. [`between_known`] selects the
    /// amounts at which another verdict is likely. Returns whether one of the further amounts has another verdict than its neighbours. Nothing is
    /// tried if no scan is made, or if amounts easier (more squeeze, less load) than a sufficient one are known to be sufficient.
    fn changes_between(
        &self,
        plan: &SearchPlan,
        near: f64,
        is_claimed: &dyn Fn(f64) -> bool,
    ) -> Result<bool, Error> {
        let is_asked = !plan.is_monotone && self.scan > 0;
        if is_asked { between_known(&self.known(), is_claimed, (plan, near), self.tries) } else { Ok(false) }
    }

    /// The answer if all amounts that were tried in the harder direction (less squeeze, more load) are sufficient. The last of these amounts is `to`.
    pub(super) fn any(&self, plan: &SearchPlan, to: f64) -> Result<Amount, Error> {
        let seek = || BoundScan::far_end(to, self.scan, plan, &self.known(), self.tries);
        let mut until = seek()?;
        let end = until.as_ref().map(|edge| edge.sufficient);
        if self
            .changes_between(plan, plan.begin(), &|at| end.is_none_or(|end| (at - to) * (at - end) <= 0.0))?
        {
            until = seek()?;
        }
        let tried = (!plan.is_monotone).then(|| self.tried.amounts(self.demand));
        Ok(Amount::Any { to, until: self.far_end(until)?, tried })
    }

    /// The result of the scan around a bound. The scan is repeated if [`Self::changes_between`] finds an amount whose verdict differs from that of
    /// its neighbours.
    fn around(&self, plan: &mut SearchPlan, bound: &Threshold) -> Result<BoundScan, Error> {
        let sufficient = bound.sufficient;
        let is_squeeze = matches!(self.tried.need.sought, Sought::Squeeze | Sought::Overlaps);
        // If `plan.is_monotone`, a larger squeeze always carries more, but it may move the object too far. Therefore one much larger squeeze is
        // tried: [`FAR_FROM_START`] times the least squeeze or, if larger, times the given squeeze. If it is insufficient, the whole range is
        // scanned.
        let ample = FAR_FROM_START * sufficient.max(plan.start);
        if plan.is_monotone && is_squeeze && self.scan > 0 && plan.contains(ample) {
            self.tries.at(ample)?;
        }
        // A wedge that is pressed in between contacts may carry less load if friction is larger. Friction of a surface may be larger than in the
        // scene, up to about 1. Therefore the coefficient 1 ([`USUAL_FRICTION`]) is tried, too.
        let is_friction = matches!(self.tried.need.sought, Sought::Friction { .. });
        let is_more = sufficient < USUAL_FRICTION && plan.contains(USUAL_FRICTION);
        if is_friction && is_more && !plan.is_monotone && self.scan > 0 {
            (self.tries.short)(USUAL_FRICTION)?;
        }
        let is_too_much =
            |(at, trial): &(f64, Trial)| *at > sufficient && matches!(trial, Trial::Insufficient { .. });
        plan.is_monotone &= !plan.is_least || !self.known().iter().any(is_too_much);
        let is_far = is_squeeze || matches!(self.tried.need.sought, Sought::Force { .. });
        let around = || BoundScan::of(bound, self.scan, is_far, plan, &self.known(), self.tries);
        let found = around()?;
        if self.changes_between(plan, sufficient, &|_| true)? { around() } else { Ok(found) }
    }

    /// The bracket at the harder end (less squeeze, more load) of an interval of sufficient amounts whose ends differ by more than 1 % ([`NARROW`]).
    /// Among several such intervals the one with the hardest end is taken. `None` if `bound` is at this end already, or if the ends of all intervals
    /// differ by less.
    fn edge_of_a_wide_window(
        &self,
        plan: &SearchPlan,
        bound: &Threshold,
        found: &BoundScan,
    ) -> Option<Threshold> {
        let far = found.until.as_ref().map(|edge| edge.sufficient);
        let own = if plan.is_least { [Some(bound.sufficient), far] } else { [far, Some(bound.sufficient)] };
        let mut all = mapped(&found.elsewhere, &|window| [window.from, window.to]);
        all.push(own);
        let is_wide = |[from, to]: &[Option<f64>; 2]| {
            from.is_none_or(|from| to.is_none_or(|to| to > from * (1.0 + NARROW)))
        };
        let edges = picked(&all, &|ends| ends[usize::from(!plan.is_least)].filter(|_| is_wide(ends)));
        let sufficient =
            edges.into_iter().reduce(|one, other| if plan.is_harder(one, other) { one } else { other })?;
        let known = self.known();
        let harder = known.iter().filter(|(at, trial)| {
            matches!(trial, Trial::Insufficient { .. }) && plan.is_harder(*at, sufficient)
        });
        let insufficient =
            harder.reduce(|one, other| if plan.is_harder(one.0, other.0) { other } else { one })?.clone();
        (sufficient != bound.sufficient).then_some(Threshold { sufficient, insufficient, unknown: None })
    }

    /// The answer [`Amount::Bound`], from the bracket of the least or greatest sufficient amount and from amounts that are tried around it.
    pub(super) fn bound(
        mut self,
        mut plan: SearchPlan,
        mut bound: Threshold,
        look: SearchExtent,
    ) -> Result<Amount, Error> {
        if is_stepped_over(&plan, bound.sufficient) {
            self.scan = self.tried.need.scan;
        }
        if let Trial::Unknown(doubt) = bound.insufficient.1 {
            return Ok(Amount::Undecided { at: bound.insufficient.0, doubt });
        }
        let mut found = self.around(&mut plan, &bound)?;
        if let Some(edge) = self.edge_of_a_wide_window(&plan, &bound, &found) {
            let measures = self.tries.at(edge.sufficient)?.measures();
            bound = edge.narrowed(self.tries, measures, plan.enough)?;
            found = self.around(&mut plan, &bound)?;
        }
        let (sufficient, insufficient) = (bound.sufficient, bound.insufficient.0);
        let (otherwise, is_too_far) = match &bound.insufficient.1 {
            Trial::Insufficient { says, is_too_far, .. } => (says.clone(), *is_too_far),
            Trial::Sufficient { .. } | Trial::Unknown(_) => (String::new(), false),
        };
        let BoundScan { changes, mut until, elsewhere } = found;
        let far = match look {
            SearchExtent::Everywhere(far) => far,
            SearchExtent::Towards => beyond_the_sufficient(sufficient, plan.is_least, &self.known()),
            SearchExtent::Around => None,
        };
        if let (Some(far), None) = (far, &until) {
            until = far_end_near(far, sufficient, self.tries)?;
        }
        let (presses, at_their_limit) = self.presses(sufficient)?;
        let is_last = plan.is_monotone || plan.is_the_end(insufficient, !plan.is_least);
        let tried = (!is_last).then(|| self.tried.amounts(self.demand));
        Ok(Amount::Bound {
            sufficient,
            insufficient,
            otherwise,
            is_too_far,
            unknown: bound.unknown.map(|(at, _)| at),
            changes,
            until: self.far_end(until)?,
            elsewhere,
            presses,
            at_their_limit,
            tried,
        })
    }
}

/// Whether the search for a safe amount stepped over many amounts whose verdicts do not follow from the verdict on another amount. This is so if the
/// sufficient amount is easier (more squeeze, less load) than the first amount tried by more than the factor 1.25 ([`STEPPED_OVER`]).
fn is_stepped_over(plan: &SearchPlan, sufficient: f64) -> bool {
    let begin = plan.begin();
    let ratio = if plan.is_least { sufficient / begin } else { begin / sufficient };
    plan.everywhere && !plan.is_monotone && ratio > STEPPED_OVER
}

/// The last sufficient amount and the first insufficient amount among those tried from the bound `sufficient` towards easier amounts (more squeeze,
/// less load). `None` if no tried amount is insufficient.
fn beyond_the_sufficient(sufficient: f64, is_least: bool, known: &[(f64, Trial)]) -> Option<[f64; 2]> {
    let ample = |at: f64| if is_least { at / sufficient } else { sufficient / at };
    let mut beyond: Vec<_> = known.iter().filter(|(at, _)| ample(*at) > 1.0).list();
    sort_by_number(&mut beyond, &|(at, _)| ample(*at));
    let first = beyond.iter().position(|(_, trial)| matches!(trial, Trial::Insufficient { .. }))?;
    let last = beyond[..first]
        .iter()
        .rev()
        .find(|(_, trial)| trial.is_sufficient())
        .map_or(sufficient, |(at, _)| *at);
    Some([last, beyond[first].0])
}

/// The last sufficient amount on the easier side (more squeeze, less load) of the bound `sufficient`, and its insufficient neighbour. This far end is
/// expected between the two amounts `far`, which are tried in turn. For a safe amount, `far` has the far end and its insufficient neighbour that were
/// found with friction, squeeze and loads as given. `None` if neither of the two is insufficient, or if a verdict is undecided.
fn far_end_near(
    far: [f64; 2],
    sufficient: f64,
    tries: TrialFunctions<'_>,
) -> Result<Option<Threshold>, Error> {
    let mut inner = sufficient;
    for amount in far {
        match tries.at(amount)? {
            Trial::Sufficient { .. } => inner = amount,
            Trial::Unknown(_) => return Ok(None),
            trial @ Trial::Insufficient { .. } => {
                let measures = tries.at(inner)?.measures();
                let edge = Threshold { sufficient: inner, insufficient: (amount, trial), unknown: None };
                return edge.beside(tries, measures).map(Some);
            }
        }
    }
    Ok(None)
}
