//! The behaviour of a grasp under a repeated load, and the data of the cycles.

use crate::equilibrium::Equilibrium;
use crate::grasp::{BodyMotion, Motion, WholeContact, Wrench};
use crate::hold::{Lost, Verdict};
use crate::prelude::*;
use crate::search::Doubt;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// The answer to the question how a grasp bears a repeated load; its [`Display`](std::fmt::Display) is a sentence.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Shaken<const C: usize> {
    /// The load at rest, where every cycle begins and ends.
    pub base: Wrench<C>,
    /// The behaviour in the long run.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub repeats: Repeats<C>,
    /// The period of the repeated motion in load cycles. It is 1 unless [friction falls](crate::grasp::Contact::kinetic) as contacts begin to slide.
    #[cfg_attr(feature = "serde", serde(default = "once", skip_serializing_if = "is_once"))]
    pub every: usize,
    /// Number of cycles up to the verdict. The last one counts even if the object is lost within it.
    pub cycles: usize,
    /// Number of cycles that were computed. Of many cycles with the same events a few are enough.
    pub followed: usize,
    /// The largest change in the last cycle or period: of forces relative to the largest force, of gaps relative to the springs' stretch under it.
    /// Apart from rounding and step errors it is zero, unless the verdict is undecided, lost, or a walk with changing forces.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub change: f64,
    /// The factor by which the distance from the limit of the cycles shrinks per cycle. Zero if the last cycle repeats itself; otherwise the verdict
    /// is that of the limit.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub ratio: f64,
    /// The motion of the object, or of each body, from rest to the end of the last cycle; if slips die out, to the limit.
    pub moved: Vec<BodyMotion<C>>,
    /// The equilibrium after the last cycle that was followed from rest, before the next one begins; `None` without an equilibrium.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub state: Option<Box<Equilibrium<C>>>,
}

/// The long-term behaviour of a grasp under a repeated load.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "repeats", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Repeats<const C: usize> {
    /// No contact slides any more.
    Rests {
        /// Number of cycles until nothing slides any more; 0 if nothing ever slides.
        after: usize,
        /// The contacts that have slid until then.
        slid: Vec<WholeContact>,
    },
    /// Slips shrink from cycle to cycle and die out: the grasp comes to rest in the limit.
    DiesOut {
        /// The contacts that slide.
        slid: Vec<WholeContact>,
    },
    /// Contacts slide to and fro for ever, and the object stays.
    Alternates {
        /// The contacts that slide.
        slides: Vec<WholeContact>,
        /// The longest path that a contact slides in a period, m.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        way: f64,
        /// Heat from friction in a period, J.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        dissipated: f64,
    },
    /// The object moves by the same amount in every cycle. Or it has walked farther than the distance of its contacts while forces still
    /// [change](Shaken::change); such motions are not small, so the walk is not followed further.
    Walks {
        /// The motion per period, of the object or of each body.
        by: Vec<BodyMotion<C>>,
        /// The contacts that slide.
        slides: Vec<WholeContact>,
        /// Heat from friction in a period, J.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        dissipated: f64,
    },
    /// The object is lost.
    Lost {
        /// The cycle in which the object is lost, from 1.
        cycle: usize,
        /// The leg of the cycle in which the object is lost, from 0.
        leg: usize,
        /// The load at the loss.
        load: Wrench<C>,
        /// The loss; its factor is the fraction of the leg.
        lost: Box<Lost<C>>,
    },
    /// The grasp does not hold even the load at rest.
    NoRest {
        /// The answer of [`hold`](crate::ask::Grasp::hold) for the load at rest.
        rest: Box<Verdict<C>>,
    },
    /// The verdict is not known.
    Undecided {
        /// The reason why the path ends in the last cycle; `None` if the [allowed](crate::Settings::most_cycles) number of cycles has passed, and
        /// cycles still change.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        doubt: Option<Doubt>,
    },
}

#[cfg(feature = "serde")]
fn once() -> usize {
    1
}

#[cfg(feature = "serde")]
#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde asks")]
fn is_once(every: &usize) -> bool {
    *every == 1
}

impl<const C: usize> Shaken<C> {
    /// The motion per period of the object or of the bodies if it walks; else `None`.
    #[must_use]
    pub fn drift(&self) -> Option<Motion<C>> {
        let Repeats::Walks { by, .. } = &self.repeats else { return None };
        let bodies = if by.len() > 1 { by.clone() } else { Vec::new() };
        by.first().map(|first| Motion { object: first.twist, joints: Vec::new(), bodies })
    }

    /// Whether the grasp comes to rest, at once or in the limit; `None` if it is not known.
    #[must_use]
    pub fn rests(&self) -> Option<bool> {
        match self.repeats {
            Repeats::Rests { .. } | Repeats::DiesOut { .. } => Some(true),
            Repeats::Alternates { .. }
            | Repeats::Walks { .. }
            | Repeats::Lost { .. }
            | Repeats::NoRest { .. } => Some(false),
            Repeats::Undecided { .. } => None,
        }
    }

    /// Whether the object stays: the grasp rests, or contacts slide to and fro under it for ever; `None` if it is not known.
    #[must_use]
    pub fn stays(&self) -> Option<bool> {
        match self.repeats {
            Repeats::Alternates { .. } => Some(true),
            _ => self.rests(),
        }
    }
}
