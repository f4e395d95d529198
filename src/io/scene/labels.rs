//! Labels of contacts (number, and name if the user gave one) as the scene counts them, for the answers of its grasp.

use crate::ask::Grasp;
use crate::equilibrium::{Equilibrium, Outcome, WorkDone};
use crate::error::ContactLabel;

/// Writes the answers of a grasp with the labels of its scene, in which a soft fingertip counts as one contact.
pub(super) struct SceneNames<'g>(pub(super) &'g Grasp<3>);

impl SceneNames<'_> {
    /// The scene's label of a point contact; `index` counts the point contacts of the grasp.
    pub(super) fn label(&self, index: usize) -> ContactLabel {
        let engine = &self.0.engine;
        ContactLabel {
            point: engine.contacts()[index].point_of_pad,
            ..engine.wholes().at(index).label.clone()
        }
    }

    /// Replaces the label that the grasp gives to a point contact by the label that the scene gives to it.
    pub(super) fn name(&self, contact: &mut ContactLabel) {
        *contact = self.label(contact.index);
    }

    /// An equilibrium in the form of a scene's answers, with the labels of the scene.
    pub(super) fn equilibrium(&self, mut state: Equilibrium<3>) -> Equilibrium<3> {
        state.contacts.iter_mut().for_each(|contact| self.name(&mut contact.contact));
        state.written()
    }

    /// An outcome of `solve` in the form of a scene's answers, with the labels of the scene. In an undecided outcome the counts of the solver's work
    /// are set to zero, since answers do not contain them.
    pub(super) fn outcome(&self, mut outcome: Outcome<3>) -> Outcome<3> {
        match &mut outcome {
            Outcome::Equilibrium(state) => **state = self.equilibrium(state.as_ref().clone()),
            Outcome::NoEquilibrium(_) => {}
            Outcome::Undecided(undecided) => undecided.work = WorkDone::default(),
        }
        outcome
    }

    /// An outcome in the form of the answer to `solve`. An equilibrium also gets its numerical accuracy and, for each contact, whether double
    /// precision suffices to distinguish its state (sticking, sliding, open) from the neighbouring states.
    pub(super) fn solved(&self, mut outcome: Outcome<3>) -> Outcome<3> {
        if let Outcome::Equilibrium(state) = &mut outcome {
            state.accuracy = self.0.accuracy(state);
            let distinct = self.0.distinct(state).into_iter().flatten();
            state
                .contacts
                .iter_mut()
                .zip(distinct)
                .for_each(|(contact, number)| contact.distinct = Some(number));
        }
        self.outcome(outcome)
    }
}
