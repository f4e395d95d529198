//! A step in the coordinates of slips, and the first event within it.

use super::slip_rates::Slips;
use super::tolerances::LITTLE_NORMAL_FORCE;
use super::within_a_step::Bounded;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Stepped, explicit_step, largest, paired, regula_falsi};
use crate::prelude::*;

/// The end of a step.
pub(super) struct SlipStep {
    pub(super) length: f64,
    pub(super) at: Vec<f64>,
    pub(super) rates: Vec<f64>,
    pub(super) error: f64,
    /// The conditions that must stay positive.
    pub(super) values: Vec<f64>,
}
/// Places among the conditions: the factor grows, it is below the largest one, motions are small. Then, for each sliding contact, γ and the normal force,
/// and the margins of all others.
pub(super) const GROWS: usize = 0;
pub(super) const GOES_ON: usize = 1;
pub(super) const SMALL: usize = 2;
impl Slips<'_> {
    /// A step of this length; `None` if no such step exists.
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
            (0..self.none.len()).map(off).fold(slips(error) / travel, f64::max)
        };
        let Stepped { change, error } = explicit_step(length, rates, rate, size)?;
        let at: Vec<f64> = paired(at, &change, &|(at, change)| at + change);
        let mut there = vec![0.0; at.len()];
        self.flow(&at, rates, &mut there)?;
        let values = self.conditions(&at, &there);
        Some(SlipStep { length, at, rates: there, error, values })
    }

    /// The step, shortened to the first condition that is met within it; `None` where several are.
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
        // Most times that a step is shortened because a condition may be violated within it.
        for _ in 0..20 {
            let mut event = None;
            if let Some(k) = first_crossing(&start, &end.values) {
                end = self.located(from, &start, end, k)?;
                event = first_crossing(&start, &end.values);
                let met = event?;
                if end.values.iter().enumerate().any(|(k, value)| k != met && *value <= NEGLIGIBLE) {
                    return None;
                }
            }
            let Some(part) = self.first_dip(from, &end, tolerance) else { return Some((end, event)) };
            end = self.step(from, part * end.length)?;
        }
        None
    }

    /// The step that ends where condition `k` or an earlier one is just violated.
    fn located(
        &self,
        from: (&[f64], &[f64]),
        start: &[f64],
        mut end: SlipStep,
        k: usize,
    ) -> Option<SlipStep> {
        // The factor at a maximum is known to the square of its rate.
        let within = if k == GROWS { 1e-9 } else { 2e-14 };
        let (bracket, mut earlier) = ([(0.0, start[k]), (end.length, end.values[k])], None);
        let found = regula_falsi(bracket, within, &mut |length| {
            let Some(there) = self.step(from, length) else { return f64::NAN };
            let value = there.values[k];
            earlier = first_crossing(start, &there.values).filter(|other| *other != k);
            if earlier.is_some() || value <= 0.0 {
                end = there;
            }
            if earlier.is_some() { f64::NAN } else { value }
        });
        match earlier {
            Some(other) => self.located(from, start, end, other),
            None => found.map(|_| end),
        }
    }

    /// The part of a step at which a sticking contact reaches its edge, though it sticks again at the end, or half the step where that is undecided.
    fn first_dip(&self, (at, rates): (&[f64], &[f64]), end: &SlipStep, tolerance: f64) -> Option<f64> {
        let mut first: Option<f64> = None;
        for i in self.sticking() {
            let values = [at, &end.at].map(|at| self.force(i, at));
            let changes = [rates, &end.rates].map(|rates| self.force(i, rates) * end.length);
            let cone = Some(self.problem.cone(i));
            let dip = Bounded::new((values, changes), cone, (self.largest, tolerance)).dip();
            first = dip.map_or(first, |dip| Some(first.map_or(dip, |first| first.min(dip))));
        }
        first
    }
    /// The conditions that must stay positive, in their order.
    fn conditions(&self, at: &[f64], rates: &[f64]) -> Vec<f64> {
        let mut values = Vec::with_capacity(SMALL + 1 + 2 * self.none.len());
        values.extend([rates[1], 1.0 - at[1] / self.most, 1.0 - self.far(at)]);
        for (p, slip) in self.directions(at).iter().zip(rates[2..].chunks_exact(2)) {
            values.push((p[1] * slip[0] + p[2] * slip[1]) / self.unit);
        }
        values
            .extend(self.sliding.iter().map(|i| self.force(*i, at)[0] / self.largest - LITTLE_NORMAL_FORCE));
        for i in self.sticking() {
            values.push(self.problem.cone(i).round_margin(&self.force(i, at)) / self.largest);
        }
        values
    }

    /// The length along which the fastest direction turns by 0.3 rad and no normal force is halved, at most the rest of the load.
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

/// The violated condition that linear interpolation between both ends would reach first.
fn first_crossing(start: &[f64], end: &[f64]) -> Option<usize> {
    let part = |k: usize| start[k] / (start[k] - end[k]);
    (0..start.len()).filter(|k| end[*k] < 0.0).min_by(|a, b| part(*a).total_cmp(&part(*b)))
}
