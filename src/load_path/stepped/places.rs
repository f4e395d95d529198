//! States at the ends of a step.

use super::one_step::SteppedState;
use crate::numerics::Size;

/// The states that a step made twice leads to: in halves, which the path takes, and at once.
#[derive(Debug)]
pub(super) struct Places<D: Size, const C: usize> {
    pub(super) middle: SteppedState<D, C>,
    pub(super) to: SteppedState<D, C>,
    pub(super) at_once: SteppedState<D, C>,
    /// Memory for the step of the second path.
    pub(super) beside: SteppedState<D, C>,
}

impl<D: Size, const C: usize> Places<D, C> {
    pub(super) fn nowhere() -> Self {
        let [middle, to, at_once, beside] = [(); 4].map(|()| SteppedState::nowhere());
        Self { middle, to, at_once, beside }
    }
}
