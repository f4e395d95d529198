//! Events of a load path, at which contacts change their states (open, sticking or sliding), and the end of a path. A leg is a section of the load
//! program. A continuation is a choice of contact states with which the path goes on; one event may allow several, from which the path takes one. A
//! drive is the spring of a joint or tendon of a hand, with its force limit. A jump is a motion of the object, at constant load, to another
//! equilibrium. In the engine's coordinates moments and rotations refer to the centroid of the contacts.

use nalgebra::SVector;

use super::drive_change::PartChange;
use super::jump::{Jump, JumpSlip};
use crate::equilibrium::{Equilibrium, Outcome};
use crate::error::ContactLabel;
use crate::grasp::{Coordinates, Engine, Motion, PartLabel, Wrench};
use crate::numerics::Vector;
use crate::prelude::*;
use crate::search::Doubt;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// An event: one or more contacts change their states at one point of the path.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Event<const C: usize> {
    /// Index of the leg (section of the load program), from 0. Sentences count legs from 1.
    pub leg: usize,
    /// Fraction of the leg that is done, from 0 to 1. It is exact up to rounding. If a contact slides on the round cone, it is exact up to the error
    /// of the integration steps, which [`LoadPath::step_error`](super::LoadPath::step_error) estimates.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub fraction: f64,
    /// The load at the event.
    pub load: Wrench<C>,
    /// Changes of contact states, contact by contact. Empty if the only change is that nothing resists some motion any more. Also empty at the start
    /// of a leg if contacts keep their states although other continuations exist. Symmetric grasps change several contacts at once.
    pub changes: Vec<ContactChange<C>>,
    /// If a hand holds the object: the joints and tendons whose drives yield, hold again, slacken or tighten at this event.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub drives: Vec<PartChange>,
    /// Unit motions that nothing resists from this event on: any multiple of them may be added to the twist. The path continues without moving along
    /// them, unless a contact that touches without force pushes the object.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub free_motions: Vec<Motion<C>>,
    /// Number of other combinations of states with which the contacts on the boundary of their cones could continue. `Some(0)` means that the
    /// continuation is unique. Then either the matrix of the complementarity problem for the rates is a P-matrix, or all states of few contacts were
    /// tried without another solution. The number is `None`, which is not serialised, if neither test gives it, as at the apex of a round cone.
    ///
    /// Of several continuations the path takes the first that exists in this order: nothing changes; sliding contacts keep sliding and contacts on
    /// the boundary of their cones slide; everything sticks; the solution of Lemke's method. If several motions are possible with the same forces,
    /// the path takes a motion in which contacts without force do not drag the object along.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub other_continuations: Option<usize>,
    /// The equilibrium at the event, with the contact states before the event (at the very start of a path, the states after it).
    pub state: Equilibrium<C>,
    /// The jump at this load: a contact's friction falls as it begins to slide, the object moves freely until a gap closes, or it snaps over to
    /// another equilibrium. `None` without a jump.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub jump: Option<Box<Jump<C>>>,
}

/// A contact whose state changes at an event.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ContactChange<const C: usize> {
    /// The contact whose state changes.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub contact: ContactLabel,
    /// The behaviour of the contact from this event on.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub what: Change<C>,
}

/// The behaviour of a contact from an event on.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "what", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Change<const C: usize> {
    /// A sticking contact starts to slide, `|F_t| = μ F_n`.
    Slides {
        /// Unit direction, along the coordinate axes, in which the finger slips over the body; friction pulls the body in this direction.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        direction: SVector<f64, C>,
    },
    /// A sliding contact sticks.
    Sticks,
    /// A sliding contact reverses its direction.
    Reverses {
        /// The new unit direction, along the coordinate axes, in which the finger slips over the body.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        direction: SVector<f64, C>,
    },
    /// A sliding contact turns to another facet or corner of its cone (only in space, on a polygonal cone; on the round cone the direction of sliding
    /// turns continuously).
    Turns {
        /// The new unit direction, along the coordinate axes, in which the finger slips over the body.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        direction: SVector<f64, C>,
    },
    /// A closed contact opens, F_n = 0.
    Opens,
    /// An open contact closes and sticks; it starts with F_t = 0.
    Closes,
    /// An open contact closes and slides from the start.
    ClosesSliding {
        /// Unit direction, along the coordinate axes, in which the finger slips over the body; friction pulls the body in this direction.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        direction: SVector<f64, C>,
    },
}

/// The end of a load path.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum PathEnd<const C: usize> {
    /// All legs were followed to their end.
    Completed,
    /// The equilibrium ends here: it continues with no combination of contact states as the load grows. Whether another equilibrium exists beyond is
    /// a separate question, which [`LoadPath::beyond`](super::LoadPath::beyond) answers.
    Lost(Box<Loss<C>>),
    /// There is no equilibrium from which the path could start.
    NoStart(Box<Outcome<C>>),
    /// The path could not be followed beyond this point, and it is not known whether an equilibrium continues it. Up to this point the path is
    /// valid.
    Undecided {
        /// Index of the leg (section of the load program), from 0.
        leg: usize,
        /// Fraction of the leg that is done, from 0 to 1.
        fraction: f64,
        /// The reason why the path could not be followed further.
        doubt: Doubt,
    },
}

