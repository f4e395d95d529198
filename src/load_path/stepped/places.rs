//! States at the ends of a step.

use super::one_step::SteppedState;

/// The states that a step made twice leads to: in halves, which the path takes, and at once.
#[derive(Debug)]
pub(super) struct Places<const C: usize> {
    pub(super) middle: SteppedState<C>,
    pub(super) to: SteppedState<C>,
    pub(super) at_once: SteppedState<C>,
    /// Memory for the step of the second path.
    pub(super) beside: SteppedState<C>,
}

impl<const C: usize> Places<C> {
    pub(super) fn nowhere() -> Self {
        let [middle, to, at_once, beside] = [(); 4].map(|()| SteppedState::nowhere());
        Self { middle, to, at_once, beside }
    }
}
