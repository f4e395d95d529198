//! A step of a load path is made twice: in two halves, and at once, i.e. in a single step of the same length. The difference of contact forces at the
//! two ends measures the error of the step. The path continues from the end of the two halves. A second path, which measures errors that accumulate,
//! makes all its steps at once.

use super::one_step::SteppedState;
use crate::numerics::Each;

/// The path points at the ends of a step made twice. The path continues from the end of the two halves: `middle` is the point after the first half,
/// `to` the point after the second. `at_once` is the point at the end of the same step made at once.
#[derive(Debug)]
pub(super) struct StepDoubling {
    pub(super) middle: SteppedState,
    pub(super) to: SteppedState,
    pub(super) at_once: SteppedState,
    /// Scratch buffer for the end of the step that the second path makes from its own path point (`coarse_path`).
    pub(super) beside: SteppedState,
}

impl StepDoubling {
    pub(super) fn without_contacts() -> Self {
        let [middle, to, at_once, beside] = [(); 4].each(|()| SteppedState::without_contacts());
        Self { middle, to, at_once, beside }
    }
}
