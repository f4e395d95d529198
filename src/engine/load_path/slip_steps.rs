//! A step along a growing load, and the first event in the step, i.e. the first change of a contact's state. A path point is a list of the number 1,
//! the load factor and the slips of sliding contacts (m), from which [`Slips`] computes forces and twist. Arclength is measured along the curve of
//! the slips, divided by a unit of slip, and the load factor. A margin is the distance of a force from the boundary of its friction cone. The
//! conditions of this file have values that must stay positive along a step; the comment of [`GROWS`] lists them in their order.

use super::slip_rates::Slips;
use super::tolerances::LITTLE_NORMAL_FORCE;
use super::within_a_step::BoundedCubic;
use crate::contact::tangential_norm;
use crate::numerics::tolerances::{NEGLIGIBLE, SOLVED_ROUNDING};
use crate::numerics::{
    Each, Stepped, chosen, explicit_step, largest, lowest, numbered, paired, regula_falsi,
};
use crate::prelude::*;

/// The end of a step of arclength `length` along which contacts slide or stick. It has the path point `at`, its rates per unit of arclength, and the
/// step's estimated relative error.
pub(super) struct SlipStep {
    pub(super) length: f64,
    pub(super) at: Vec<f64>,
    pub(super) rates: Vec<f64>,
    pub(super) error: f64,
    /// The values at the end of the step of the conditions that must stay positive, in the order described at [`GROWS`].
    pub(super) values: Vec<f64>,
}
/// Index, from 0, of the condition that the load factor grows, in the list of conditions that must hold along a step. Each condition is a value
/// that must stay positive. After the conditions [`GROWS`], [`GOES_ON`] and [`SMALL`] come the slip rates of sliding contacts along their
/// friction forces, and then their normal forces. Last come the margins of sticking contacts, `μ F_n - |F_t|`.
pub(super) const GROWS: usize = 0;
/// Index, in the list described at [`GROWS`], of the condition that the load factor is below [`Slips::most`], up to which the load is followed.
pub(super) const GOES_ON: usize = 1;
/// Index, in the list described at [`GROWS`], of the condition that all motions are within the limits of small motions.
pub(super) const SMALL: usize = 2;
impl Slips<'_> {
    /// A step of the arclength `length` from the path point `at` with the rates `rates`; `None` if rates are not unique somewhere in the step.
    pub(super) fn step(&self, (at, rates): (&[f64], &[f64]), length: f64) -> Option<SlipStep> {
        let mut there = at.to_vec();
        let rate = |change: &[f64], out: &mut [f64]| {
            there
                .iter_mut()
                .zip(at.iter().zip(change))
                .for_each(|(there, (at, change))| *there = at + change);
            self.flow(&there, rates, out)
        };
        let slips = |state: &[f64]| largest(&state[2..], &|slip| slip.abs());
        let travel = slips(at) + self.unit * length;
        let size = |error: &[f64]| {
            let off = |i: usize| self.force(i, error).norm() / self.largest;
            (0..self.contacts()).map(off).fold(slips(error) / travel, f64::max)
        };
        let Stepped { change, error } = explicit_step(length, rates, rate, size)?;
        let at: Vec<f64> = paired(at, &change, &|(at, change)| at + change);
        let mut there = vec![0.0; at.len()];
        self.flow(&at, rates, &mut there)?;
        let values = self.conditions(&at, &there);
        Some(SlipStep { length, at, rates: there, error, values })
    }

    /// The step `end` from the path point and rates `from`, if all conditions hold in it. Otherwise the step is shortened to the first event, where
    /// the value of a condition becomes zero. The index of this condition in the list of [`GROWS`] is returned, too; `None` for the whole step.
    ///
    /// The result is `None` if several values become zero together, or if a value is not positive at the start. `None` also if the end of the
    /// shortened step is not found.
    pub(super) fn up_to_an_event(
        &self,
        from: (&[f64], &[f64]),
        mut end: SlipStep,
        tolerance: f64,
    ) -> Option<(SlipStep, Option<usize>)> {
        let start = self.conditions(from.0, from.1);
        if start.iter().any(|value| *value <= 0.0) {
            return None;
        }
        // The force of a sticking contact may leave its cone and return within the step. The step is then shortened to where the force is outside,
        // and the event is sought again, at most twenty times.
        for _ in 0..20 {
            let mut event = None;
            if let Some(k) = first_crossing(&start, &end.values) {
                let (there, met) = self.located(from, &start, end, k)?;
                (end, event) = (there, Some(met));
                if end.values.iter().enumerate().any(|(k, value)| k != met && *value <= NEGLIGIBLE) {
                    return None;
                }
            }
            let Some(part) = self.first_dip(from, &end, tolerance) else { return Some((end, event)) };
            end = self.step(from, part * end.length)?;
        }
        None
    }

    /// The step that ends at the first event, and the index of the condition whose value becomes zero there. This is condition `k`, or another
    /// condition whose value becomes zero earlier. `None` if thirty trials do not find the zero.
    ///
    /// Each trial is a step that ends at the root of a cubic polynomial. This cubic has the values of condition `k`, and its derivatives with respect
    /// to arclength, at both ends of a bracket. As a rule the first trial is close enough.
    fn located(
        &self,
        from: (&[f64], &[f64]),
        start: &[f64],
        mut end: SlipStep,
        k: usize,
    ) -> Option<(SlipStep, usize)> {
        let mut low = (0.0, start[k], self.slope(k, from, end.length)?);
        let mut high = (end.length, end.values[k], self.slope(k, (&end.at, &end.rates), end.length)?);
        let mut there = high;
        for _ in 0..30 {
            // If the end of the step is within this fraction of its length from the root of the condition, Heun's method moves the end to the root.
            // The error of this method is of third order in the distance. At so small a distance it is less than the error of one more trial step.
            let rest = -there.1 / there.2;
            if rest.abs() <= 1e-4 * end.length {
                return self.moved_to(k, end, rest).zip(Some(k));
            }
            let cubic = &mut |to: f64| between(low, high, to);
            let near = regula_falsi([(low.0, low.1), (high.0, high.1)], 1e-12, cubic);
            let to = near.filter(|to| *to < high.0).unwrap_or(0.5 * (low.0 + high.0));
            end = self.step(from, to)?;
            match first_crossing(start, &end.values) {
                Some(other) if other != k => return self.located(from, start, end, other),
                crossing => {
                    there = (to, end.values[k], self.slope(k, (&end.at, &end.rates), to)?);
                    *(if crossing.is_some() { &mut high } else { &mut low }) = there;
                }
            }
        }
        None
    }

    /// The end of a step, moved by Heun's method to where the value of condition `k` becomes zero, an arclength of about `rest` away. `None` if the
    /// iteration does not converge.
    fn moved_to(&self, k: usize, mut end: SlipStep, mut rest: f64) -> Option<SlipStep> {
        let length = end.length;
        // Each Newton iteration squares the relative distance from the root or gains the six digits of the derivative, whichever is less. From a
        // distance of 1e-4, three iterations thus leave only rounding.
        for _ in 0..3 {
            let (from, mut ahead) = (end.at.clone(), end.rates.clone());
            let moved = |rate: &[f64]| -> Vec<f64> { paired(&from, rate, &|(at, rate)| at + rest * rate) };
            self.flow(&moved(&end.rates), &end.rates, &mut ahead)?;
            ahead.iter_mut().zip(&end.rates).for_each(|(ahead, rate)| *ahead = 0.5 * (*ahead + rate));
            end.at = moved(&ahead);
            self.flow(&end.at, &ahead, &mut end.rates)?;
            end.length += rest;
            rest = -self.condition(k, &end.at, &end.rates) / self.slope(k, (&end.at, &end.rates), length)?;
            if rest.abs() <= SOLVED_ROUNDING * length {
                break;
            }
        }
        end.values = self.conditions(&end.at, &end.rates);
        // The end is accepted if the arclength `rest` still missing is less than the fraction `NEGLIGIBLE` of the step. At a maximum of the load
        // factor, an error of arclength changes the load factor only by its square.
        (rest.abs() <= NEGLIGIBLE * length).then_some(end)
    }

    /// The derivative of the value of condition `k` with respect to arclength at the path point `at`, from a difference over a millionth of `length`.
    /// `None` if the rates are not unique.
    fn slope(&self, k: usize, (at, rates): (&[f64], &[f64]), length: f64) -> Option<f64> {
        // The difference quotient is taken over this arclength. The derivative then has about six correct digits, so that a Newton iteration gains at
        // most six digits.
        let little = 1e-6 * length;
        let ahead: Vec<f64> = paired(at, rates, &|(at, rate)| at + little * rate);
        let mut rates_ahead = vec![0.0; at.len()];
        self.flow(&ahead, rates, &mut rates_ahead)?;
        Some((self.condition(k, &ahead, &rates_ahead) - self.condition(k, at, rates)) / little)
    }

    /// The fraction of the step `end` at which a sticking contact is outside its friction cone, by more than the error of margins; the least over all
    /// sticking contacts. The force may be inside the cone again at the end of the step. If the interpolated force of a contact leaves open whether
    /// it is ever outside, the fraction for this contact is one half: the caller then halves the step. `None` if all forces stay inside their cones.
    fn first_dip(&self, (at, rates): (&[f64], &[f64]), end: &SlipStep, tolerance: f64) -> Option<f64> {
        let mut first: Option<f64> = None;
        for i in self.sticking() {
            let values = [at, &end.at].each(|at| self.force(i, at));
            let changes = [rates, &end.rates].each(|rates| self.force(i, rates) * end.length);
            let cone = Some(self.problem.cone(i));
            let dip = BoundedCubic::new((values, changes), cone, (self.largest, tolerance)).violated_at();
            first = dip.map_or(first, |dip| Some(first.map_or(dip, |first| first.min(dip))));
        }
        first
    }
    /// The values, at the path point `at` with the rates `rates`, of the conditions that must stay positive, in the order described at [`GROWS`].
    fn conditions(&self, at: &[f64], rates: &[f64]) -> Vec<f64> {
        numbered(SMALL + 1 + self.sliding.len() + self.contacts(), &|k| self.condition(k, at, rates))
    }

    fn condition(&self, k: usize, at: &[f64], rates: &[f64]) -> f64 {
        let force = |contact: usize| self.force(contact, at);
        match (k, k.saturating_sub(SMALL + 1)) {
            (GROWS, _) => rates[1],
            (GOES_ON, _) => 1.0 - at[1] / self.most,
            (SMALL, _) => 1.0 - self.far(at),
            (_, i) if i < self.sliding.len() => {
                let friction = force(self.sliding[i]);
                let slips = friction[1] * rates[2 + 2 * i] + friction[2] * rates[3 + 2 * i];
                slips / (tangential_norm(&friction) * self.unit)
            }
            (_, i) if i < 2 * self.sliding.len() => {
                force(self.sliding[i - self.sliding.len()])[0] / self.largest - LITTLE_NORMAL_FORCE
            }
            (_, i) => {
                let contact = self.sticking().nth(i - 2 * self.sliding.len()).unwrap_or(0);
                self.problem.cone(contact).round_margin(&force(contact)) / self.largest
            }
        }
    }

    /// Arclength of the first step: the longest for which three conditions hold at the present rates. No direction of friction turns by more than 0.3
    /// rad. No normal force of a sliding contact falls to less than half. The load factor does not exceed [`Slips::most`].
    pub(super) fn first_length(&self, at: &[f64], rates: &[f64]) -> f64 {
        let mut length = (self.most - at[1]) / rates[1];
        for i in &self.sliding {
            let (f, df) = (self.force(*i, at), self.force(*i, rates));
            let turn = (f[1] * df[2] - f[2] * df[1]).abs() / (f[1] * f[1] + f[2] * f[2]);
            length = length.min(0.3 / turn).min(0.5 * f[0] / (-df[0]).max(0.0));
        }
        length
    }
}

/// The value at the argument `to` of the cubic polynomial with given values and derivatives at two arguments, each given as (argument, value,
/// derivative).
fn between(low: (f64, f64, f64), high: (f64, f64, f64), to: f64) -> f64 {
    let length = high.0 - low.0;
    let (part, rise) = ((to - low.0) / length, high.1 - low.1);
    let (before, behind) = (low.2 * length - rise, rise - high.2 * length);
    low.1 + part * (rise + (1.0 - part) * ((1.0 - part) * before + part * behind))
}

/// The index of the condition that is violated first in a step, among those violated at its end. The values of conditions are interpolated linearly
/// between the ends of the step. `None` if no condition is violated.
fn first_crossing(start: &[f64], end: &[f64]) -> Option<usize> {
    let part = |k: usize| start[k] / (start[k] - end[k]);
    lowest(&chosen(start.len(), &|k| end[*k] < 0.0), &|k| part(*k)).copied()
}
