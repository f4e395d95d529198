//! The test whether a contact whose slip has ended on an arc (a piece of the path on which directions of sliding turn) can neither stick nor slide
//! on. A leg is a section of the load program.
//!
//! When the contact stops, sticking and sliding give the same rates of forces and motion, and differ only a little later. As a rule one of the two
//! contact states is valid from then on. Near a maximum of the load it may be that neither is valid: if the contact sticks, its force leaves the
//! friction cone; if it slides, friction drives the slip instead of opposing it. In that case the path ends.

use super::flow::{Flow, Rule, StepGoal};
use super::piecewise_follower::PiecewiseFollower;
use super::watched_condition::{ConditionValue, WatchedCondition, watch};
use crate::contact::{Mode, State};

impl PiecewiseFollower<'_> {
    /// Whether a contact whose slip has ended at the present point of the path can neither stick nor slide on. This is so if both states fail in
    /// trial steps along the path. Sticking fails if the force leaves the friction cone, and sliding fails if friction drives the slip. Only
    /// trial steps whose estimated relative error is at most `tolerance` are used.
    pub(super) fn neither_sticks_nor_slides(&self, contact: usize, tolerance: f64) -> bool {
        let slides = State::sliding_along(&self.node.at.forces[contact]);
        [Mode::Sticking, slides].into_iter().all(|state| self.fails_at_once(contact, state, tolerance))
    }

    /// Whether a contact in the state `state` clearly violates the condition of this state after three trial steps, each shorter than the one before.
    /// The condition is a force inside the friction cone or, if the contact slides, a slip that friction opposes. Trial steps whose estimated
    /// relative error exceeds `tolerance` do not count. False as soon as the condition holds after a step that counts.
    fn fails_at_once(&self, contact: usize, state: State, tolerance: f64) -> bool {
        let mut states = self.node.states.clone();
        states[contact] = state;
        let Ok(point) = self.segment.tangent(&states, self.factor, &self.node.at, None) else { return false };
        let unit = point.twist_rate.norm();
        if unit == 0.0 {
            return false;
        }
        let point = point.slowed(core::f64::consts::FRAC_1_SQRT_2);
        let flow = Flow::new(&self.segment, &states, self.factor, &point, unit);
        let mut length = (1.0 - self.factor) / point.factor_rate;
        let mut failures = 0;
        for _ in 0..40 {
            // The first trial step is a quarter of the rest of the leg, and each further step a quarter of the step before.
            length *= 0.25;
            let reached = flow.step(length, StepGoal::after(1.0, 0), Rule::Explicit);
            let Some(reached) = reached.filter(|reached| reached.error <= tolerance) else { continue };
            let watches = watch(&self.segment, &states, (reached.to, &reached.point));
            let of_it = watches.iter().find(|watch| watch.what == WatchedCondition::Contact(contact));
            if !of_it.is_some_and(ConditionValue::is_broken) {
                return false;
            }
            failures += 1;
            // Three accurate trial steps must clearly violate the condition of the contact's state, so that no error of a single step ends the path.
            if failures == 3 {
                return true;
            }
        }
        false
    }
}
