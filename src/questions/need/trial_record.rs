//! The amounts (of squeeze, friction, load, arm or angle) that were tried for an answer, and the plan for the search of further amounts. An amount is
//! sufficient if the grasp meets the demand with it, e.g. holds the object; the bound is the least or greatest sufficient amount. A safe amount is
//! sufficient also with less friction and squeeze, or with larger loads. At rest means under the loads that act before the loads of the question. A
//! full trial of an amount enumerates contact states in the search for equilibria, a quick trial does not.
//!
//! Easier amounts are larger if the least amount is sought, smaller if the greatest is sought. The far end is the last sufficient amount on the
//! easier side of the bound. A scan tries further amounts on both sides of a bound that is already found. A bracket consists of a sufficient and an
//! insufficient amount with the bound between them.

use core::cell::{Cell, Ref, RefCell};

use super::answer::TriedAmounts;
use super::checked_need::{CheckedNeed, SafetyDeviations, Sought};
use super::loading::Loading;
use super::question::Demand;
use super::range::Range;
use super::search::{BoundEstimate, SearchPlan};
use super::threshold::where_it_vanishes;
use super::tolerances::{APART_IN_A_SCAN, EXACT, EXACT_IN_SPACE, MOST_LOADS, SECOND};
use super::trial::{RefutingLoads, Trial, Trials};
use crate::ask::Grasp;
use crate::contact::State;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::hold::{AtRest, VerdictScope};
use crate::numerics::{IntoList, Space, keep, lowest, mapped, picked, sort_by_number};
use crate::object::uses_band;
use crate::prelude::*;
use crate::squeeze::Loads;

/// The extent of a search for sufficient amounts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum SearchExtent {
    /// A search in both directions, then a scan around the bound of the sufficient amounts.
    Around,
    /// A search in both directions for a safe amount. The value has the far end, and its insufficient neighbour, that were found with friction,
    /// squeeze and loads as given; `None` if no far end was found. The search tries these two amounts to find the far end of the safe amounts.
    Everywhere(Option<[f64; 2]>),
    /// A search for the amount with which nothing slides. It tries only easier amounts than the first one, such as more squeeze or less load, in few
    /// trials.
    Towards,
}

/// All amounts tried so far, each with the result of its trial.
pub(super) struct TrialRecord<'q> {
    pub(super) grasp: &'q Grasp<3>,
    pub(super) need: &'q CheckedNeed,
    safety: SafetyDeviations,
    /// The amount with which the search begins, if forces can balance the loads with it.
    pub(super) start: f64,
    known: RefCell<Vec<(f64, Trials)>>,
    /// Results of quick trials, in which many contact states are not enumerated.
    quick: RefCell<Vec<(f64, Trials)>>,
    refuting: RefutingLoads,
    /// The range of amounts outside which contact forces are proved not to balance the loads. It is computed by the first search and shared by all
    /// searches.
    range: Cell<Option<Range>>,
}

impl<'q> TrialRecord<'q> {
    pub(super) fn new(
        grasp: &'q Grasp<3>,
        need: &'q CheckedNeed,
        safety: SafetyDeviations,
        start: f64,
    ) -> Self {
        Self {
            grasp,
            need,
            safety,
            start,
            known: RefCell::new(Vec::new()),
            quick: RefCell::new(Vec::new()),
            refuting: RefutingLoads::default(),
            range: Cell::new(None),
        }
    }

    /// This record with the directions of a force in which amounts of the record `other` were insufficient. Trials try these directions first.
    pub(super) fn with_directions_of(self, other: &Self) -> Self {
        self.refuting.directions.replace(other.refuting.directions.borrow().clone());
        self
    }

    /// The full trial of an amount, with the enumeration of contact states, computed unless it is known. If `short`, load paths end at the whole
    /// load.
    pub(super) fn at(&self, amount: f64, demand: Demand, short: bool) -> Result<Trial, Error> {
        if let Some(trial) = of(&self.known, amount, demand) {
            return Ok(trial);
        }
        // An amount that is sufficient in a quick trial (without the enumeration of contact states) is sufficient in a full trial, too. There are two
        // exceptions. With many coordinates, a quick trial starts the search for an equilibrium at rest from the contact states of another amount. If
        // the question has a force of any direction, quick trials omit some directions.
        if demand == Demand::Held
            && !uses_band(self.grasp.engine.size())
            && !matches!(self.need.loads, Loads::AnyForce { .. })
            && let Some(trial) = of(&self.quick, amount, demand).filter(Trial::is_sufficient)
        {
            let quick =
                self.quick.borrow().iter().find(|(at, of)| *at == amount && of.held.is_some()).cloned();
            self.known.borrow_mut().extend(quick);
            return Ok(trial);
        }
        let mut loading = self.loading(amount, short || demand == Demand::Sticks)?;
        if short {
            loading.extent = VerdictScope::Decided;
        }
        let mut trials = self.put_on(&loading, demand)?;
        // If no search decides whether an equilibrium at rest exists, a load path from zero to the load at rest may decide it.
        if short && trials.of(demand).is_none_or(|trial| trial.carried().is_none()) {
            loading.extent = VerdictScope::Measured;
            trials = self.put_on(&loading, demand)?;
        }
        Ok(kept(&self.known, amount, trials, demand))
    }

