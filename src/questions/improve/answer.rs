//! The answer of the search for better finger places.

use nalgebra::SVector;

use super::goal::ImproveGoal;
use crate::grasp::WholeContact;
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// The best places and squeezes found; its [`Display`](std::fmt::Display) states them in a sentence.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Improved<const C: usize> {
    /// The maximised quantity, whose values are `before` and `after`.
    #[cfg_attr(feature = "serde", serde(default))]
    pub goal: ImproveGoal,
    /// Value of the given grasp: the least load factor of first slip, or the least reserve, N. `None` where a contact slides at rest, no equilibrium
    /// at rest is found, or, for a reserve, a contact slides under a load.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Option<f64>>"))]
    pub before: Option<f64>,
    /// Value of the best grasp found. `None` where no grasp was found that sticks at rest and, for a reserve, under the loads. Infinite where no
    /// contact slides however large the loads are.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Option<f64>>"))]
    pub after: Option<f64>,
    /// The size of the load, N, if it is a single force. The load factor of first slip times this size is the force at first slip.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub force: Option<f64>,
    /// Places and commands of all contacts in the best grasp found.
    pub contacts: Vec<Placed<C>>,
    /// The active sticking conditions and limits that prevent a larger value, with their multipliers.
    pub in_the_way: Vec<InTheWay>,
    /// How the search for this grasp ended.
    pub search: SearchEnd,
    /// Residual of first-order optimality: the sum of the gradients of sticking conditions and limits, weighted by their multipliers. It is relative
    /// to the load factor of first slip, or for a reserve to the greatest force at rest. Places are in units of the grasp's size, squeezes in units
    /// of the greatest allowed force. `None` where no multipliers were found.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Option<f64>>"))]
    pub residual: Option<f64>,
    /// Number of starting grasps from which a search was made.
    pub starts: usize,
    /// Number of steps from all starts, including refused ones.
    pub steps: usize,
}

/// The place of a contact, and its command.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Placed<const C: usize> {
    /// The contact, or the point of a soft fingertip.
    pub contact: WholeContact,
    /// Name of the surface along which the contact may move, if any: "edge", "circle", …
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub surface: Option<String>,
    /// Contact point, m.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub point: SVector<f64, C>,
    /// Unit normal into the object.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub normal: SVector<f64, C>,
    /// Unit first tangent. The contact frame tilts with the normal and does not turn about it.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub tangent: SVector<f64, C>,
    /// Command in the contact frame, m.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub command: SVector<f64, C>,
    /// Straight distance from the place given, m.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub moved: f64,
    /// Normal force with which the command presses, N; `None` unless the search may change it.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub pressed_with: Option<f64>,
    /// Normal force at rest, N.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub normal_force: f64,
}

/// One active sticking condition or limit that prevents a later first slip or a larger reserve.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct InTheWay {
    /// The contact to which the condition or limit belongs.
    pub contact: WholeContact,
    /// The sticking condition or limit, with its multiplier.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub binds: Binds,
}

/// An active sticking condition or limit with its multiplier. A gain is an increase of the load factor of first slip, or of the reserve, N.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "what", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Binds {
    /// The contact slides or opens first.
    FirstSlip {
        /// Index of the load, from 0; `None` for a force of any direction.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        load: Option<usize>,
        /// Multiplier of this sticking condition in the optimality conditions; the multipliers of all sticking conditions add up to one.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        share: f64,
    },
    /// The contact has the least friction in reserve.
    Reserve {
        /// Index of the load, from 0; `None` for a force of any direction.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        load: Option<usize>,
        /// Multiplier of this sticking condition, as for the first slip.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        share: f64,
    },
    /// At rest the contact presses with its greatest allowed force.
    Force {
        /// Gain per newton of a larger limit.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        per_newton: f64,
    },
    /// The command of the contact presses with its greatest allowed force.
    Pressed {
        /// Gain per newton of a larger limit.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        per_newton: f64,
    },
    /// The command of the contact does not press at all.
    NotPressed {
        /// Gain per newton with which the command would pull instead of pressing.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        per_newton: f64,
    },
    /// The contact is at the end of its surface, or at the end of its part of the surface.
    End {
        /// Gain per metre of a longer surface.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        per_metre: f64,
    },
    /// At rest the contact is at the edge of its friction cone.
    Rest {
        /// Gain per newton of additional friction.
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
    /// To first order nothing nearby is better: gradients of active sticking conditions and of active limits cancel up to a millionth.
    Optimum,
    /// No step gains more than rounding, but gradients do not cancel. Perhaps two sticking conditions of one contact are equally near to being broken
    /// there.
    Stalled,
    /// The search used all of its steps.
    OutOfSteps,
    /// At any other place nothing would balance the loads. For instance, two point contacts in space resist no moment about the line that joins them.
    Unbalanced,
    /// No contact slides, however large the loads are.
    NothingSlides,
    /// Every start fails, the given grasp and the random ones: at rest some contact does not stick, or nothing resists the loads. With a reserve as
    /// the goal some contact does not stick under the loads.
    NoStart,
}

impl<const C: usize> Improved<C> {
    /// Whether multipliers prove that, to first order, no place and squeeze nearby is better.
    #[must_use]
    pub fn is_locally_best(&self) -> bool {
        self.search == SearchEnd::Optimum
    }
}
