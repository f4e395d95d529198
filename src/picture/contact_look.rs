//! How pictures show a contact: what it does, in a word and in a colour, and the slope of its cone.

use plotters::style::RGBColor;

use super::palette::{BLUE, GREEN, GREY, ORANGE, VERMILION};
use crate::equilibrium::{ContactAnswer, ContactState};
use crate::grasp::Contact;

/// Friction in reserve, as a part of the normal force, that is rounding: answers are good to some
/// 1e-15 of it, and a contact that really has a reserve has far more. With 0 a contact at its onset
/// would be called sticking.
const NO_RESERVE: f64 = 1e-12;
/// A cone with a larger coefficient of friction is drawn with this one: its edges then lie across
/// the normal to less than a pixel, while an infinite one could not be drawn.
pub(super) const STEEPEST: f64 = 1e3;

/// Whether nothing but rounding is left of the friction in reserve.
pub(super) fn no_friction_left<const C: usize>(answer: &ContactAnswer<C>) -> bool {
    answer.margin <= NO_RESERVE * answer.normal_force()
}

/// The slope of the cone of a contact, as it is drawn.
pub(super) fn slope<const C: usize>(contact: &Contact<C>) -> f64 {
    contact.friction_coefficient().min(STEEPEST)
}

/// The colour of what a contact does, which a [`word`] says.
pub(super) fn ink(word: &str) -> RGBColor {
    match word {
        "separated" => GREY,
        "sliding" => VERMILION,
        "frictionless" => GREEN,
        "about to slide" => ORANGE,
        _ => BLUE,
    }
}

/// What a contact does, for a picture: a contact on the edge of its cone that has not slipped yet
/// is told apart.
pub(super) fn word<const C: usize>(answer: &ContactAnswer<C>) -> &'static str {
    match answer.state {
        ContactState::Separated => "separated",
        ContactState::Sliding { .. } => "sliding",
        ContactState::Frictionless => "frictionless",
        ContactState::Sticking if no_friction_left(answer) => "about to slide",
        ContactState::Sticking => "sticking",
    }
}
