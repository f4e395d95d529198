//! Contacts that all stick under a base load, and the probability that one of them leaves on the way to a further load on top of it.
//!
//! While all stick, forces are linear in the load, and margins are concave functions of it. So if all contacts stick at both ends of the way, they
//! stick in between. [`failure`](super::failure) gives the probability that a contact leaves there; the sum over contacts bounds the probability that
//! any does.

use super::courses::Course;
use super::failure::{MarginPair, failure, roughly};
use super::margin::{Effect, LOOKED_AT, UncertainForce, effect};
use super::tolerances::PRECISE_FACTOR;
use crate::contact::Edges;
use crate::grasp::{Space, Wrench};
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{Each, IntoList, dot, largest, normal_tail};
use crate::prelude::*;

/// A grasp that sticks under its base load.
#[derive(Debug, Clone)]
pub(super) struct StuckGrasp {
    space: Space,
    edges: Vec<Edges>,
    /// Forces by each component of the load.
    by_component: Vec<Course>,
    /// `base`: all forces under the base load. `by_base_load`: the part of them that this load alone causes.
    base: Course,
    by_base_load: Course,
    /// Failure probability of each contact under the base load.
    fails_at_base: Vec<f64>,
    sigmas: f64,
    /// σ of friction, and the relative growth of the load at each multiple in `LOOKED_AT`.
    friction: f64,
    load: [f64; LOOKED_AT.len()],
    /// Work of each component of the load on the motions that nothing resists.
    unresisted: Vec<Wrench<3>>,
}

impl StuckGrasp {
    /// From the courses of commands and of each component of the load.
    pub(super) fn new(
        space: Space,
        edges: Vec<Edges>,
        mut courses: Vec<Course>,
        load: &Wrench<3>,
        unresisted: Vec<Wrench<3>>,
        [sigmas, friction, load_spread]: [f64; 3],
    ) -> Self {
        let by_component = courses.split_off(1);
        let by_base_load = Course::of(&by_component, space, load);
        let mut base = by_base_load.clone();
        base.add(1.0, &courses[0]);
        let load = LOOKED_AT.each(|part| (load_spread * sigmas * part).exp_m1());
        let fails_at_base = Vec::new();
        let mut sticking = Self {
            space,
            edges,
            by_component,
            base,
            by_base_load,
            fails_at_base,
            sigmas,
            friction,
            load,
            unresisted,
        };
        let (mut margins, mut memory) = (MarginPair::default(), Vec::new());
        let alone = |(i, edges): (usize, &Edges)| {
            failure(edges, &sticking.spread(i, None, &mut memory), None, &mut margins)
        };
        sticking.fails_at_base = sticking.edges.iter().enumerate().map(alone).list();
        sticking
    }

    /// The allowed failure probability.
    fn allowed(&self) -> f64 {
        // Joint effects of two data are neglected, and may be a fifth of the allowed probability.
        (1.0 - 0.2) * normal_tail(self.sigmas)
    }

    /// The largest load factor with at most the allowed failure probability.
    pub(super) fn most(&self, direction: &Wrench<3>) -> f64 {
        let size = largest(direction.components(), &|x| x.abs());
        let work = |motion: &Wrench<3>| dot(motion.components(), direction.components());
        if self.unresisted.iter().any(|motion| work(motion).abs() > SOLVED_ROUNDING * size) {
            return 0.0;
        }
        let rate = Course::of(&self.by_component, self.space, direction);
        // Reliabilities are nearly linear in the load factor, unlike probabilities.
        let allowed = reliability(self.allowed());
        let left = |factor: f64| allowed - reliability(self.failure(&rate, factor));
        if allowed >= reliability(self.fails_at_base.iter().sum()) {
            return 0.0;
        }
        let (here, growth) = (self.base.largest().max(self.by_base_load.largest()), rate.largest());
        if growth == 0.0 {
            return f64::INFINITY;
        }
        let start = here.max(f64::MIN_POSITIVE) / growth;
        let roughly = |factor: f64| allowed - reliability(self.roughly(&rate, factor));
        // A load has no limit if its forces may exceed the forces under the base load by this factor.
        let far = 1e6;
        // Forces linearised in the data give a starting value.
        let guess = root(&roughly, (start, f64::NAN), far * start, 1e-3);
        let guess = if guess > 0.0 && guess.is_finite() { guess } else { start };
        // Relative step of the difference quotient that gives the initial slope.
        let apart = 1e-3;
        let slope = (roughly((1.0 + apart) * guess) - roughly(guess)) / (apart * guess);
        root(&left, (guess, slope), far * start, PRECISE_FACTOR)
    }

