//! Where the fingers should be.

use nalgebra::SVector;

use super::goal::ImproveGoal;
use crate::grasp::WholeContact;
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// The answer to "where should the fingers be?"; its [`Display`](std::fmt::Display) says it in a sentence.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Improved<const C: usize> {
    /// What `before` and `after` are.
    #[cfg_attr(feature = "serde", serde(default))]
    pub goal: ImproveGoal,
    /// Of the grasp given: its least first slip, as so many times the loads, or its least reserve, N. `None` where something slides at rest or nothing
    /// holds, and of a reserve where something slides under a load.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Option<f64>>"))]
    pub before: Option<f64>,
    /// That of the best grasp found; `None` where no grasp was found that sticks at rest, or for a reserve under the loads. Infinite where nothing slides however large the loads are.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Option<f64>>"))]
    pub after: Option<f64>,
    /// What one time the loads is, where it is one force: its size, N.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub force: Option<f64>,
    /// Where each contact is then.
    pub contacts: Vec<Placed<C>>,
    /// What stands in the way of more: events that come first, and bounds that are met.
    pub in_the_way: Vec<InTheWay>,
    /// How the search ended that found it.
    pub search: SearchEnd,
    /// What its multipliers leave of zero: the sum of gradients of events and bounds, as a part of the first slip, or of the greatest force, for a step as large as the grasp, or
    /// as the greatest force. `None` where no multipliers were found.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Option<f64>>"))]
    pub residual: Option<f64>,
    /// Starts that were gone up from.
    pub starts: usize,
    /// Steps from all of them, those refused included.
    pub steps: usize,
}

/// Where a contact is, and how it is told to press.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Placed<const C: usize> {
    /// Which contact, or point of a soft fingertip.
    pub contact: WholeContact,
    /// What it may move along, if it may move: "edge", "circle", …
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub surface: Option<String>,
    /// m.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub point: SVector<f64, C>,
    /// Unit normal into the object.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub normal: SVector<f64, C>,
    /// Unit first tangent: its frame has come along without turning about the normal.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub tangent: SVector<f64, C>,
    /// Command in that frame, m.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub command: SVector<f64, C>,
    /// How far it is from where it was, in a straight line, m.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub moved: f64,
    /// What it is told to press with, N, where that may change.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub pressed_with: Option<f64>,
    /// Its normal force at rest, N.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub normal_force: f64,
}

/// Something that stands in the way of a later first slip, or of more in reserve.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct InTheWay {
    /// Of which contact.
    pub contact: WholeContact,
    /// What.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub binds: Binds,
}

/// What stands in the way, with its multiplier. What is gained is first slip, as so many times the loads, or reserve, N.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "what", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Binds {
    /// It slides or opens first.
    FirstSlip {
        /// Under which of the loads, from 0; `None` for a force of any direction.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        load: Option<usize>,
        /// Its share: those of all that come first add up to one.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        share: f64,
    },
    /// It has least friction in reserve.
    Reserve {
        /// Under which of the loads, from 0; `None` for a force of any direction.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        load: Option<usize>,
        /// Its share, as for the first slip.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        share: f64,
    },
    /// At rest it presses as hard as it may.
    Force {
        /// What one more newton would gain.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        per_newton: f64,
    },
    /// It is told to press as hard as it may.
    Pressed {
        /// As for the force.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        per_newton: f64,
    },
    /// It is told not to press at all.
    NotPressed {
        /// What a pull of one newton would gain.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        per_newton: f64,
    },
    /// Its surface ends, or the part of it that it is on.
    End {
        /// What one more metre would gain.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        per_metre: f64,
    },
    /// At rest it stands on the edge of its friction.
    Rest {
        /// What one more newton of friction would gain.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        per_newton: f64,
    },
}

/// How a search ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum SearchEnd {
    /// To first order nothing nearby is better: gradients of what comes first and of bounds that are met cancel, up to a millionth.
    Optimum,
    /// No step gains more than rounding, and gradients do not cancel: two ways of one contact to slide may meet there.
    Stalled,
    /// It has made as many steps as it may.
    OutOfSteps,
    /// At another place nothing would balance the loads, as for two point contacts in space that have to lie on one line with them.
    Unbalanced,
    /// However large the loads are, nothing slides.
    NothingSlides,
    /// No start sticks at rest and resists the loads, or for a reserve none sticks under them.
    NoStart,
}

impl<const C: usize> Improved<C> {
    /// Whether it is proved that to first order no other place and squeeze nearby is better.
    #[must_use]
    pub fn is_locally_best(&self) -> bool {
        self.search == SearchEnd::Optimum
    }
}
