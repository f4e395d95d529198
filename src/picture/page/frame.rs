//! What one of the buttons of a page shows.

use crate::spatial::Equilibrium;

/// One of the answers between which the buttons choose.
#[derive(Debug, Clone)]
pub(super) struct Frame {
    pub(super) label: String,
    /// An equilibrium, or why contacts are drawn without forces.
    pub(super) shown: Result<Box<Equilibrium>, String>,
}

impl Frame {
    pub(super) fn state(&self) -> Option<&Equilibrium> {
        self.shown.as_deref().ok()
    }
}
