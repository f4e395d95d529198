//! The look of contacts in pictures: a word and a colour for the contact state, and the ratio of radius to height of the friction cone.

use super::layout::MARKS;
use super::palette::{BLUE, GREEN, GREY, ORANGE, Rgb, VERMILION};
use crate::equilibrium::{ContactAnswer, ContactState};
use crate::grasp::Contact;
use crate::numerics::tolerances::SOLVED_ROUNDING;

/// Largest ratio of radius to height of a drawn friction cone. The side of such a cone deviates from the tangent plane by less than a pixel. An
/// infinite ratio could not be drawn.
pub(super) const STEEPEST_CONE: f64 = 1e3;

/// Ratio of radius to height of the drawn friction cone of a contact: the coefficient of friction, limited to [`STEEPEST_CONE`].
pub(super) fn cone_ratio<const C: usize>(contact: &Contact<C>) -> f64 {
    contact.friction_coefficient().min(STEEPEST_CONE)
}

/// Height and radius of the drawn friction cone of a contact whose normal force is an arrow of length `arrow`; `None` without friction or force.
/// `cone_ratio` is the ratio of radius to height. A cone with a radius above `widest` is drawn shorter, so that it does not hide everything else.
pub(super) fn cone_size(cone_ratio: f64, arrow: f64, widest: f64) -> Option<[f64; 2]> {
    let high = MARKS.cone * arrow;
    let wide = (cone_ratio * high).min(widest);
    (cone_ratio > 0.0 && high > 0.0).then(|| [wide / cone_ratio, wide])
}

/// The states of contacts in words, in the order of legends.
pub(super) const STATES: [&str; 5] = ["sticking", "about to slide", "sliding", "separated", "frictionless"];

/// The colour of a contact whose state has this [`word`].
pub(super) fn ink(word: &str) -> Rgb {
    match word {
        "separated" => GREY,
        "sliding" => VERMILION,
        "frictionless" => GREEN,
        "about to slide" => ORANGE,
        _ => BLUE,
    }
}

/// The contact state in a word. A contact that sticks, but whose force is on the boundary of its friction cone, is "about to slide".
pub(super) fn word<const C: usize>(answer: &ContactAnswer<C>) -> &'static str {
    match answer.state {
        ContactState::Separated => "separated",
        ContactState::Sliding { .. } => "sliding",
        ContactState::Frictionless => "frictionless",
        ContactState::Sticking if answer.margin <= SOLVED_ROUNDING * answer.normal_force() => {
            "about to slide"
        }
        ContactState::Sticking => "sticking",
    }
}
