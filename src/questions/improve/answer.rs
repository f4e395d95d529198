//! The answer of the search for better finger placement. A place is the position of a contact on its curve or surface. The commanded normal force of
//! a contact is that which its command causes with the object held in place. A design point is one choice of all places and commanded normal forces.
//! The goal is the value that the search maximises: the load factor of first slip, or the reserve. The reserve is the least margin of a contact force
//! to the boundary of its friction cone, N. The base load acts before the loads of the question grow; at rest means under the base load.

use nalgebra::SVector;

use super::goal::ImproveGoal;
use crate::equilibrium::TooFar;
use crate::grasp::WholeContact;
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// The best places and commanded normal forces that the search found; its [`Display`](std::fmt::Display) states them in a sentence.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Improved<const C: usize> {
    /// The goal of the search, first slip or reserve. Its values in the given and in the best grasp are `before` and `after`.
    #[cfg_attr(feature = "serde", serde(default))]
    pub goal: ImproveGoal,
    /// Value of the goal for the given grasp, the least over all loads. It is the load factor of first slip, or the reserve, N (the margin of a
    /// contact force to the boundary of its friction cone). `None` if a contact slides under the base load, no equilibrium under the base load is
    /// found, or, for a reserve, a contact slides under a load. Zero if nothing slides under the base load, but a contact touches without force: it
    /// slides under any load, however small.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Option<f64>>"))]
    pub before: Option<f64>,
    /// Value of the goal for the best grasp found. `None` if no grasp was found that sticks under the base load and, for a reserve, under the loads.
    /// Infinite if no contact slides however large the loads are.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Option<f64>>"))]
    pub after: Option<f64>,
    /// The reason why the answer for the best grasp cannot be trusted at rest, under a load of the question or at first slip. It is a motion that is
    /// not small, or [buckling](TooFar::Buckles). If there is no such reason, it is `None` and omitted.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub too_far: Option<TooFar>,
    /// Contacts that use all their friction at rest. With a little less friction, or with places rounded to fewer digits, such a contact may slide
    /// before any load acts.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub at_their_limit: Vec<WholeContact>,
    /// The magnitude of the load, N, if it is a single force. The load factor of first slip times this magnitude is the force at first slip.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub force: Option<f64>,
    /// Place and command (displacement commanded to the contact spring) of every contact in the best grasp found; empty if no grasp was found.
    pub contacts: Vec<Placed<C>>,
    /// The active sticking conditions and the active limits of forces, commands and places that prevent a larger value, each with its multiplier.
    /// Empty if no multipliers were found.
    pub in_the_way: Vec<ActiveConstraint>,
    /// How the search for the best grasp found ended.
    pub search: SearchEnd,
    /// The larger of two residuals of first-order optimality. One is the largest component of the sum of the gradients of sticking conditions and
    /// limits, weighted by their multipliers. The other is the residual of complementarity between multipliers and the slack of their conditions and
    /// limits. The residual is relative to the load factor of first slip, or for a reserve to the greatest force under the base load. Places are in
    /// units of the grasp's size, a length, and commanded normal forces in units of the greatest allowed force. `None` if no multipliers were found.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Option<f64>>"))]
    pub residual: Option<f64>,
    /// Number of starting grasps (the given grasp and random grasps) in which all contacts stick under the base load.
    pub starts: usize,
    /// Number of steps tried in the ascents from all starts, including refused steps.
    pub steps: usize,
}

/// The place of one contact point in the best grasp found, and its command.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Placed<const C: usize> {
    /// The contact; of a soft fingertip one of its points.
    pub contact: WholeContact,
    /// Name of the surface along which the contact may move, if any: "edge", "circle", …
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub surface: Option<String>,
    /// Contact point in the best grasp found, m.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub point: SVector<f64, C>,
    /// Unit normal into the object in the best grasp found.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub normal: SVector<f64, C>,
    /// Unit first tangent of the contact frame. Compared with the given grasp, this frame has tilted with the normal and has not turned about it.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub tangent: SVector<f64, C>,
    /// Command in the contact frame, m, the clearance included in its normal component.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub command: SVector<f64, C>,
    /// Straight distance from the point of this contact in the given grasp, m.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub moved: f64,
    /// Normal force that the command causes if the object is held in place, N: the value for
    /// [`Contact::pressed_with`](crate::grasp::Contact::pressed_with). `None` unless the search may change the command. A contact that the search
    /// leaves without force keeps its command.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub pressed_with: Option<f64>,
    /// Normal force under the base load and the commands, N. The object gives way to the commands, so this force differs from [`Self::pressed_with`].
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub normal_force: f64,
}

