//! Force, contact state and position of a contact in pictures. A fingertip is a contact with all its points: a soft fingertip has several, which are
//! shown with one resultant force, one state and one position. A link (a hinge or cable, for example) joins two bodies, or a body and the ground.

use nalgebra::SVector;

use super::contact_look::word;
use crate::equilibrium::{ContactAnswer, ContactState, Equilibrium};
use crate::grasp::{Contact, ContactPoints};
use crate::numerics::summed;
use crate::words::{LinkKind, Words};

/// Force and contact state of a fingertip as a whole; forces in N.
#[derive(Clone)]
pub(super) struct Resultant {
    /// The point at which the force acts: the centre of pressure, or the middle of the points if none of them presses.
    pub(super) at: SVector<f64, 3>,
    pub(super) force: SVector<f64, 3>,
    pub(super) normal_force: f64,
    /// Displacement of the object at the point where the force acts, m.
    pub(super) displacement: SVector<f64, 3>,
    /// The direction in which the finger slides over the object; `None` unless the whole fingertip slides.
    pub(super) slides: Option<SVector<f64, 3>>,
    /// The contact state in a word: the first of "sticking", "about to slide", "sliding", "frictionless" and "separated" that is the state of some
    /// point.
    pub(super) word: &'static str,
}

/// A force for pictures and tables, N; zero if it is only a rounding error compared with the largest contact force of the equilibrium.
pub(super) fn without_rounding<const C: usize>(force: f64, state: &Equilibrium<C>) -> f64 {
    Words::default().beside(force, state.largest_force())
}

impl ContactPoints {
    /// Whether the contact has several points, as a soft fingertip or a link does.
    pub(super) fn is_soft(&self) -> bool {
        self.range.len() > 1
    }

    /// Whether a contact point with the state `word` gets a dot in a picture. If a contact has more than sixteen points, only points that do not
    /// stick get a dot.
    pub(super) fn shows(&self, word: &str) -> bool {
        self.range.len() <= 16 || word != "sticking"
    }

    /// The mean of the contact's points, m.
    pub(super) fn middle(&self, contacts: &[Contact<3>]) -> SVector<f64, 3> {
        let points = contacts[self.range.clone()].iter().map(|contact| contact.point);
        points.sum::<SVector<f64, 3>>() / self.range.len() as f64
    }

    /// The ends of a link: the ends of the spring or cable, or else the first two points of the link. A link with a single point has the same end
    /// twice. `None` for a contact that is no link.
    pub(super) fn ends_of_link(&self, contacts: &[Contact<3>]) -> Option<[SVector<f64, 3>; 2]> {
        let own = &contacts[self.range.clone()];
        let (first, second) = (own.first()?, own.get(1).or(own.first())?);
        match self.label.link? {
            // For a spring or cable the field `normal` is no unit vector but the vector from its beginning to its end, m.
            LinkKind::Spring | LinkKind::Cable => Some([first.point, first.point + first.normal]),
            _ => Some([first.point, second.point]),
        }
    }

    pub(super) fn resultant(&self, contacts: &[Contact<3>], state: &Equilibrium<3>) -> Resultant {
        let answers = &state.contacts[self.range.clone()];
        let pressed: f64 = summed(answers, &|answer| answer.normal_force().max(0.0));
        // The fraction of the fingertip's normal force that a point carries. For a single point it is exactly 1, without rounding. The points of a
        // link, or of a fingertip without normal force, have equal fractions.
        let share = |answer: &ContactAnswer<3>| match pressed > 0.0 {
            _ if answers.len() == 1 => 1.0,
            true if self.label.link.is_none() => answer.normal_force().max(0.0) / pressed,
            _ => 1.0 / answers.len() as f64,
        };
        let words = ["sticking", "about to slide", "sliding", "frictionless", "separated"];
        let is_seen = |what: &&str| answers.iter().any(|answer| word(answer) == *what);
        let word = words.into_iter().find(is_seen).unwrap_or("separated");
        let [mut at, mut along, mut force, mut displacement] = [SVector::<f64, 3>::zeros(); 4];
        for (contact, answer) in contacts[self.range.clone()].iter().zip(answers) {
            if let ContactState::Sliding { direction } = answer.state {
                along += direction * share(answer);
            }
            at += contact.point * share(answer);
            force += answer.force_world;
            displacement += answer.body_core * share(answer);
        }
        let acts = without_rounding(force.norm(), state) > 0.0;
        let normal_force: f64 = summed(answers, &ContactAnswer::normal_force);
        Resultant {
            at,
            force: if acts { force } else { SVector::zeros() },
            normal_force: if acts { without_rounding(normal_force, state) } else { 0.0 },
            displacement,
            slides: (word == "sliding").then(|| along.try_normalize(0.0)).flatten(),
            word,
        }
    }
}
