//! Answers of a grasp as its scene tells them: under the scene's own names of contacts.

use crate::ask::Grasp;
use crate::equilibrium::{Equilibrium, Outcome, WorkDone};
use crate::error::ContactLabel;

/// What a scene calls the contacts of its grasp, in the order of the grasp.
pub(super) struct SceneNames(pub(super) Vec<ContactLabel>);

impl SceneNames {
    /// Calls a contact of the grasp what the scene calls it.
    pub(super) fn name(&self, contact: &mut ContactLabel) {
        contact.clone_from(&self.0[contact.index]);
    }

    /// An equilibrium as it is written.
    pub(super) fn equilibrium<const C: usize>(&self, mut state: Equilibrium<C>) -> Equilibrium<C> {
        state.contacts.iter_mut().for_each(|contact| self.name(&mut contact.contact));
        state.written()
    }

    /// An outcome as it is written.
    pub(super) fn outcome<const C: usize>(&self, mut outcome: Outcome<C>) -> Outcome<C> {
        match &mut outcome {
            Outcome::Equilibrium(state) => **state = self.equilibrium(state.as_ref().clone()),
            Outcome::NoEquilibrium(_) => {}
            Outcome::Undecided(undecided) => undecided.work = WorkDone::default(),
        }
        outcome
    }

    /// An outcome with the accuracy of an equilibrium, and with the states that are told from their neighbours.
    pub(super) fn solved<const C: usize>(&self, grasp: &Grasp<C>, mut outcome: Outcome<C>) -> Outcome<C> {
        if let Outcome::Equilibrium(state) = &mut outcome {
            state.accuracy = grasp.accuracy(state);
            let distinct = grasp.distinct(state).into_iter().flatten();
            state.contacts.iter_mut().zip(distinct).for_each(|(contact, told)| contact.distinct = Some(told));
        }
        self.outcome(outcome)
    }
}
