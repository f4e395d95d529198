//! A grasp in which all contacts stick under a base load, and the probability that one of them ceases to stick before a further load is applied in
//! full. The load factor is the multiple of the further load. The required reliability `sigmas` is a number of standard deviations: the allowed
//! probability is about Φ(-sigmas), with the normal distribution Φ. A facet is a plane that bounds a polygonal friction cone, or one that touches a
//! round cone; in the code the facets of a cone are edges. A source is one cause of contact forces. A drive is the spring of a joint or tendon of a
//! hand, with its force limit.
//!
//! While all contacts stick, forces are linear in the load, and margins are concave functions of it. Thus, if all contacts stick under the base load
//! and with the whole further load, they stick in between. [`failure`](super::failure) gives the probability that a contact fails, i.e. ceases to
//! stick, under one of these two loads. [`union`](super::union) bounds the probability that any contact fails. "Errors" are the errors of the
//! uncertain data. Their [interaction](super::interaction) is the change of a contact force due to all errors together, less the sum of the changes
//! due to single errors.

use core::cell::OnceCell;

use super::failure::{failures, roughly};
use super::interaction::PerturbedGrasp;
use super::margin::{Effect, FacetMargin, Interaction, LOOKED_AT, UncertainForce, effect};
use super::source_forces::SourceForces;
use super::tolerances::{NEGLECTED_SHARE, PRECISE_FACTOR, RARE_SHARE};
use super::union::Failures;
use crate::contact::Edges;
use crate::grasp::Wrench;
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{Each, IntoList, add_times, dot, largest, normal_tail};
use crate::prelude::*;

/// Number of rounds in which two quantities that depend on each other are computed: the smallest errors with which a margin vanishes, and the
/// interactions of the errors of data at this point. The first round finds the smallest errors without interactions, and computes the interactions
/// there. The second round finds the smallest errors with these interactions.
const ROUNDS: usize = 2;

/// One list for each contact or drive, with one entry for each facet of a polygonal friction cone, or a single entry for a round cone: how the errors
/// of all data together change the contact force, beyond the sum of the changes due to single errors.
type Interactions = Vec<Vec<Interaction>>;

/// A load added to the base load: `factor` times `direction`. One unit of `direction` causes the forces `rate`.
#[derive(Clone, Copy)]
struct AddedLoad<'a> {
    direction: &'a Wrench<3>,
    rate: &'a SourceForces,
    factor: f64,
}

/// A grasp in which no contact slides under the base load. It has the contact forces for each source: the commands (displacements that the fingers
/// would make if there were no object), and each component of the load. It also has the failures of contacts that errors of the data may cause under
/// the base load.
#[derive(Debug, Clone)]
pub(super) struct StuckGrasp {
    off: PerturbedGrasp,
    edges: Vec<Edges>,
    /// For each contact point the index of the first point of the same contact; points with one index share one coefficient of friction. For a drive
    /// its own index.
    contacts: Vec<usize>,
    /// The base load, N and N m, under which no contact slides.
    base_load: Wrench<3>,
    /// For each component of the load, the forces that 1 N or 1 N m of it causes, and their changes due to errors of the data.
    by_component: Vec<SourceForces>,
    /// Contact forces under the commands and the base load.
    base: SourceForces,
    /// Contact forces that the base load alone causes.
    by_base_load: SourceForces,
    /// How the errors of all data together change the forces under the base load, beyond the sum of the changes due to single errors. The lists have
    /// one entry for each facet.
    joint_at_base: Interactions,
    /// The failures of contacts (they cease to stick) that errors of the data may cause under the base load.
    fails_at_base: Failures,
    sigmas: f64,
    /// Standard deviation σ of the logarithm of the coefficients of friction.
    friction: f64,
    /// For each entry x of [`LOOKED_AT`] (-1, -1/2, 1/2 and 1), the relative growth of the load if its logarithm is in error by `x · sigmas` standard
    /// deviations. Changes of forces are computed exactly at these four errors.
    load: [f64; LOOKED_AT.len()],
    /// For each motion of the object that nothing resists, the work that 1 N or 1 N m of each component of the load does along this motion.
    unresisted: Vec<Wrench<3>>,
}

