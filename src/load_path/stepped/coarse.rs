//! A second path of the same steps, each made at once. How far apart both paths are is what is left of all errors.
//!
//! A step in two halves errs by a third of what it differs from the step made at once. But errors do not add up: directions of slip relax and forget
//! them, and one step errs for this contact, the next for another. The second path forgets alike, so that
//!
//! ```text
//! distance = error of the second - error of the first = 3 times the error of the first
//! ```
//!
//! The distance is what is told: where it is not three times the error, directions relax within a step, and it is as large as the error.

use super::one_step::{StepProblem, SteppedState};
use crate::numerics::Size;

/// The second path has gone elsewhere if its distance grows by more than this factor in a step. Below a few it would be lost at every change of
/// states; then errors that are forgotten add up.
const ELSEWHERE: f64 = 10.0;

/// Paths that are apart by no more than this part of the largest force are one as far as Newton's method tells, and so is their next step made at
/// once. With more, errors that are forgotten add up.
const ONE: f64 = 1e-12;

/// The path of steps made at once.
#[derive(Debug, Clone)]
pub(super) struct Coarse<D: Size, const C: usize> {
    pub(super) standing: SteppedState<D, C>,
    /// Distances where it was lost and began again from the first path, over the largest force.
    lost: f64,
    /// The largest distance so far, with those, over the largest force.
    pub(super) farthest: f64,
}

impl<D: Size, const C: usize> Coarse<D, C> {
    /// From where both paths begin.
    pub(super) fn starting_at(standing: &SteppedState<D, C>) -> Self {
        Self { standing: standing.clone(), lost: 0.0, farthest: 0.0 }
    }

    /// Makes the step that leads the first path from one place to another. `at_once` is that step from there, made at once: where the second path
    /// finds none, or one elsewhere, it goes on there. `beside` is memory for its own.
    pub(super) fn follow(
        &mut self,
        along: &mut StepProblem<'_, D, C>,
        [from, to, at_once]: [&SteppedState<D, C>; 3],
        beside: &mut SteppedState<D, C>,
    ) {
        let largest = to.largest_force().max(from.largest_force()).max(f64::MIN_POSITIVE);
        let distance = from.apart(&self.standing);
        let near = &to.twist + &self.standing.twist - &from.twist;
        let by = ELSEWHERE * distance + to.apart(at_once);
        let step = || along.step(&self.standing, (to.fraction - from.fraction, near), beside);
        if distance > ONE * largest && step().is_some() && beside.apart(at_once) <= by {
            core::mem::swap(&mut self.standing, beside);
        } else {
            self.lost += distance / largest;
            self.standing.join(at_once);
        }
        self.farthest = self.farthest.max(self.lost + to.apart(&self.standing) / largest);
    }
}
