//! The states at the ends of a step that is made in two halves and at once. The path takes the halves; a second path, which measures errors, makes
//! the same steps at once.

use super::one_step::SteppedState;
use crate::numerics::Each;

/// The states of a step made twice: after each of two halves (`middle`, `to`), which the path takes, and at the end of the same step made at
/// once (`at_once`).
#[derive(Debug)]
pub(super) struct StepDoubling {
    pub(super) middle: SteppedState,
    pub(super) to: SteppedState,
    pub(super) at_once: SteppedState,
    /// Memory for the end of the second path's own step (see `coarse_path`).
    pub(super) beside: SteppedState,
}

impl StepDoubling {
    pub(super) fn without_contacts() -> Self {
        let [middle, to, at_once, beside] = [(); 4].each(|()| SteppedState::without_contacts());
        Self { middle, to, at_once, beside }
    }
}
