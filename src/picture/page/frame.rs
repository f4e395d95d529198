//! What one of the buttons of a page shows.

use crate::spatial::Equilibrium;

/// One of the answers between which the buttons choose.
#[derive(Debug, Clone)]
pub(super) struct Frame {
    pub(super) label: String,
    pub(super) shown: Shown,
}

#[derive(Debug, Clone)]
pub(super) enum Shown {
    State(Box<Equilibrium>),
    /// Contacts without forces, and why.
    Nothing(String),
}

impl Frame {
    pub(super) fn state(&self) -> Option<&Equilibrium> {
        match &self.shown {
            Shown::State(state) => Some(state),
            Shown::Nothing(_) => None,
        }
    }
}
