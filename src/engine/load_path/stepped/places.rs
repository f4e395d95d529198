//! States at the ends of a step.

use super::one_step::SteppedState;
use crate::numerics::Each;

/// The states of a step made twice: in two halves, which the path takes, and as a whole.
#[derive(Debug)]
pub(super) struct Places {
    pub(super) middle: SteppedState,
    pub(super) to: SteppedState,
    pub(super) at_once: SteppedState,
    /// Memory for the step of the second path (see `coarse`).
    pub(super) beside: SteppedState,
}

impl Places {
    pub(super) fn nowhere() -> Self {
        let [middle, to, at_once, beside] = [(); 4].each(|()| SteppedState::nowhere());
        Self { middle, to, at_once, beside }
    }
}