impl StuckGrasp {
    /// Computes, under the base load, the interactions of the errors of data and the failures (contacts that cease to stick) that these errors may
    /// cause. `source_forces` has, for each source, the contact forces and their changes due to errors of the data. The first source is commands
    /// together with constant loads; then comes each component of the load.
    pub(super) fn new(
        off: PerturbedGrasp,
        edges: Vec<Edges>,
        mut source_forces: Vec<SourceForces>,
        base_load: &Wrench<3>,
        unresisted: Vec<Wrench<3>>,
        [sigmas, friction]: [f64; 2],
    ) -> Self {
        let by_component = source_forces.split_off(1);
        let by_base_load = SourceForces::of(&by_component, off.grasp.space(), base_load);
        let mut base = by_base_load.clone();
        base.add(1.0, &source_forces[0]);
        let load = LOOKED_AT.each(|part| (off.load_spread * sigmas * part).exp_m1());
        let mut contacts = (0..edges.len()).list();
        for whole in off.grasp.wholes().iter() {
            contacts[whole.range.clone()].fill(whole.range.start);
        }
        let joint_at_base = vec![Vec::new(); edges.len()];
        let fails_at_base = Failures::default();
        let mut sticking = Self {
            off,
            edges,
            contacts,
            base_load: *base_load,
            by_component,
            base,
            by_base_load,
            joint_at_base,
            fails_at_base,
            sigmas,
            friction,
            load,
            unresisted,
        };
        for _ in 0..ROUNDS {
            sticking.joint_at_base = sticking.joint(None, &sticking.joint_at_base);
        }
        sticking.fails_at_base = sticking.failures(None, &sticking.joint_at_base);
        sticking
    }

    /// The allowed probability that any contact ceases to stick: `Φ(-sigmas)`, reduced by a quarter ([`NEGLECTED_SHARE`]), because some effects of
    /// the interactions of data errors are neglected.
    fn allowed(&self) -> f64 {
        (1.0 - NEGLECTED_SHARE) * normal_tail(self.sigmas)
    }

    /// The interactions of the errors of data under the base load and, if given, the further load `more`. The interaction for a facet is computed at
    /// the smallest errors with which the margin of this facet vanishes. These errors are computed with the interactions `before` of the previous
    /// round.
    fn joint(&self, more: Option<AddedLoad<'_>>, before: &Interactions) -> Interactions {
        let load = more.map_or(self.base_load, |more| self.base_load + *more.direction * more.factor);
        let mut memory = Vec::new();
        let (mut joint, probed) = (Vec::new(), OnceCell::new());
        for (i, edges) in self.edges.iter().enumerate() {
            let here = self.spread(i, more, before, &mut memory);
            let probes = || &probed.get_or_init(|| self.off.probes(&load, here.changes.len()))[..];
            joint.push(self.off.of_facets((i, edges), &load, (&here, &probes), RARE_SHARE * self.allowed()));
        }
        joint
    }

    /// The largest factor on the further load `direction` with at most the allowed failure probability. Zero if the load does work along a motion
    /// that nothing resists, or if the failure probability under the base load alone exceeds the allowed one. Infinite if the factor has no limit.
    pub(super) fn most(&self, direction: &Wrench<3>) -> f64 {
        let size = largest(direction.components(), &|x| x.abs());
        let work = |motion: &Wrench<3>| dot(motion.components(), direction.components());
        if self.unresisted.iter().any(|motion| work(motion).abs() > SOLVED_ROUNDING * size) {
            return 0.0;
        }
        let rate = SourceForces::of(&self.by_component, self.off.grasp.space(), direction);
        // The search compares reliabilities (distances from failure, in standard deviations), because they are nearly linear in the load factor;
        // probabilities are not.
        let allowed = reliability(self.allowed());
        let further = |factor: f64| AddedLoad { direction, rate: &rate, factor };
        if allowed >= reliability(self.fails_at_base.any(&Failures::default())) {
            return 0.0;
        }
        let (here, growth) = (self.base.largest().max(self.by_base_load.largest()), rate.largest());
        if growth == 0.0 {
            return f64::INFINITY;
        }
        let start = here.max(f64::MIN_POSITIVE) / growth;
        let roughly = |factor: f64| allowed - reliability(self.roughly(further(factor)));
        // If no failure is found up to forces that are this multiple of the forces under the base load, the load factor is taken as infinite.
        let far = 1e6;
        // A search with forces linearised in the data gives the starting value of the load factor.
        let guess = root(&roughly, (start, f64::NAN), far * start, 1e-3);
        let guess = if guess > 0.0 && guess.is_finite() { guess } else { start };
        // The first secant step needs the derivative of the reliability with respect to the load factor. This derivative is approximated by a
        // difference quotient over this relative step of the load factor.
        let apart = 1e-3;
        let slope = (roughly((1.0 + apart) * guess) - roughly(guess)) / (apart * guess);
        let (mut most, mut joint) = (guess, self.joint_at_base.clone());
        for _ in 0..ROUNDS {
            joint = self.joint(Some(further(most)), &joint);
            let fails = |factor: f64| self.failures(Some(further(factor)), &joint).any(&self.fails_at_base);
            let left = |factor: f64| allowed - reliability(fails(factor));
            most = root(&left, (most, slope), far * start, PRECISE_FACTOR);
            if self.off.data.is_empty() || most == 0.0 || most.is_infinite() {
                break;
            }
        }
        most
    }

