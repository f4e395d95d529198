//! The content of one answer of a page.

use crate::ask::Grasp;
use crate::equilibrium::Equilibrium;
use crate::grasp::{Contact, Face, Motion, Wrench};
use crate::numerics::mapped;
use crate::picture::contact_look::STEEPEST_CONE;

/// One of the answers that the buttons of a page select.
#[derive(Debug, Clone)]
pub(super) struct Frame<const C: usize> {
    pub(super) label: String,
    /// An equilibrium, or the reason why contacts are drawn without forces.
    pub(super) shown: Result<Box<Equilibrium<C>>, String>,
    /// Sentences beside the answer.
    pub(super) says: Vec<String>,
    /// The motion by which the object is lost.
    pub(super) leaving: Option<Motion<C>>,
    /// The load, if there is no equilibrium.
    pub(super) load: Option<Wrench<C>>,
    /// Coefficients of friction of the contacts, if they differ from those of the page.
    pub(super) friction: Option<Vec<f64>>,
}

impl<const C: usize> Frame<C> {
    pub(super) fn new(label: String, shown: Result<Box<Equilibrium<C>>, String>) -> Self {
        Self { label, shown, says: Vec::new(), leaving: None, load: None, friction: None }
    }

    /// An equilibrium of a grasp whose coefficients of friction may differ from those of the page.
    pub(super) fn of(label: String, grasp: &Grasp<C>, state: &Equilibrium<C>) -> Self {
        let friction = mapped(grasp.contacts(), &Contact::friction_coefficient);
        Self { friction: Some(friction), ..Self::new(label, Ok(Box::new(state.clone()))) }
    }

    pub(super) fn state(&self) -> Option<&Equilibrium<C>> {
        self.shown.as_deref().ok()
    }

    /// The load of the equilibrium; without an equilibrium the load that the caller has set.
    pub(super) fn load(&self) -> Option<&Wrench<C>> {
        self.state().map(|state| &state.load).or(self.load.as_ref())
    }

    /// The coefficient of friction of a contact; `given` is that of the page.
    pub(super) fn friction(&self, contact: usize, given: f64) -> f64 {
        self.friction.as_ref().and_then(|all| all.get(contact).copied()).unwrap_or(given)
    }

    /// The slope of the cone of a contact in pictures.
    pub(super) fn slope(&self, contact: usize, given: f64) -> f64 {
        self.friction(contact, given).min(STEEPEST_CONE)
    }
}

impl Frame<2> {
    /// The answer with vectors of three components, as far as tables show it.
    pub(super) fn widened(&self) -> Frame<3> {
        let shown = match &self.shown {
            Ok(state) => Ok(state.to_inside()),
            Err(why) => Err(why.clone()),
        };
        let mut frame = Frame::new(self.label.clone(), shown);
        (frame.says, frame.friction) = (self.says.clone(), self.friction.clone());
        frame
    }
}

/// Changes the last answer, if there is one.
pub(super) fn change_last<const C: usize>(frames: &mut [Frame<C>], change: impl FnOnce(&mut Frame<C>)) {
    if let Some(frame) = frames.last_mut() {
        change(frame);
    }
}