    /// The quick trial of an amount, without the enumeration of many contact states; the full trial if that is known. If `short`, load paths end at
    /// the loads of the question.
    pub(super) fn quick(&self, amount: f64, demand: Demand, short: bool) -> Result<Trial, Error> {
        let found = of(&self.known, amount, demand).or_else(|| of(&self.quick, amount, demand));
        if let Some(trial) = found {
            return Ok(trial);
        }
        let loading = self.loading(amount, short)?.quick(self.rests_near(amount));
        let trials = self.put_on(&loading, demand)?;
        Ok(kept(&self.quick, amount, trials, demand))
    }

    fn put_on(&self, loading: &Loading, demand: Demand) -> Result<Trials, Error> {
        let before = self.refuting.directions.borrow().clone();
        let trials = loading.put_on(demand, &self.refuting)?;
        // This trial has added a direction to the directions of a force that quick trials must include. Earlier quick trials did not include it, so
        // their results are dropped.
        if self.refuting.directions.borrow().iter().any(|direction| !before.contains(direction)) {
            self.quick.borrow_mut().clear();
        }
        Ok(trials)
    }

    fn loading(&self, amount: f64, short: bool) -> Result<Loading, Error> {
        let loading = Loading::of(self.grasp, self.need, amount, self.safety)?;
        Ok(if short { loading.short() } else { loading })
    }

    /// The contact states at rest with the nearest amount for which an equilibrium at rest is known. Empty if there is none, and for a grasp with
    /// fewer than 36 coordinates, which needs no start.
    fn rests_near(&self, amount: f64) -> Vec<State> {
        if !uses_band(self.grasp.engine.size()) {
            return Vec::new();
        }
        let lists = [self.known.borrow(), self.quick.borrow()];
        let rests = rests(&lists);
        let nearest = lowest(&rests, &|(at, _)| (at - amount).abs());
        nearest.map_or_else(Vec::new, |(_, rest)| rest.states.clone())
    }

    /// Whether another path leads to the verdict with one of these two amounts than with the other; both must have been tried. A contact has another
    /// state at rest, or the object jumps with one of them only. Of two proofs that there is no equilibrium at rest, at most one is a motion.
    pub(super) fn differ(&self, one: f64, other: f64) -> bool {
        let known = self.known.borrow();
        let found = |amount: f64| known.iter().find(|(at, _)| *at == amount).map(|(_, trials)| trials);
        let differ = |one: &Trials, other: &Trials| match (&one.at_rest, &other.at_rest) {
            (Some(at), Some(there)) => !same_kinds(at, there) || one.jumps != other.jumps,
            (None, None) => !(one.is_unbalanced && other.is_unbalanced),
            _ => true,
        };
        found(one).zip(found(other)).is_some_and(|(one, other)| differ(one, other))
    }

    /// Whether the object jumps (moves suddenly under constant load) while the loads are put on with this amount. False if the amount was not tried.
    pub(super) fn jumps_with(&self, amount: f64) -> bool {
        let lists = [self.known.borrow(), self.quick.borrow()];
        lists.iter().any(|list| list.iter().any(|(at, trials)| *at == amount && trials.jumps))
    }

    /// The amount between a sufficient and an insufficient one at which the first contact at rest changes its state. Each state has margins (of gap,
    /// normal force, friction or slip), and ends where one of them is zero. The margins are extrapolated from `sufficient` and from the nearest
    /// amounts with the same contact states beyond it, on the side away from `insufficient`. `None` if there is no such amount.
    pub(super) fn rest_ends(&self, sufficient: f64, insufficient: f64) -> Option<f64> {
        let lists = [self.known.borrow(), self.quick.borrow()];
        let mut behind = rests(&lists);
        keep(&mut behind, &|(at, _)| (at - sufficient) * (sufficient - insufficient) >= 0.0);
        sort_by_number(&mut behind, &|(at, _)| (at - sufficient).abs());
        let (_, here) = *behind.first().filter(|(at, _)| *at == sufficient)?;
        behind.dedup_by_key(|(at, _)| *at);
        keep(&mut behind, &|(_, there)| same_kinds(here, there));
        let mut nearest: Option<f64> = None;
        for (i, k) in (0..here.contacts.len()).flat_map(|i| [(i, 0), (i, 1)]) {
            let point = |n: usize| behind.get(n).map(|(at, rest)| (*at, rest.contacts[i].margins[k]));
            let Some(root) = where_it_vanishes([point(0), point(1), point(2)]) else { continue };
            let is_between = (root - sufficient) * (root - insufficient) < 0.0;
            let is_nearer = |other: f64| (root - sufficient).abs() < (other - sufficient).abs();
            if is_between && nearest.is_none_or(is_nearer) {
                nearest = Some(root);
            }
        }
        nearest
    }

