//! Numerical steps along an arc, a piece of the load path on which directions of sliding turn. A watched condition is a condition for the state of a
//! contact (open, sticking or sliding). It is violated if its value is negative, and just met if its value is zero. Each step is shortened to end at
//! the point of the path where the value of a watched condition becomes zero.
//!
//! To find this point, the last step is repeated from its start with other lengths. They come from Newton's method on the value of the condition,
//! within a bracket. Points of the path are never interpolated.

use super::flow::{Flow, FlowStep, Rule, StepGoal};
use super::piecewise_follower::PiecewiseFollower;
use super::segment::PathPoint;
use super::watched_condition::{ConditionValue, watch};
use crate::numerics::{chosen, lowest};
use crate::prelude::*;

/// A step along an arc: its arclength, the path point at its end, and the values of watched conditions there.
pub(super) struct StepEnd {
    pub(super) length: f64,
    pub(super) rule: Rule,
    pub(super) reached: FlowStep,
    pub(super) watches: Vec<ConditionValue>,
    /// The index in `watches` of the condition that is just met at the end, if the step was made to end there.
    pub(super) located: Option<usize>,
}

impl PiecewiseFollower<'_> {
    /// Makes a step of the arclength `length` from `point` along an arc, and evaluates the watched conditions at its end. `trial` is the number of
    /// earlier trials of this step. `None` if the step fails.
    pub(super) fn step(
        &self,
        point: &PathPoint,
        (length, trial): (f64, usize),
        rule: Rule,
    ) -> Option<StepEnd> {
        let unit = self.pace.unit?;
        let flow = Flow::new(&self.segment, &self.node.states, self.factor, point, unit);
        let reached = flow.step(length, StepGoal::after(1.0, trial), rule)?;
        let watches = watch(&self.segment, &self.node.states, (reached.to, &reached.point));
        Some(StepEnd { length, rule, reached, watches, located: None })
    }

    /// Returns `end`, a straight step from `point` along the tangent of the path. The step is shortened if a contact has zero force (the apex of its
    /// cone) at `point`, and a condition is clearly violated at the end of the step. `None` if the end of the shortened step is not found.
    pub(super) fn up_to_a_break(&self, point: &PathPoint, end: StepEnd) -> Option<StepEnd> {
        if !self.node.starts_at_apex || !end.watches.iter().any(ConditionValue::is_broken) {
            return Some(end);
        }
        let start = watch(&self.segment, &self.node.states, (self.factor, point));
        let condition = Self::first_crossing(&start, &end)?;
        self.locate(point, &start, end, condition)
    }

    /// The index of the condition that is violated first in a step, among those violated at its end. The values of conditions are interpolated
    /// linearly between the ends of the step. `None` if no condition is violated.
    pub(super) fn first_crossing(start: &[ConditionValue], end: &StepEnd) -> Option<usize> {
        let part = |k: usize| {
            let (from, to) = (start[k].value.max(0.0), end.watches[k].value);
            from / (from - to)
        };
        let violated = chosen(start.len(), &|k| end.watches[*k].is_violated());
        lowest(&violated, &|k| part(*k)).copied()
    }

    /// Shortens the step `end`, which violates condition `k`, until it ends where a watched condition is just met and no other is violated. The
    /// condition that is met is `k`, or another condition that is violated earlier. `None` if no such step is found.
    pub(super) fn locate(
        &self,
        point: &PathPoint,
        start: &[ConditionValue],
        mut end: StepEnd,
        mut k: usize,
    ) -> Option<StepEnd> {
        let (mut low, mut high) = ((0.0, start[k].value.max(0.0)), (end.length, end.watches[k].value));
        if start[k].is_met() {
            // The value of the condition is zero up to rounding already at the start of the step. The rounding error is removed; the value becomes
            // negative right after the start.
            low.1 = 0.0;
        }
        // At most eighty lengths are tried. Bisection alone halves the bracket to the 53 bits of a floating-point number in about fifty trials.
        for trial in 0..80 {
            // If Newton's method gives no length inside the bracket, the length comes from a secant step, or every third time from bisection.
            let part = low.1 / (low.1 - high.1);
            // A secant step keeps at least this fraction of the bracket away from both of its ends. The bracket then does not shrink by tiny steps
            // from one end only.
            let inside = 1e-3;
            let part = if trial % 3 == 2 { 0.5 } else { part.clamp(inside, 1.0 - inside) };
            let newton =
                end.watches[k].way().map(|way| end.length + way).filter(|t| *t > low.0 && *t < high.0);
            let to = newton.unwrap_or(low.0 + (high.0 - low.0) * part);
            if to <= low.0 || to >= high.0 {
                // No floating-point number lies between both ends of the bracket, so the step `end` is as near to the zero of the condition as
                // possible.
                end.located = Some(k);
                return Some(end);
            }
            end = self.step(point, (to, trial), end.rule)?;
            if let Some(other) = Self::first_crossing(start, &end) {
                if other != k {
                    k = other;
                    low = (0.0, start[k].value.max(0.0));
                }
                high = (end.length, end.watches[k].value);
            } else if end.watches[k].is_met() {
                end.located = Some(k);
                return Some(end);
            } else {
                low = (end.length, end.watches[k].value);
            }
        }
        None
    }
}
