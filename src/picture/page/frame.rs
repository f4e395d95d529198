//! What one of the buttons of a page shows.

use crate::ask::Grasp;
use crate::equilibrium::Equilibrium;
use crate::grasp::{Contact, Motion, Wrench};
use crate::picture::contact_look::STEEPEST;

/// One of the answers between which the buttons choose.
#[derive(Debug, Clone)]
pub(super) struct Frame<const C: usize> {
    pub(super) label: String,
    /// An equilibrium, or why contacts are drawn without forces.
    pub(super) shown: Result<Box<Equilibrium<C>>, String>,
    /// What is said beside it.
    pub(super) says: Vec<String>,
    /// The way the object takes.
    pub(super) leaving: Option<Motion<C>>,
    /// The load where there is no equilibrium.
    pub(super) load: Option<Wrench<C>>,
    /// Coefficients of friction of the contacts, where they are not those of the page.
    pub(super) friction: Option<Vec<f64>>,
}

impl<const C: usize> Frame<C> {
    pub(super) fn new(label: String, shown: Result<Box<Equilibrium<C>>, String>) -> Self {
        Self { label, shown, says: Vec::new(), leaving: None, load: None, friction: None }
    }

    /// An equilibrium of a grasp whose coefficients of friction need not be those of the page.
    pub(super) fn of(label: String, grasp: &Grasp<C>, state: &Equilibrium<C>) -> Self {
        let friction = grasp.contacts().iter().map(Contact::friction_coefficient).collect();
        Self { friction: Some(friction), ..Self::new(label, Ok(Box::new(state.clone()))) }
    }

    pub(super) fn state(&self) -> Option<&Equilibrium<C>> {
        self.shown.as_deref().ok()
    }

    /// The load that is drawn.
    pub(super) fn load(&self) -> Option<&Wrench<C>> {
        self.state().map(|state| &state.load).or(self.load.as_ref())
    }

    /// The coefficient of friction of a contact that has this one on the page.
    pub(super) fn friction(&self, contact: usize, given: f64) -> f64 {
        self.friction.as_ref().and_then(|all| all.get(contact).copied()).unwrap_or(given)
    }

    /// The slope of its cone, as it is drawn.
    pub(super) fn slope(&self, contact: usize, given: f64) -> f64 {
        self.friction(contact, given).min(STEEPEST)
    }
}

/// Changes the answer given last, if there is one.
pub(super) fn change_last<const C: usize>(frames: &mut [Frame<C>], change: impl FnOnce(&mut Frame<C>)) {
    if let Some(frame) = frames.last_mut() {
        change(frame);
    }
}
