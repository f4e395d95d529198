//! The data of a grasp that are kept from question to question.

use std::sync::Arc;

use grasp_lcp::Error;
use grasp_lcp::ask::Grasp;
use grasp_lcp::scene::Setup;

/// The scene of a grasp without its questions, and the grasp itself. `grasp` is `None` for a hand with joints and for several bodies.
pub(crate) struct StoredGrasp<const C: usize> {
    pub(crate) setup: Setup<C>,
    pub(crate) grasp: Option<Grasp<C>>,
}

impl<const C: usize> StoredGrasp<C> {
    pub(crate) fn new(setup: Setup<C>) -> Result<Arc<Self>, Error> {
        let grasp =
            if setup.is_held_by_a_hand() || !setup.bodies.is_empty() { None } else { Some(setup.grasp()?) };
        Ok(Arc::new(Self { setup, grasp }))
    }

    /// The grasp, for questions that support several bodies but no joints.
    pub(crate) fn without_hand(&self, question: &'static str) -> Result<Grasp<C>, Error> {
        if !self.setup.bodies.is_empty() {
            return self.setup.grasp();
        }
        self.without_joints(question).cloned()
    }

    /// The grasp, for questions that support neither joints nor several bodies.
    pub(crate) fn without_joints(&self, question: &'static str) -> Result<&Grasp<C>, Error> {
        self.grasp.as_ref().ok_or(Error::NotForHands { question })
    }
}
