//! The answer as physics.

use nalgebra::SVector;

use super::accuracy::Accuracy;
use super::hand_answer::{JointAnswer, TendonAnswer};
use super::pad_answer::PadAnswer;
use super::residuals::Residuals;
use crate::contact::{PolygonCone, State};
use crate::error::ContactLabel;
use crate::forms::LeftOut;
use crate::grasp::{Coordinates, Motion, Twist, Wrench};
use crate::search::{Doubt, Rung, Settings};
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// How a question for an equilibrium ends.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "outcome", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Outcome<const C: usize> {
    /// The grasp holds: here is where the object goes and what the contacts carry.
    Equilibrium(Box<Equilibrium<C>>),
    /// No quasi-static equilibrium exists under this load, with the proof.
    NoEquilibrium(NoEquilibrium<C>),
    /// None was found and none was ruled out.
    Undecided(Undecided),
}

impl<const C: usize> Outcome<C> {
    /// The equilibrium, if there is one.
    #[must_use]
    pub fn equilibrium(&self) -> Option<&Equilibrium<C>> {
        match self {
            Self::Equilibrium(equilibrium) => Some(equilibrium),
            _ => None,
        }
    }
}

/// An equilibrium of the elastic contacts, the load and the finger commands.
///
/// One that is read from a file, or told by a scene, says what is written here and no more: further questions to a grasp about it, such as
/// [`Grasp::accuracy`](crate::ask::Grasp::accuracy), have no answer.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Equilibrium<const C: usize> {
    /// The load it balances, about the origin.
    pub load: Wrench<C>,
    /// Motion of the object from where it was before load and commands: translation of the origin (m) and rotation (rad). Where `free_motions` are
    /// left it is the one of least norm, unless gaps and slips need more; on a load path the one nearest to where the object was. The norm is
    /// about the centroid of the contact points, with lengths in units of their root mean square distance from it; a joint's displacement
    /// counts times a power of two near the longest motion of its contacts.
    pub twist: Twist<C>,
    /// Contact by contact, in the order of the grasp; a soft fingertip of a scene point by point.
    pub contacts: Vec<ContactAnswer<C>>,
    /// Soft fingertips, the points of each together.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub pads: Vec<PadAnswer<C>>,
    /// Joint by joint, if a [hand](crate::grasp::Hand) holds the object, finger by finger.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub joints: Vec<JointAnswer>,
    /// Tendon by tendon.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub tendons: Vec<TendonAnswer>,
    /// How well the answer satisfies the conditions, recomputed from the question.
    pub residuals: Residuals,
    /// How far it is from the exact answer, where that was asked for: `None` unless a scene that asks to `solve` has told it, see
    /// [`Grasp::accuracy`](crate::ask::Grasp::accuracy).
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub accuracy: Option<Accuracy>,
    /// The friction cone the answer is for.
    pub cone: Cone,
    /// By which rule this equilibrium was found; there may be others, see
    /// [`Grasp::equilibria`](crate::ask::Grasp::equilibria).
    pub rule: Rung,
    /// Energy stored in the springs, those of joints included, `Σ ½ F²/k`, J.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub stored_energy: f64,
    /// Unit motions that no contact resists in its present state, m and rad: the twist is known up to them, the forces do not feel
    /// them. Of length one about the centroid of the contact points, a rotation counted in radians times their root mean square distance
    /// from it, and joints as in the norm of `twist`; either sign is meant. None where every motion is resisted.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub free_motions: Vec<Motion<C>>,
    /// Unit motions along which the object stays in equilibrium while its forces change: this equilibrium is one of
    /// a whole line. Lengths as for `free_motions`. Empty but at loads where friction just balances on a wedge.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub neutral_motions: Vec<Motion<C>>,
    /// On the round cone: the largest change of a contact force, N, from the answer of the polygon that the search started from.
    /// `None` where there was no polygon: nothing slides, Newton's method found it, the state is one of a load path, or the answer is for the polygon itself.
    #[cfg_attr(
        feature = "serde",
        serde(default, with = "AsComputed::<Option<f64>>", skip_serializing_if = "Option::is_none")
    )]
    pub change_from_polygon: Option<f64>,
    /// What was done to find it; of this the pivots are written.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub work: WorkDone,
    /// What the questions to an answer start from.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(crate) local: LocalAnswer<C>,
}

impl<const C: usize> Equilibrium<C> {
    /// Rotation from which motions are not small, rad: there the first order misses a tenth of an arm's length. It only labels answers.
    pub const LARGE_ROTATION: f64 = 0.5;