/// One active sticking condition of a contact, or one active limit of its force, command or place. It prevents a larger load factor of first slip, or
/// a larger reserve (least margin of a contact force to the boundary of its friction cone).
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ActiveConstraint {
    /// The contact whose sticking condition or limit is active.
    pub contact: WholeContact,
    /// The sticking condition or limit that is active, with its multiplier.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub binds: ActiveConstraintKind,
}

/// An active sticking condition, or an active limit of a force, command or place, with its multiplier. "Gain" means an increase of the load factor of
/// first slip, or of the reserve, N.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "what", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum ActiveConstraintKind {
    /// The contact slides or opens first, under the load with this index.
    FirstSlip {
        /// Index of the load under which the contact slips, from 0; `None` for a force of any direction.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        load: Option<usize>,
        /// Multiplier of this sticking condition in the optimality conditions; the multipliers of all sticking conditions add up to one.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        share: f64,
    },
    /// The contact has the least reserve (margin of its force to the boundary of its friction cone) under the load with this index.
    Reserve {
        /// Index of the load under which the reserve is least, from 0; `None` for a force of any direction.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        load: Option<usize>,
        /// Multiplier of this sticking condition in the optimality conditions; the multipliers of all sticking conditions add up to one.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        share: f64,
    },
    /// Under the base load the contact's normal force is the greatest allowed force.
    Force {
        /// Gain of the goal for each newton added to the greatest allowed force.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        per_newton: f64,
    },
    /// The command of the contact has its greatest allowed force ([`Placed::pressed_with`]).
    Pressed {
        /// Gain of the goal for each newton added to the greatest allowed force.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        per_newton: f64,
    },
    /// The command of the contact causes no force ([`Placed::pressed_with`] is zero), or the contact touches without force: it does not press at all.
    NotPressed {
        /// Gain of the goal for each newton with which the command pulls instead of pressing.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        per_newton: f64,
    },
    /// The contact is at the end of its curve or surface, or at an edge of its segment or triangle.
    End {
        /// Gain of the goal for each metre by which the surface, segment or triangle is made longer.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        per_metre: f64,
    },
    /// Under the base load the contact force is at the boundary of its friction cone.
    Rest {
        /// Gain of the goal for each newton added to the margin of sticking under the base load.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        per_newton: f64,
    },
}

/// How the search that led to the best grasp ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum SearchEnd {
    /// To first order no design point nearby is better: the weighted gradients of active sticking conditions and active limits cancel up to a
    /// millionth.
    Optimum,
    /// No step improves the goal by more than rounding, but the weighted gradients of active sticking conditions and limits do not cancel. Perhaps
    /// two sticking conditions of one contact are equally near to being broken. Or a load presses on a contact that has no force at rest.
    Stalled,
    /// The search used all of its steps before the gradients cancelled.
    OutOfSteps,
    /// The contacts cannot be moved: if some contact is at another place, contact forces no longer balance the loads. An example is a grasp by two
    /// point contacts in space, which resist no moment about the line that joins them.
    Unbalanced,
    /// No contact slides, however large the loads are: the load factor of first slip is infinite.
    NothingSlides,
    /// Every start fails, the given grasp and the random ones: under the base load some contact does not stick, or nothing resists the loads. With a
    /// reserve as the goal some contact does not stick under the loads.
    NoStart,
}

impl<const C: usize> Improved<C> {
    /// Whether multipliers prove that, to first order, no nearby choice of places and commanded normal forces is better.
    #[must_use]
    pub fn is_locally_best(&self) -> bool {
        self.search == SearchEnd::Optimum
    }
}