    /// Sum of the first-order failure probabilities of all contacts under the load times this factor.
    fn roughly(&self, rate: &Course, factor: f64) -> f64 {
        let mut memory = Vec::new();
        let mut sum = 0.0;
        for (i, edges) in self.edges.iter().enumerate() {
            sum += roughly(edges, &self.spread(i, Some((rate, factor)), &mut memory));
        }
        sum
    }

    /// Upper bound of the probability that some contact leaves on the way to this load factor.
    fn failure(&self, rate: &Course, factor: f64) -> f64 {
        let mut memory = [Vec::new(), Vec::new()];
        let mut margins = MarginPair::default();
        // Failures at the base that are rarer than this are added in full, although some of them also fail at the load.
        let told_apart = 1e-3 * self.allowed();
        let mut sum = 0.0;
        for (i, edges) in self.edges.iter().enumerate() {
            let [there, base] = &mut memory;
            let there = self.spread(i, Some((rate, factor)), there);
            sum += failure(edges, &there, None, &mut margins);
            let at_base = self.fails_at_base[i];
            sum += if at_base > told_apart {
                failure(edges, &self.spread(i, None, base), Some(&there), &mut margins)
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
        more: Option<(&Course, f64)>,
        changes: &'m mut Vec<Effect>,
    ) -> UncertainForce<'m> {
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
            changes.push(effect(self.load.each(|more| of_load * more)));
        }
        UncertainForce { force, changes, sigmas: self.sigmas, friction: self.friction }
    }
}

/// Approximately the β of a failure probability `Φ(-β)`, and as nearly linear in the load factor; only differences are used.
fn reliability(fails: f64) -> f64 {
    // Probabilities below 1e-300 count as 1e-300.
    (-2.0 * fails.clamp(1e-300, 1.0).ln()).sqrt()
}

/// The root of an increasing function that is negative at zero, to the relative accuracy `precise`. The lower end of the last bracket is returned, or
/// infinity without a root up to `end`. Secant steps start from a guess and a slope (NaN if unknown), and stay within the bracket.
fn root(f: &dyn Fn(f64) -> f64, (guess, mut slope): (f64, f64), end: f64, precise: f64) -> f64 {
    let (mut low, mut high) = (0.0, f64::INFINITY);
    let (mut at, mut last) = (guess, None);
    for step in 0..100 {
        let value = f(at);
        if value < 0.0 {
            low = at;
        } else {
            high = at;
        }
        if low > end {
            return f64::INFINITY;
        }
        if high.is_finite() && high - low <= precise * high.max(precise * guess) {
            break;
        }
        if let Some((from, before)) = last {
            slope = (value - before) / (at - from);
        }
        last = Some((at, value));
        // Secants are slow where a function is far from linear, so that every other later step bisects.
        let halves = step >= 12 && step % 2 == 0;
        let next = if halves { f64::NAN } else { at - value / slope };
        let near = 0.5 * precise * at;
        at = if next.is_finite() {
            // A margin of half the accuracy at both ends of the bracket: where a secant step hits the root, the next step is the last.
            next.min(high - near).min(4.0 * at).max(low + near).max(0.1 * at)
        } else if high.is_finite() {
            0.5 * (low + high)
        } else {
            2.0 * at
        };
    }
    low
}