    /// Whether the object turns by more than [`Self::LARGE_ROTATION`]. Contact points and normals stay where they are in all that is computed here. So such
    /// an answer solves the question as it was put, and says little about the object. A taper of 1e-9 rad holds any load, once the object has
    /// gone far enough along it.
    #[must_use]
    pub fn is_beyond_small_motions(&self) -> bool {
        // One angle in the plane, three in space.
        let rotation = self.twist.components().iter().skip(C);
        rotation.map(|angle| angle * angle).sum::<f64>().sqrt() > Self::LARGE_ROTATION
    }

    /// This answer as it reads back once it is written.
    #[cfg(feature = "serde")]
    pub(crate) fn written(self) -> Self {
        let work = WorkDone { pivots: self.work.pivots, ..WorkDone::default() };
        Self { work, local: LocalAnswer::default(), ..self }
    }

    /// Whether it tells enough of so many sites to be asked further.
    pub(crate) fn knows_all_of(&self, sites: usize) -> bool {
        self.local.states.len() == sites && self.contacts.len() + self.local.drive_forces.len() == sites
    }

    /// Forces of all sites: contacts, then the drives of a hand.
    pub(crate) fn site_forces(&self) -> Vec<SVector<f64, C>> {
        self.contacts
            .iter()
            .map(|contact| contact.force)
            .chain(self.local.drive_forces.iter().copied())
            .collect()
    }
}

/// The solution of the local problem behind an answer; empty where the answer was read.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct LocalAnswer<const C: usize> {
    pub(crate) states: Vec<State<C>>,
    /// Forces of the drives of a hand.
    pub(crate) drive_forces: Vec<SVector<f64, C>>,
    /// In inside coordinates.
    pub(crate) twist: Coordinates<C>,
    pub(crate) free_motions: Vec<Coordinates<C>>,
    /// Commanded displacements less clearance and less the slips.
    pub(crate) drives: Vec<SVector<f64, C>>,
    /// Slips that the drives count from.
    pub(crate) slips: Vec<SVector<f64, C>>,
}

/// The friction cone an answer is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Cone {
    /// The planar cone, which is polygonal by nature: nothing is approximated.
    Planar,
    /// A polygon in place of the round cone.
    Polygon(PolygonCone),
    /// The round cone in space.
    Round,
}

impl Cone {
    /// The cone that answers with C axes a contact are for.
    pub(crate) fn of<const C: usize>(settings: &Settings) -> Self {
        if settings.is_round::<C>() { Self::Round } else { Self::polygonal::<C>(settings) }
    }

    /// The polygonal cone of the settings, which is the exact one in the plane.
    pub(crate) fn polygonal<const C: usize>(settings: &Settings) -> Self {
        if C == 2 { Self::Planar } else { Self::Polygon(settings.cone) }
    }

    /// Facets of a formulation with this cone: 2 in the plane, and the one facet that touches a round cone.
    pub(crate) fn facets(self) -> usize {
        match self {
            Self::Planar => 2,
            Self::Polygon(polygon) => polygon.facets(),
            Self::Round => 1,
        }
    }
}

/// One contact of an equilibrium.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ContactAnswer<const C: usize> {
    /// Which contact.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub contact: ContactLabel,
    /// What the contact does.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub state: ContactState<C>,
    /// Force of the finger on the object in the contact frame, N: (`F_n`, `F_t`…); `F_n` > 0 pushes. Without friction `F_t` is zero.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub force: SVector<f64, C>,
    /// The same force along the coordinate axes, N.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub force_world: SVector<f64, C>,
    /// Gap between the surfaces along the normal, `n·u_c - a_n` if that is positive, m; zero for a closed contact.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub gap: f64,
    /// Slip of the finger over the body in the contact frame, `s = a_t - t·u_c - F_t/k_t`, m; its normal component is zero. Along F_t
    /// where it slides, zero where it sticks; on a load path all the slip so far, which a sticking contact keeps. For a separated or
    /// frictionless contact: how far the surfaces have moved past each other.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub slip: SVector<f64, C>,
    /// Friction in reserve of a sticking contact, N: `μ F_n - |F_t|` in the plane and on the round cone, on a polygon the least of
    /// `μ F_n - h·F_t` over its facets. Infinite if it is bonded or has infinite friction. Zero for a sliding, separated or
    /// frictionless contact.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub margin: f64,
    /// Whether working precision tells the state from its neighbours, where that was asked for: `None` unless a scene that asks to `solve` has
    /// told it, see [`Grasp::distinct`](crate::ask::Grasp::distinct).
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub distinct: Option<bool>,
    /// Displacement u_c of the body's core at the contact, that of the rigid object, coordinate axes, m.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub body_core: SVector<f64, C>,
    /// Displacement u_d of the body's surface, coordinate axes, m; `None`, and not written, if only the series stiffness is known.
    #[cfg_attr(
        feature = "serde",
        serde(
            default,
            with = "AsComputed::<Option<SVector<f64, C>>>",
            skip_serializing_if = "Option::is_none"
        )
    )]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub body_surface: Option<SVector<f64, C>>,
    /// Displacement u_e of the finger's surface, coordinate axes, m; `None`, and not written, if only the series stiffness is known.
    #[cfg_attr(
        feature = "serde",
        serde(
            default,
            with = "AsComputed::<Option<SVector<f64, C>>>",
            skip_serializing_if = "Option::is_none"
        )
    )]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub finger_surface: Option<SVector<f64, C>>,
}