    /// The sum of the first-order failure probabilities of all contacts under the base load and this further load.
    fn roughly(&self, more: AddedLoad<'_>) -> f64 {
        let mut memory = Vec::new();
        let mut sum = 0.0;
        for (i, edges) in self.edges.iter().enumerate() {
            sum += roughly(edges, &self.spread(i, Some(more), &self.joint_at_base, &mut memory));
        }
        sum
    }

    /// The possible failures of all contacts and drives under the base load; with `more`, under the base load and this further load.
    fn failures(&self, more: Option<AddedLoad<'_>>, joint: &Interactions) -> Failures {
        let (mut margin, mut memory, mut events) = (FacetMargin::default(), Vec::new(), Failures::default());
        for (i, edges) in self.edges.iter().enumerate() {
            let here = self.spread(i, more, joint, &mut memory);
            failures((self.contacts[i], edges), &here, RARE_SHARE * self.allowed(), &mut margin, &mut events);
        }
        events
    }

    /// The force on contact or drive `i` under the base load and, if given, a further load. It includes the changes due to errors of the data and of
    /// the load.
    fn spread<'m>(
        &self,
        i: usize,
        more: Option<AddedLoad<'_>>,
        joint: &'m Interactions,
        changes: &'m mut Vec<Effect>,
    ) -> UncertainForce<'m> {
        changes.clear();
        self.base.off.iter().map(|of_datum| of_datum[i]).append_to(changes);
        let (mut force, mut of_load) = (self.base.known[i], self.by_base_load.known[i]);
        if let Some(AddedLoad { rate, factor, .. }) = more {
            for (change, of_datum) in changes.iter_mut().zip(&rate.off) {
                add_times(change, &of_datum[i], factor);
            }
            force += rate.known[i] * factor;
            of_load += rate.known[i] * factor;
        }
        if self.load.iter().any(|more| *more != 0.0) {
            changes.push(effect(self.load.each(|more| of_load * more)));
        }
        UncertainForce { force, changes, joint: &joint[i], sigmas: self.sigmas, friction: self.friction }
    }
}

/// An approximate reliability β with about `Φ(-β) = fails`. Only differences of it are used, and they are nearly linear in the load factor, like
/// differences of β.
fn reliability(fails: f64) -> f64 {
    // Smaller probabilities are taken as 1e-300, so that the logarithm is finite.
    (-2.0 * fails.clamp(1e-300, 1.0).ln()).sqrt()
}

/// The root of an increasing function that is negative at zero, to the relative accuracy `precise`. The returned number is the lower end of the last
/// bracket of the root, or infinite if the function is still negative beyond `end`. Secant steps start from a guess of the root and from the
/// derivative `slope` (NaN if unknown), and stay within the bracket.
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
        // Secant steps are slow if the function is far from linear. Therefore, from the twelfth step on, every second step is a bisection.
        let halves = step >= 12 && step % 2 == 0;
        let next = if halves { f64::NAN } else { at - value / slope };
        let near = 0.5 * precise * at;
        at = if next.is_finite() {
            // Each trial stays half the required accuracy away from both ends of the bracket. Thus, if a secant step hits the root, the next trial
            // ends the search.
            next.min(high - near).min(4.0 * at).max(low + near).max(0.1 * at)
        } else if high.is_finite() {
            0.5 * (low + high)
        } else {
            2.0 * at
        };
    }
    low
}
