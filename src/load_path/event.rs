//! What happens on a load path.

use nalgebra::SVector;

use super::drive_change::PartChange;
use super::jump::{Jump, JumpSlip};
use crate::equilibrium::{Equilibrium, Outcome};
use crate::error::ContactLabel;
use crate::grasp::{Coordinates, Engine, Motion, PartLabel, Wrench};
use crate::numerics::{Size, Vector};
use crate::prelude::*;
use crate::search::Doubt;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// Something changes: one or more contacts, at one load.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Event<const C: usize> {
    /// The leg, from 0.
    pub leg: usize,
    /// How much of the leg has been gone, from 0 to 1, exact up to rounding; where something slides on the round cone up to the
    /// error of the steps, see [`LoadPath::step_error`](super::LoadPath::step_error).
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub fraction: f64,
    /// The load there.
    pub load: Wrench<C>,
    /// What changes, contact by contact; empty where only a motion has become free, and where a leg begins as contacts are but could go on
    /// otherwise as well. Symmetric grasps change several at once.
    pub changes: Vec<ContactChange<C>>,
    /// What changes in the hand, if one holds the object: drives of joints and tendons that yield, hold, slacken or tighten.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub drives: Vec<PartChange>,
    /// Unit motions that nothing resists from here on: the twist is known up to them, the path goes on without moving
    /// along them, unless a contact that touches without force pushes the object.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub free_motions: Vec<Motion<C>>,
    /// Other ways in which the contacts on an edge could go on. The continuation is unique if this is `Some(0)`, which a P-matrix of the
    /// rates proves or, among few contacts, trying all. `None`, and not written, if neither says, as at the apex of a round cone.
    ///
    /// The path prefers that nothing changes; then that what slides goes on sliding and what has reached an edge slides; then
    /// that everything sticks; then what Lemke's method finds. Of the motions that the same forces allow it takes one in which
    /// contacts without force do not drag the object along.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub other_continuations: Option<usize>,
    /// The equilibrium there. Its states are those before the event (at the very start of a path, where there is no before, those after it).
    pub state: Equilibrium<C>,
    /// What comes of it at this load, where a contact begins to slide with less friction than at rest, or where the object moves freely until a gap closes.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub jump: Option<Box<Jump<C>>>,
}

/// A contact that does something else from an event on.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ContactChange<const C: usize> {
    /// Which contact.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub contact: ContactLabel,
    /// What it does from here on.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub what: Change<C>,
}

/// What a contact does from an event on.
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
        /// Unit direction in which the finger slips over the body, coordinate axes; friction pulls the body that way.
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
    /// A sliding contact turns to another facet or corner of its cone (space, on a polygon; on the round cone it turns all the time).
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
        /// Unit direction in which the finger slips over the body, coordinate axes; friction pulls the body that way.
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
    /// This equilibrium ends here: no way goes on from it with a growing load. Whether another exists beyond is a question of its own, see
    /// [`LoadPath::beyond`](super::LoadPath::beyond).
    Lost(Box<Loss<C>>),
    /// There is no equilibrium to start from.
    NoStart(Box<Outcome<C>>),
    /// The path could not be followed further, and whether it goes on or ends there is not known. It holds up to there.
    Undecided {
        /// The leg, from 0.
        leg: usize,
        /// How much of the leg has been gone, from 0 to 1.
        fraction: f64,
        /// Why.
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

/// Where an equilibrium cannot be continued.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Loss<const C: usize> {
    /// The leg, from 0.
    pub leg: usize,
    /// How much of the leg has been gone, from 0 to 1.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub fraction: f64,
    /// The load there.
    pub load: Wrench<C>,
    /// What ends the equilibrium.
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
    /// Contacts that begin to slide with less friction than at rest, and how far they had slipped when nothing caught the object any more: all at this load.
    /// Empty where no friction fell.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub jumped: Vec<JumpSlip<C>>,
    /// The virtual motion against which contacts do the least there, in inside coordinates.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(crate) against: Option<Coordinates<C>>,
    /// The motion with which the object leaves, in inside coordinates.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(crate) leaves: Option<Coordinates<C>>,
}

impl<const C: usize> Loss<C> {
    /// The virtual motion against which contacts do the least there, in inside coordinates.
    pub(crate) fn virtual_motion(&self) -> Option<&Coordinates<C>> {
        self.against.as_ref()
    }

    /// This loss with another virtual motion than that with which the object leaves.
    pub(super) fn and_virtually<D: Size>(mut self, against: Option<&Vector<D>>) -> Self {
        self.against = against.map(Coordinates::of);
        self
    }

    /// This loss with the motion with which the object leaves, in inside coordinates.
    pub(super) fn leaving<D: Size>(mut self, grasp: &Engine<D, C>, motion: Option<&Vector<D>>) -> Self {
        self.motion = motion.map(|v| grasp.motion_outside(v));
        self.leaves = motion.map(Coordinates::of);
        self.against.clone_from(&self.leaves);
        self
    }
}

/// What ends an equilibrium as the load grows: all that can be said of the place alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum LossKind {
    /// The load has a smooth maximum along a sliding arc of the round cone: with these states the equilibrium goes on under less load only.
    Fold,
    /// Contacts stand on an edge, and in no combination of their states are there rates with a growing load.
    Corner,
    /// The object moves on without bound, and the load comes closer to this one and never reaches it. Directions of sliding have turned
    /// along the motion, which nothing else resists.
    Asymptote,
    /// From here on nothing resists the motion, on which the load works as it changes.
    GivesWay,
    /// Motions cease to be [small](crate::Settings::small_motions) there: what comes next small motions do not tell.
    TooFar,
    /// A contact with infinite friction loses its normal force while it still holds a tangential one; or all of the lip of a suction cup is open,
    /// and its vacuum is gone.
    LetsGo,
}