impl<const C: usize> ContactAnswer<C> {
    /// Normal force `F_n`, N.
    #[must_use]
    pub fn normal_force(&self) -> f64 {
        self.force[0]
    }

    /// Size of the tangential force, `|F_t|`, N.
    #[must_use]
    pub fn friction_force(&self) -> f64 {
        self.force.iter().skip(1).fold(0.0, |h: f64, f| h.hypot(*f))
    }

    /// How much friction is used, `|F_t| / F_n`, to be compared with μ; zero without tangential force. Of no meaning for a bonded contact,
    /// whose normal force may pull.
    #[must_use]
    pub fn friction_used(&self) -> f64 {
        let friction = self.friction_force();
        if friction == 0.0 { 0.0 } else { friction / self.force[0] }
    }
}

impl ContactAnswer<2> {
    /// Tangential force `F_t` along t, N, with its sign.
    #[must_use]
    pub fn tangential_force(&self) -> f64 {
        self.force[1]
    }

    /// `F_t / F_n` with the sign of `F_t`, as the paper tabulates it; zero without tangential force.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        self.friction_used().copysign(self.force[1])
    }
}

/// What a contact does.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "state", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum ContactState<const C: usize> {
    /// Open, or touching without force: F = 0, gap >= 0.
    Separated,
    /// Closed and stuck: gap = 0, no slip (on a load path none beyond what it has slipped before), `|F_t| <= μ F_n`. The paper
    /// says rolling; today that word is kept for a fingertip that rolls. A bonded contact is always in this state, whatever its force.
    #[doc(alias = "rolling")]
    Sticking,
    /// Closed and on the edge of its cone: gap = 0, `|F_t| = μ F_n`, F_t along the slip.
    Sliding {
        /// Unit direction in which the finger slips over the body, coordinate axes; friction pulls the body that way.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        direction: SVector<f64, C>,
    },
    /// Closed without friction: F_t = 0 and the surfaces move past each other as they like.
    Frictionless,
}

/// What was done, and what was not needed.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct WorkDone {
    /// Pivots of Lemke's method, all runs together.
    pub pivots: usize,
    /// Complementary pairs of the largest problem that was made.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub rows_made: usize,
    /// Complementary pairs that a full kinematic formulation would have had besides, and why they were left out.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub rows_left_out: Vec<LeftOut>,
    /// Combinations of contact states that were tried one by one.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub combinations: usize,
}

/// No equilibrium exists: the grasp gives way under this load.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct NoEquilibrium<const C: usize> {
    /// Why, and how that is known.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub proof: Proof<C>,
}

/// Why no equilibrium exists, and how that is known.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "proof", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Proof<const C: usize> {
    /// No contact resists this unit motion in any state, and the load works on it.
    FreeMotion {
        /// The motion, the way the load drives it; lengths as for [`Equilibrium::free_motions`].
        motion: Motion<C>,
        /// Work of the load on it, `W·q` > 0, J.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        work: f64,
    },
    /// The load lies outside the friction wrench cone: no admissible contact force works against this unit motion, and
    /// the load drives it. Holds for any stiffness and any command.
    SeparatingMotion {
        /// The motion, the way the load drives it; lengths as for [`Equilibrium::free_motions`].
        motion: Motion<C>,
        /// Work of the load on it, `W·q` > 0, J.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        work: f64,
    },
    /// Every combination of contact states was tried; each violates a condition clearly. In the plane and on polygons.
    EveryStateTried {
        /// How many combinations.
        combinations: usize,
    },
    /// On the round cone: what contacts do was divided into cases, open or closed, sticking or sliding, friction between two angles.
    /// In each case all that the contact laws allow, and more, is contradicted by a linear combination of the conditions. Beyond an onset or
    /// the end of a path, in the plane too, a single case may do: nothing responds to a motion when everything on an edge slides.
    EveryCaseContradicted {
        /// How many cases.
        cases: usize,
        /// By this factor at least an equilibrium that rounding has hidden would have to exceed the data, in √J: stretches and
        /// forces of all contacts together over those of the elastic trial state. At least 1e4.
        escape: f64,
    },
}

/// Nothing was found and nothing was ruled out.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Undecided {
    /// Why.
    pub doubt: Doubt,
    /// What was tried; it is not written.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub work: WorkDone,
}
