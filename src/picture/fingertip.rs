//! Contacts that are drawn as one: a point contact, or all points of a soft fingertip.

use std::ops::Range;

use nalgebra::SVector;

use super::contact_look::word;
use crate::equilibrium::{ContactAnswer, ContactState, Equilibrium};
use crate::grasp::{Contact, WholeContacts};
use crate::words::{LinkKind, Words};

/// Consecutive contacts of a grasp.
#[derive(Debug, Clone)]
pub(super) struct ContactGroup {
    pub(super) name: String,
    pub(super) contacts: Range<usize>,
    /// The kind of link that it is, if it is no contact.
    pub(super) link: Option<LinkKind>,
}

/// What a fingertip does as a whole.
pub(super) struct Resultant<const C: usize> {
    /// Where the force acts: the centre of pressure; where nothing presses, the middle.
    pub(super) at: SVector<f64, C>,
    pub(super) force: SVector<f64, C>,
    pub(super) normal_force: f64,
    /// Displacement of the object there.
    pub(super) displacement: SVector<f64, C>,
    /// Where all of it slides, the direction of the finger over the object.
    pub(super) slides: Option<SVector<f64, C>>,
    /// It slides where nothing sticks, and is open where nothing touches.
    pub(super) word: &'static str,
}

/// The contacts of a grasp as people count them.
pub(super) fn fingertips<const C: usize>(contacts: &[Contact<C>]) -> Vec<ContactGroup> {
    let whole = WholeContacts::of(contacts);
    let group = |(k, range): (usize, &Range<usize>)| ContactGroup {
        name: whole.label(k),
        contacts: range.clone(),
        link: contacts[range.start].link,
    };
    whole.ranges().iter().enumerate().map(group).collect()
}

/// A force in what is drawn and written of an equilibrium: zero where it is rounding, as in tables and sentences.
pub(super) fn without_rounding<const C: usize>(force: f64, state: &Equilibrium<C>) -> f64 {
    Words::default().beside(force, state.largest_force())
}

impl ContactGroup {
    /// Whether it is more than a point.
    pub(super) fn is_soft(&self) -> bool {
        self.contacts.len() > 1
    }

    /// The middle of its points.
    pub(super) fn middle<const C: usize>(&self, contacts: &[Contact<C>]) -> SVector<f64, C> {
        let points = contacts[self.contacts.clone()].iter().map(|contact| contact.point);
        points.sum::<SVector<f64, C>>() / self.contacts.len() as f64
    }

    /// Of a link its ends: those of a line, or its first two bearings; of a single point twice the same.
    pub(super) fn ends_of_link<const C: usize>(
        &self,
        contacts: &[Contact<C>],
    ) -> Option<[SVector<f64, C>; 2]> {
        let own = &contacts[self.contacts.clone()];
        let (first, second) = (own.first()?, own.get(1).or(own.first())?);
        match self.link? {
            // The normal of a line goes from its beginning to its end.
            LinkKind::Spring | LinkKind::Cable => Some([first.point, first.point + first.normal]),
            _ => Some([first.point, second.point]),
        }
    }

    pub(super) fn resultant<const C: usize>(
        &self,
        contacts: &[Contact<C>],
        state: &Equilibrium<C>,
    ) -> Resultant<C> {
        let answers = &state.contacts[self.contacts.clone()];
        let pressed: f64 = answers.iter().map(|answer| answer.normal_force().max(0.0)).sum();
        // A point of its own has no mean to be rounded.
        let share = |answer: &ContactAnswer<C>| match pressed > 0.0 {
            _ if answers.len() == 1 => 1.0,
            true if self.link.is_none() => answer.normal_force().max(0.0) / pressed,
            _ => 1.0 / answers.len() as f64,
        };
        let words = ["sticking", "about to slide", "sliding", "frictionless", "separated"];
        let does = |what: &&str| answers.iter().any(|answer| word(answer) == *what);
        let word = words.into_iter().find(does).unwrap_or("separated");
        let points = contacts[self.contacts.clone()].iter().zip(answers);
        let along = answers.iter().filter_map(|answer| match answer.state {
            ContactState::Sliding { direction } => Some(direction * share(answer)),
            _ => None,
        });
        let along: SVector<f64, C> = along.sum();
        let force: SVector<f64, C> = answers.iter().map(|answer| answer.force_world).sum();
        let acts = without_rounding(force.norm(), state) > 0.0;
        let normal_force: f64 = answers.iter().map(ContactAnswer::normal_force).sum();
        Resultant {
            at: points.map(|(contact, answer)| contact.point * share(answer)).sum(),
            force: if acts { force } else { SVector::zeros() },
            normal_force: if acts { without_rounding(normal_force, state) } else { 0.0 },
            displacement: answers.iter().map(|answer| answer.body_core * share(answer)).sum(),
            slides: (word == "sliding").then(|| along.try_normalize(0.0)).flatten(),
            word,
        }
    }
}
