//! Events of a load path, and how it ends.

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

/// One or more contacts change at one load.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Event<const C: usize> {
    /// The leg, from 0.
    pub leg: usize,
    /// Fraction of the leg already followed, from 0 to 1, exact up to rounding; where a contact slides on the round cone up to the error of the
    /// steps, see [`LoadPath::step_error`](super::LoadPath::step_error).
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub fraction: f64,
    /// The load there.
    pub load: Wrench<C>,
    /// Changes, contact by contact. Empty where only a motion has become free, and where contacts at the start of a leg keep their states but could
    /// continue otherwise as well. Symmetric grasps change several contacts at once.
    pub changes: Vec<ContactChange<C>>,
    /// Changes in the hand, if one holds the object: drives of joints and tendons that yield, hold, slacken or tighten.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub drives: Vec<PartChange>,
    /// Unit motions that nothing resists from here on: the twist is known up to them. The path continues without moving along them, unless a contact
    /// that touches without force pushes the object.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub free_motions: Vec<Motion<C>>,
    /// Number of other continuations of the contacts on an edge. `Some(0)` means that the continuation is unique: a P-matrix of the rates proves that
    /// or, among few contacts, a trial of all states. `None`, and not written, if neither decides, as at the apex of a round cone.
    ///
    /// The path prefers in this order: nothing changes; sliding contacts keep sliding and contacts at an edge slide; everything sticks; the solution
    /// of Lemke's method. Of the motions that the same forces allow it takes one in which contacts without force do not drag the object along.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub other_continuations: Option<usize>,
    /// The equilibrium there, with contact states before the event (at the very start of a path those after it).
    pub state: Equilibrium<C>,
    /// The jump at this load, where a contact begins to slide with less friction than at rest, or where the object moves freely until a gap closes.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub jump: Option<Box<Jump<C>>>,
}

/// A contact whose state changes at an event.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ContactChange<const C: usize> {
    /// The contact that changes.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub contact: ContactLabel,
    /// Its behaviour from here on.
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
        /// Unit direction in which the finger slips over the body, coordinate axes; friction pulls the body in this direction.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        direction: SVector<f64, C>,
    },
    /// A sliding contact sticks.
    Sticks,
    /// A sliding contact slides back.
    Reverses {
        /// Its new direction, as for [`Self::Slides`].
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        direction: SVector<f64, C>,
    },
    /// A sliding contact turns to another facet or corner of its cone (space, on a polygon; on the round cone it turns continuously).
    Turns {
        /// Its new direction, as for [`Self::Slides`].
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        direction: SVector<f64, C>,
    },
    /// A closed contact opens, F_n = 0.
    Opens,
    /// An open contact closes and sticks; it starts with F_t = 0.
    Closes,
    /// An open contact closes and slides from the start.
    ClosesSliding {
        /// Unit direction in which the finger slips over the body, coordinate axes; friction pulls the body in this direction.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        direction: SVector<f64, C>,
    },
}

/// How a load path ends.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum PathEnd<const C: usize> {
    /// All legs were followed to their end.
    Completed,
    /// The equilibrium ends here: no rates continue it under a growing load. Whether another exists beyond is a separate question, see
    /// [`LoadPath::beyond`](super::LoadPath::beyond).
    Lost(Box<Loss<C>>),
    /// There is no equilibrium to start from.
    NoStart(Box<Outcome<C>>),
    /// The path could not be followed further, and it is not known whether it continues or ends there. It is valid up to there.
    Undecided {
        /// The leg, from 0.
        leg: usize,
        /// Fraction of the leg already followed, from 0 to 1.
        fraction: f64,
        /// The reason.
        doubt: Doubt,
    },
}

impl<const C: usize> PathEnd<C> {
    /// Where equilibrium was lost, if it was.
    #[must_use]
    pub fn loss(&self) -> Option<&Loss<C>> {
        if let Self::Lost(loss) = self { Some(loss) } else { None }
    }

    /// The leg on which the path ended, from 0; `None` where it was completed or had no start.
    #[must_use]
    pub fn leg(&self) -> Option<usize> {
        self.place().map(|(leg, _)| leg)
    }

    /// The fraction of [`Self::leg`] at which the path ended, from 0 to 1.
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

/// The place where an equilibrium cannot be continued.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Loss<const C: usize> {
    /// The leg, from 0.
    pub leg: usize,
    /// Fraction of the leg already followed, from 0 to 1.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub fraction: f64,
    /// The load there.
    pub load: Wrench<C>,
    /// The reason for the end of the equilibrium.
    pub kind: LossKind,
    /// The contacts that stand on the edge of their cone there.
    pub contacts: Vec<ContactLabel>,
    /// The joints and tendons of a hand whose drives have reached their limit there.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub drives: Vec<PartLabel>,
    /// The unit motion with which the object leaves: everything on an edge slides along its friction force, or opens.
    /// `None` if those states do not determine one.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub motion: Option<Motion<C>>,
    /// The jump of slip at this load: contacts whose friction falls from the static to the kinetic value, and how far each slides before no further
    /// equilibrium exists. Empty where no friction falls.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub jumped: Vec<JumpSlip<C>>,
    /// The virtual motion against which contacts can resist least there, in inside coordinates.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(crate) against: Option<Coordinates>,
    /// The motion with which the object leaves, in inside coordinates.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(crate) leaves: Option<Coordinates>,
}

impl<const C: usize> Loss<C> {
    /// The virtual motion against which contacts can resist least there, in inside coordinates.
    pub(crate) fn virtual_motion(&self) -> Option<&Coordinates> {
        self.against.as_ref()
    }

    /// This loss with a virtual motion other than the one with which the object leaves.
    pub(super) fn and_virtually(mut self, against: Option<&Vector>) -> Self {
        self.against = against.map(Coordinates::of);
        self
    }
}

impl Loss<3> {
    /// This loss with the motion with which the object leaves, in inside coordinates.
    pub(super) fn leaving(mut self, grasp: &Engine, motion: Option<&Vector>) -> Self {
        self.motion = motion.map(|v| grasp.motion_outside(v));
        self.leaves = motion.map(Coordinates::of);
        self.against.clone_from(&self.leaves);
        self
    }
}

/// The reason for the end of an equilibrium as the load grows, as far as the place alone determines it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum LossKind {
    /// The load has a smooth maximum along a sliding arc of the round cone: in these contact states the equilibrium continues under less load only.
    Fold,
    /// Contacts stand on an edge, and in no combination of their states are there rates with a growing load.
    Corner,
    /// The object moves without bound while the load approaches this one and never reaches it. Directions of sliding have turned along the motion,
    /// which nothing else resists.
    Asymptote,
    /// From here on nothing resists the motion, and the change of the load does work on it.
    GivesWay,
    /// Motions cease to be [small](crate::Settings::small_motions) there: the theory of small motions does not say what follows.
    TooFar,
    /// A contact with infinite friction loses its normal force while it still carries a tangential one; or the whole lip of a suction cup is open,
    /// and its vacuum is gone.
    LetsGo,
}
