//! Contacts that all stick under a base load, and the probability that one of them leaves on the way to a load on top of it.
//!
//! While all stick, forces are linear in the load, and margins that fall do so ever more steeply. So all stick on the whole way if all do at
//! both of its ends. [`failure`](super::failure) gives the probability that a contact leaves there; their sum bounds the probability that any does.

use super::courses::{AllForces, Course};
use super::failure::{LimitState, MarginPair};
use super::margin::{Effect, LOOKED_AT, UncertainForce, effect};
use crate::grasp::Wrench;
use crate::numerics::normal_tail;
use crate::prelude::*;

/// Part of the allowed failure probability kept for joint effects of two data, which are neglected and may be as large.
const SPARED: f64 = 0.2;
/// What fails at the base as seldom, as a part of what may, needs not be told apart from what fails farther on.
const SELDOM: f64 = 1e-3;
/// Of the factor.
const PRECISE: f64 = 1e-8;
const MOST_STEPS: usize = 100;
/// Loads on a motion that nothing resists, as a part of their size: less is rounding.
const WORKS: f64 = 1e-12;
/// A load has no limit if its forces may exceed the forces under the base load by this factor.
const FAR: f64 = 1e6;

/// A grasp that sticks under its base load.
#[derive(Debug, Clone)]
pub(super) struct StuckGrasp<const C: usize> {
    edges: Vec<LimitState<C>>,
    forces: AllForces<C>,
    /// All forces under the base load, and the part of them by that load.
    base: Course<C>,
    by_base_load: Course<C>,
    /// Failure probability of each contact under the base load.
    fails_at_base: Vec<f64>,
    sigmas: f64,
    /// σ of friction, and the relative growth of the load at each part of `LOOKED_AT`.
    friction: f64,
    load: [f64; LOOKED_AT.len()],
    /// Work of each component of the load on the motions that nothing resists.
    unresisted: Vec<Wrench<C>>,
}

impl<const C: usize> StuckGrasp<C> {
    pub(super) fn new(
        edges: Vec<LimitState<C>>,
        forces: AllForces<C>,
        base: &Wrench<C>,
        unresisted: Vec<Wrench<C>>,
        [sigmas, friction, load]: [f64; 3],
    ) -> Self {
        let by_base_load = Course::of(&forces, base);
        let base = Course::commanded(&forces).and(&by_base_load);
        let load = LOOKED_AT.map(|part| (load * sigmas * part).exp_m1());
        let mut sticking = Self {
            edges,
            forces,
            base,
            by_base_load,
            fails_at_base: Vec::new(),
            sigmas,
            friction,
            load,
            unresisted,
        };
        let (mut margins, mut memory) = (MarginPair::default(), Vec::new());
        let alone = |(i, edges): (usize, &LimitState<C>)| {
            edges.failure(&sticking.spread(i, None, &mut memory), None, &mut margins)
        };
        sticking.fails_at_base = sticking.edges.iter().enumerate().map(alone).collect();
        sticking
    }

    /// The allowed failure probability.
    fn allowed(&self) -> f64 {
        (1.0 - SPARED) * normal_tail(self.sigmas)
    }

    /// The largest factor with at most the allowed failure probability.
    pub(super) fn most(&self, direction: &Wrench<C>) -> f64 {
        let size = direction.components().iter().map(|x| x.abs()).fold(0.0, f64::max);
        let work = |motion: &Wrench<C>| {
            motion.components().iter().zip(direction.components()).map(|(v, w)| v * w).sum::<f64>()
        };
        if self.unresisted.iter().any(|motion| work(motion).abs() > WORKS * size) {
            return 0.0;
        }
        let rate = Course::of(&self.forces, direction);
        // Nearly straight in the factor, as reliabilities are.
        let left = |factor: f64| reliability(self.allowed()) - reliability(self.failure(&rate, factor));
        if left(0.0) >= 0.0 {
            return 0.0;
        }
        let (here, growth) = (self.base.largest().max(self.by_base_load.largest()), rate.largest());
        if growth == 0.0 {
            return f64::INFINITY;
        }
        let mut high = here.max(f64::MIN_POSITIVE) / growth;
        let end = FAR * high;
        let mut low = 0.0;
        while left(high) < 0.0 {
            if high > end {
                return f64::INFINITY;
            }
            (low, high) = (high, 2.0 * high);
        }
        root(left, low, high)
    }

    /// How often some contact leaves on the way to this factor, at most.
    fn failure(&self, rate: &Course<C>, factor: f64) -> f64 {
        let mut memory = [Vec::new(), Vec::new()];
        let mut margins = MarginPair::default();
        let mut sum = 0.0;
        for (i, edges) in
            self.edges.iter().enumerate().filter(|(_, edges)| !matches!(edges, LimitState::None))
        {
            let [there, base] = &mut memory;
            let there = self.spread(i, Some((rate, factor)), there);
            sum += edges.failure(&there, None, &mut margins);
            let at_base = self.fails_at_base[i];
            sum += if at_base > SELDOM * self.allowed() {
                edges.failure(&self.spread(i, None, base), Some(&there), &mut margins)
            } else {
                at_base
            };
        }
        sum
    }

    /// The force of a contact under the base load plus, if given, a factor times another load, with its changes by the data.
    fn spread<'m>(
        &self,
        i: usize,
        more: Option<(&Course<C>, f64)>,
        changes: &'m mut Vec<Effect<C>>,
    ) -> UncertainForce<'m, C> {
        changes.clear();
        changes.extend(self.base.off.iter().map(|of_datum| of_datum[i]));
        let (mut force, mut of_load) = (self.base.known[i], self.by_base_load.known[i]);
        if let Some((rate, factor)) = more {
            for (change, of_datum) in changes.iter_mut().zip(&rate.off) {
                change.iter_mut().zip(&of_datum[i]).for_each(|(change, rate)| *change += rate * factor);
            }
            force += rate.known[i] * factor;
            of_load += rate.known[i] * factor;
        }
        if self.load.iter().any(|more| *more != 0.0) {
            changes.push(effect(self.load.map(|more| of_load * more)));
        }
        UncertainForce { force, changes, sigmas: self.sigmas, friction: self.friction }
    }
}

/// About the β of a failure probability `Φ(-β)`, and as nearly linear; only its differences are used.
fn reliability(fails: f64) -> f64 {
    // Smaller probabilities count as this one.
    const LEAST: f64 = 1e-300;
    (-2.0 * fails.clamp(LEAST, 1.0).ln()).sqrt()
}

/// Where a function that is negative at `low` and not at `high` passes zero, from below: by the method of the false position, after Illinois.
fn root(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let (mut at_low, mut at_high) = (f(low), f(high));
    for _ in 0..MOST_STEPS {
        if high - low <= PRECISE * high {
            break;
        }
        let next = (low * at_high - high * at_low) / (at_high - at_low);
        let next = if next > low && next < high { next } else { 0.5 * (low + high) };
        let value = f(next);
        if value < 0.0 {
            (low, at_low) = (next, value);
            at_high *= 0.5;
        } else {
            (high, at_high) = (next, value);
            at_low *= 0.5;
        }
    }
    low
}
