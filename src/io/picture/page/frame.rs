//! The content of one answer on a page. A page is an HTML file that draws a grasp with one or several answers.

use crate::ask::Grasp;
use crate::equilibrium::Equilibrium;
use crate::grasp::{Motion, Wrench};
use crate::picture::contact_look::STEEPEST_CONE;

/// One of the answers that the buttons of a page select.
#[derive(Debug, Clone)]
pub(super) struct Frame {
    pub(super) label: String,
    /// An equilibrium, or the reason why contacts are drawn without forces.
    pub(super) shown: Result<Equilibrium<3>, String>,
    /// Sentences that are shown with the answer.
    pub(super) says: Vec<String>,
    /// The motion with which the object leaves the grasp, if the caller has given one.
    pub(super) leaving: Option<Motion<3>>,
    /// The load that is drawn if there is no equilibrium; an equilibrium has its own load.
    pub(super) load: Option<Wrench<3>>,
    /// The grasp of the answer, if the caller gave it. Unlike the page's grasp it may have, for example, the friction or the
    /// commands that a load needs.
    pub(super) grasp: Option<Grasp<3>>,
}

impl Frame {
    pub(super) fn new(label: String, shown: Result<Equilibrium<3>, String>) -> Self {
        Self { label, shown, says: Vec::new(), leaving: None, load: None, grasp: None }
    }

    pub(super) fn state(&self) -> Option<&Equilibrium<3>> {
        self.shown.as_ref().ok()
    }

    /// The load of the equilibrium; without an equilibrium the load that the caller has set.
    pub(super) fn load(&self) -> Option<&Wrench<3>> {
        self.state().map(|state| &state.load).or(self.load.as_ref())
    }

    /// The coefficient of friction of a contact in this answer. `given` is its coefficient in the page's grasp, returned if this answer has no grasp
    /// of its own.
    pub(super) fn friction(&self, contact: usize, given: f64) -> f64 {
        let own = self.grasp.as_ref().and_then(|grasp| grasp.contacts().get(contact));
        own.map_or(given, |contact| contact.friction)
    }

    /// Ratio of radius to height of the drawn friction cone of a contact: the coefficient of friction, but at most [`STEEPEST_CONE`]. `given` is the
    /// coefficient in the page's grasp, used if this answer has no grasp of its own.
    pub(super) fn cone_ratio(&self, contact: usize, given: f64) -> f64 {
        self.friction(contact, given).min(STEEPEST_CONE)
    }
}
