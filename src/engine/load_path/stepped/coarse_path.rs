//! A second load path beside the one that is computed, which is called the first path. The second path has the same steps, but makes each step at
//! once and not in two halves. The distance between both paths is the largest difference of a contact force. It measures the present error of the
//! first path due to all steps so far.
//!
//! The error of a step in two halves is a third of its difference from the step made at once. But errors do not simply add up. Friction forces turn
//! towards the directions of slip, so that their errors decay, and errors of different steps affect different contacts. Errors of the second path
//! decay in the same way, which means that
//!
//! ```text
//! distance = error of the second - error of the first = 3 times the error of the first
//! ```
//!
//! The distance is returned as the estimated error of the path. If directions of slip reach their final values within a step, the distance is about
//! as large as the error, not three times as large.

use super::one_step::{StepProblem, SteppedState};
use crate::numerics::tolerances::SOLVED_ROUNDING;

/// A second path, which makes all its steps at once, and its distance from the first path, which makes the same steps in two halves. A path point is
/// what is stored of the grasp at a point of a path: forces, twist, slips and contact states.
#[derive(Debug, Clone)]
pub(super) struct CoarsePath {
    pub(super) present: SteppedState,
    /// The second path is sometimes restarted near the first. `lost` is a sum over all restarts: the distance between both paths just before the
    /// restart, divided by the largest contact force of the step.
    lost: f64,
    /// Estimated error of the first path: the largest value so far of the distance between both paths, divided by the largest contact force of the
    /// step, plus the sum `lost` over earlier restarts.
    pub(super) farthest: f64,
}

impl CoarsePath {
    /// The second path, which begins at `present`, the first point of the first path.
    pub(super) fn starting_at(present: &SteppedState) -> Self {
        Self { present: present.clone(), lost: 0.0, farthest: 0.0 }
    }

    /// Moves the second path on, after the first path has made a step from the path point `from` to `to`. `at_once` is the end of that step of the
    /// first path, made at once. As a rule the second path makes the same step from its own path point, and `beside` is overwritten with the end of
    /// this step. The second path moves to `at_once` instead, near the first path, if its own step fails or ends far from `at_once`. It also does so
    /// if both paths agree to within the tolerance of Newton's method.
    pub(super) fn follow(
        &mut self,
        along: &mut StepProblem<'_>,
        [from, to, at_once]: [&SteppedState; 3],
        beside: &mut SteppedState,
    ) {
        let largest = to.largest_force().max(from.largest_force()).max(f64::MIN_POSITIVE);
        let distance = from.distance_to(&self.present);
        let near = &to.twist + &self.present.twist - &from.twist;
        // The second path moves to `at_once` if its own step ends farther than this from `at_once`. Each such move adds the distance of the paths to
        // `lost`, although errors of earlier steps decay. If the limit were smaller, it would be exceeded at each change of contact states.
        let by = 10.0 * distance + to.distance_to(at_once);
        let step = || along.step(&self.present, (to.fraction - from.fraction, near), beside);
        // If both paths differ by at most this fraction of the largest force, the difference is within the tolerance of Newton's method. The second
        // path then moves to `at_once`. If the fraction were larger, there would be more such moves, each of which adds the distance of the paths to
        // `lost`, although errors decay.
        if distance > SOLVED_ROUNDING * largest && step().is_some() && beside.distance_to(at_once) <= by {
            core::mem::swap(&mut self.present, beside);
        } else {
            self.lost += distance / largest;
            self.present.join(at_once);
        }
        self.farthest = self.farthest.max(self.lost + to.distance_to(&self.present) / largest);
    }
}