    pub(super) fn known(&self, demand: Demand) -> Vec<(f64, Trial)> {
        let known = self.known.borrow();
        picked(&known, &|(at, trials)| Some((*at, trials.of(demand)?.clone())))
    }

    /// The range and number of amounts tried. Amounts closer together than those of a scan, tried to narrow a bracket, are counted as one amount.
    pub(super) fn amounts(&self, demand: Demand) -> TriedAmounts {
        let mut amounts: Vec<f64> = mapped(&self.known(demand), &|(at, _)| *at);
        if matches!(self.need.loads, Loads::AnyForce { .. }) {
            self.quick.borrow().iter().map(|(at, _)| *at).append_to(&mut amounts);
        }
        sort_by_number(&mut amounts, &|at| *at);
        let mut all = TriedAmounts { count: 0, from: f64::INFINITY, to: 0.0 };
        for at in amounts {
            if all.count == 0 || at - all.to > APART_IN_A_SCAN * at.abs() {
                all = TriedAmounts { count: all.count + 1, from: all.from.min(at), to: at };
            }
        }
        all
    }

    pub(super) fn plan(&self, look: SearchExtent) -> Result<SearchPlan, Error> {
        let (grasp, need) = (self.grasp, self.need);
        let (start, repeats) = (self.start, need.demand.repeats());
        let limits = match need.sought {
            Sought::Angle { .. } => [start / MOST_LOADS, start],
            Sought::Squeeze if !grasp.is_squeezed() => [start; 2],
            _ => [start / MOST_LOADS, start * MOST_LOADS],
        };
        let is_monotone = match need.sought {
            // A load grows from zero, and a turn begins at angle 0. If the grasp holds with one amount, its load path has therefore passed all
            // smaller amounts.
            Sought::Load | Sought::Angle { .. } => true,
            Sought::Squeeze => grasp.is_proportional() && need.base == Wrench::ZERO,
            Sought::Friction { .. } | Sought::Arm { .. } | Sought::Force { .. } | Sought::Overlaps => false,
        };
        let guess = match need.sought {
            Sought::Load | Sought::Angle { .. } => BoundEstimate::Times,
            Sought::Squeeze | Sought::Overlaps | Sought::Friction { .. } | Sought::Force { .. } => {
                BoundEstimate::Divided
            }
            Sought::Arm { .. } => BoundEstimate::Nothing,
        };
        let range = match self.range.get() {
            Some(range) => range,
            None => Range::of(grasp, need, self.safety, limits)?,
        };
        self.range.set(Some(range));
        let is_least = need.quantity().is_least();
        let guess = if repeats { BoundEstimate::Nothing } else { guess };
        Ok(SearchPlan {
            start,
            limits,
            range,
            is_least,
            guess,
            is_monotone: is_monotone && !repeats,
            everywhere: look != SearchExtent::Towards,
            enough: match look {
                SearchExtent::Around if grasp.space() == Space::Planar => EXACT,
                SearchExtent::Around => EXACT_IN_SPACE,
                SearchExtent::Everywhere(_) | SearchExtent::Towards => SECOND,
            },
        })
    }
}

/// The amounts for which an equilibrium at rest is known, each with its contact states.
fn rests<'l>(lists: &'l [Ref<'l, Vec<(f64, Trials)>>; 2]) -> Vec<(f64, &'l AtRest)> {
    let mut all = Vec::new();
    for list in lists {
        all.extend(picked(list, &|(at, trials)| Some((*at, trials.at_rest.as_ref()?))));
    }
    all
}

/// Adds the results for an amount to a list, and returns the result for the demand.
fn kept(list: &RefCell<Vec<(f64, Trials)>>, amount: f64, trials: Trials, demand: Demand) -> Trial {
    let trial = trials.of(demand).cloned();
    list.borrow_mut().push((amount, trials));
    trial.unwrap_or_else(|| Trial::Unknown(String::new()))
}

/// The result in a list for this amount and demand, if it was tried.
fn of(trials: &RefCell<Vec<(f64, Trials)>>, amount: f64, demand: Demand) -> Option<Trial> {
    trials.borrow().iter().find(|(at, _)| *at == amount).and_then(|(_, trials)| trials.of(demand).cloned())
}

/// Whether each contact has the same kind of state (open, sticking, sliding or frictionless) in both equilibria at rest.
fn same_kinds(one: &AtRest, other: &AtRest) -> bool {
    let (one, other) = (&one.contacts, &other.contacts);
    one.len() == other.len() && one.iter().zip(other).all(|(one, other)| one.kind == other.kind)
}