impl<const C: usize> PathEnd<C> {
    /// The loss of equilibrium, if the path ended in a loss; `None` for every other end.
    #[must_use]
    pub fn loss(&self) -> Option<&Loss<C>> {
        if let Self::Lost(loss) = self { Some(loss) } else { None }
    }

    /// The index of the leg on which the path ended, from 0; `None` if the path was completed or had no start.
    #[must_use]
    pub fn leg(&self) -> Option<usize> {
        self.place().map(|(leg, _)| leg)
    }

    /// The fraction of [`Self::leg`] at which the path ended, from 0 to 1; `None` if the path was completed or had no start.
    #[must_use]
    pub fn fraction(&self) -> Option<f64> {
        self.place().map(|(_, fraction)| fraction)
    }

    fn place(&self) -> Option<(usize, f64)> {
        match self {
            Self::Completed | Self::NoStart(_) => None,
            Self::Lost(loss) => Some((loss.leg, loss.fraction)),
            Self::Undecided { leg, fraction, .. } => Some((*leg, *fraction)),
        }
    }
}

/// The point of a load path beyond which its equilibrium cannot be continued.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Loss<const C: usize> {
    /// Index of the leg (section of the load program), from 0.
    pub leg: usize,
    /// Fraction of the leg that is done at the loss, from 0 to 1.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub fraction: f64,
    /// The load at the loss.
    pub load: Wrench<C>,
    /// The reason for the end of the equilibrium.
    pub kind: LossKind,
    /// The contacts that are on the boundary of their cone at the loss.
    pub contacts: Vec<ContactLabel>,
    /// The joints and tendons of a hand whose drives are at a limit of their torque or force at the loss.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub drives: Vec<PartLabel>,
    /// The unit motion with which the object leaves. In it every contact on the boundary of its cone slides, with its finger slipping along the
    /// friction force, or opens. `None` if these contact states do not determine a motion.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub motion: Option<Motion<C>>,
    /// The slips in a jump (a motion at constant load) that starts at this load and leads to no equilibrium. The jump begins when the friction of
    /// contacts falls from its static to its kinetic value. Each entry is a contact that slides in the jump, with its slip in the jump until the
    /// equilibrium is lost. Empty if no friction fell.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub jumped: Vec<JumpSlip<C>>,
    /// A virtual motion of the object, in the engine's coordinates, along which contact forces do no negative work at the loss, or little. If the
    /// growing load does positive work along this motion, the motion may prove that no equilibrium exists beyond the loss. `None` if no such motion
    /// is known.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(crate) against: Option<Coordinates>,
    /// The motion with which the object leaves, in the engine's coordinates.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(crate) leaves: Option<Coordinates>,
}

impl<const C: usize> Loss<C> {
    /// The virtual motion of the object, about the centroid of the contacts, that may prove the loss: contact forces do no negative work along this
    /// motion, or little. `None` if no such motion is known.
    pub(crate) fn virtual_motion(&self) -> Option<&Coordinates> {
        self.against.as_ref()
    }

    /// This loss with `against` as the virtual motion that may prove it. That motion need not be the motion with which the object leaves.
    pub(super) fn and_virtually(mut self, against: Option<&Vector>) -> Self {
        self.against = against.map(Coordinates::of);
        self
    }
}

impl Loss<3> {
    /// This loss with `motion` as the motion with which the object leaves, about the centroid of the contacts. The same motion is also taken as
    /// the virtual motion that may prove the loss.
    pub(super) fn leaving(mut self, grasp: &Engine, motion: Option<&Vector>) -> Self {
        self.motion = motion.map(|v| grasp.motion_outside(v));
        self.leaves = motion.map(Coordinates::of);
        self.against.clone_from(&self.leaves);
        self
    }
}

/// The reason for the end of an equilibrium under a growing load, as far as forces and contact states at the end determine it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum LossKind {
    /// The load has a smooth maximum while directions of sliding turn on the round cone. With the contact states at the maximum the equilibrium
    /// continues only under a smaller load.
    Fold,
    /// Contacts are on the boundary of their cones. There is no combination of their states for which rates of forces and motion exist under the
    /// growing load.
    Corner,
    /// The object moves without bound while the load approaches the load of this loss and never reaches it. All directions of sliding have turned
    /// towards this motion, and only friction at its limit resists it.
    Asymptote,
    /// From this load on nothing resists some motion, and the change of the load does work along this motion.
    GivesWay,
    /// Motions cease to be [small](crate::Settings::small_motions) at this load. For larger loads the theory of small motions does not hold.
    TooFar,
    /// A contact with infinite friction loses its normal force while it still carries a tangential force. This kind also covers a suction cup whose
    /// whole lip is open, so that its vacuum is gone.
    LetsGo,
}
