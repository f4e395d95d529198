//! The answer to `solve`, in physical quantities: an equilibrium of a grasp under a load, a proof that none exists, or undecided. A command is a
//! prescribed displacement of a finger. A drive is the spring of a joint or tendon of a hand, with its force limit; it is treated like a contact.

use crate::numerics::mapped;
use nalgebra::SVector;

use super::accuracy::Accuracy;
use super::cone::Cone;
use super::contact_answer::ContactAnswer;
use super::hand_answer::{JointAnswer, TendonAnswer};
use super::no_equilibrium::NoEquilibrium;
use super::pad_answer::PadAnswer;
use super::residuals::Residuals;
use super::too_far::TooFar;
use crate::contact::{Coulomb, State};
use crate::forms::OmittedPairs;
use crate::grasp::{BodyLoad, BodyMotion, Coordinates, Motion, Twist, WholeContact, Wrench};
use crate::prelude::*;
use crate::search::{Doubt, FoundBy};
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// The answer to the question whether a grasp has an equilibrium under a load.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "outcome", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Outcome<const C: usize> {
    /// An equilibrium exists, with the motion of the object and the contact forces.
    Equilibrium(Box<Equilibrium<C>>),
    /// No quasi-static equilibrium exists under this load, with the proof.
    NoEquilibrium(NoEquilibrium<C>),
    /// No equilibrium was found, and no proof that none exists.
    Undecided(Undecided),
}

impl<const C: usize> Outcome<C> {
    /// The equilibrium; `None` if no equilibrium was found.
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
/// An equilibrium that was read from a file, or returned as the answer to a scene, contains only the serialised fields. Further questions to a grasp
/// about such an equilibrium, such as [`Grasp::accuracy`](crate::ask::Grasp::accuracy), have no answer.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Equilibrium<const C: usize> {
    /// The load that the contact forces balance; its moment is about the origin.
    pub load: Wrench<C>,
    /// Motion of the object from its position before load and commands: translation of the origin (m) and rotation (rad). If `free_motions` remain,
    /// which no contact resists, the twist has the least norm that gaps and slips allow. On a load path it is instead the twist nearest to the
    /// preceding position of the object on the path. The norm is the root of a sum of squares. The first term is the displacement of the centroid of
    /// the contact points. The second is the rotation (rad) times the root mean square distance of these points from the centroid. Further terms are
    /// the displacements of the joints, each times its reference length. The reference length is a power of two near the largest motion of a contact
    /// per unit of the joint.
    pub twist: Twist<C>,
    /// The motion of each of [several bodies](crate::grasp::Bodies); `twist` is then the motion of the body on which loads act. Empty for one object.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub bodies: Vec<BodyMotion<C>>,
    /// Loads on single bodies that a [program](crate::load_path::Leg::body_load_by) has applied in addition to `load`, without the constant loads of
    /// bodies.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub body_loads: Vec<BodyLoad<C>>,
    /// The motion that is farthest beyond [small motions](crate::Settings::small_motions). The theory keeps contact points and normals fixed, so such
    /// an answer satisfies all conditions but says little about the object. For example, a wedge with a taper of only 1e-9 rad holds any load in the
    /// theory, since the object may move any distance. [`TooFar::Buckles`] if the grasp buckles under these forces; this is known only if the points
    /// of action of the load are known. [`TooFar::Leaks`] if a suction cup leaks. `None` if all motions are small and the grasp is not known to
    /// buckle.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub too_far: Option<TooFar>,
    /// The contacts, in the order of the grasp; each point of a soft fingertip is one contact.
    pub contacts: Vec<ContactAnswer<C>>,
    /// The soft fingertips, each with the resultant force and moment of its points.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub pads: Vec<PadAnswer<C>>,
    /// The joints of the [hand](crate::grasp::Hand) that holds the object, finger by finger; empty without a hand.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub joints: Vec<JointAnswer>,
    /// The tendons of the hand; empty without a hand.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub tendons: Vec<TendonAnswer>,
    /// Suction cups whose lips are open all around. A real cup then loses its vacuum, but this equilibrium still includes the pull of the vacuum. It
    /// is therefore not valid for the real grasp.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub open_cups: Vec<WholeContact>,
    /// The residuals of the conditions of equilibrium, such as balance of forces and contact laws, recomputed from grasp, commands and load.
    pub residuals: Residuals,
    /// Estimated errors of forces and displacements ([`Grasp::accuracy`](crate::ask::Grasp::accuracy)): only in the answer to the question `solve` of
    /// a scene, else `None`.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub accuracy: Option<Accuracy>,
    /// The friction cone for which the answer was computed.
    pub cone: Cone,
    /// The method that found this equilibrium. There may be other equilibria, which [`Grasp::equilibria`](crate::ask::Grasp::equilibria) lists.
    pub rule: FoundBy,
    /// Elastic energy of all springs, including those of joints and tendons, `Σ ½ F²/k`, J.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub stored_energy: f64,
    /// Unit motions that no contact resists in its present state, m and rad. Any multiple of them, of either sign, may be added to the twist, and the
    /// forces do not depend on it. Their norm is one; it is the norm by which `twist` is the least, with the displacement of each joint times its
    /// reference length. Empty if every motion is resisted.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub free_motions: Vec<Motion<C>>,
    /// Unit motions along which the object stays in equilibrium while its forces change: this equilibrium is a point of a whole line of equilibria.
    /// Their norm is one, as that of `free_motions`. Usually empty; not empty, for example, if friction just keeps a wedge from sliding.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub neutral_motions: Vec<Motion<C>>,
    /// On the round cone: the largest difference, N, between a contact force and its value on the polygonal cone with which the search started.
    /// `None` if no polygon was used: if no contact slides, or if Newton's method found the equilibrium. `None` also for an equilibrium on a load
    /// path, or if the answer itself refers to a polygonal cone.
    #[cfg_attr(
        feature = "serde",
        serde(default, with = "AsComputed::<Option<f64>>", skip_serializing_if = "Option::is_none")
    )]
    pub change_from_polygon: Option<f64>,
    /// The effort of the search for this equilibrium: numbers of pivots of Lemke's method, of complementary pairs, and of combinations of contact
    /// states. Only the number of pivots is serialised.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub work: WorkDone,
    /// The engine's own solution: contact states, drive forces, motions and offsets in its coordinates. Further questions about this equilibrium
    /// start from it.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(crate) local: LocalAnswer,
}

impl<const C: usize> Equilibrium<C> {
    /// Whether a body or joint turns, or a contact slips or opens, by more than [small motions](crate::Settings::small_motions) allow, or the grasp
    /// buckles. [`Self::too_far`] then has the motion that is farthest beyond its limit, or says that it buckles.
    #[must_use]
    pub fn is_beyond_small_motions(&self) -> bool {
        self.too_far.is_some()
    }

    /// The largest of the contact forces and the force of the load, N. A printed force is compared with it to see whether the force is noticeable or
    /// negligible.
    #[must_use]
    pub fn largest_force(&self) -> f64 {
        let load = self.load.components().iter().take(C).fold(0.0, |norm: f64, x| norm.hypot(*x));
        self.contacts.iter().map(|contact| contact.force.norm()).fold(load, f64::max)
    }

    /// This answer as it comes back from a file: without the engine's solution `local`, and with the number of pivots as its only `work`.
    #[cfg(feature = "serde")]
    pub(crate) fn written(self) -> Self {
        let work = WorkDone { pivots: self.work.pivots, ..WorkDone::default() };
        Self { work, local: LocalAnswer::default(), ..self }
    }

    /// True if the answer still has the engine's solution `local`, and that solution belongs to a grasp with `sites` contacts and drives in total. If
    /// it lacks `local`, calls that start from the answer, such as `accuracy`, return `None`.
    pub(crate) fn knows_all_of(&self, sites: usize) -> bool {
        self.local.states.len() == sites && self.contacts.len() + self.local.drive_forces.len() == sites
    }
}

impl Equilibrium<3> {
    /// Forces of all contacts, N, in their contact frames, followed by the forces of the drives of a hand.
    pub(crate) fn site_forces(&self) -> Vec<SVector<f64, 3>> {
        let mut all = mapped(&self.contacts, &|contact| contact.force);
        all.extend_from_slice(&self.local.drive_forces);
        all
    }
}

/// The engine's solution behind an equilibrium. Lists for contacts and drives name all contacts first, then the drives of a hand. Empty if the answer
/// was read from text.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct LocalAnswer {
    pub(crate) states: Vec<State>,
    /// Forces of the drives of a hand, in the form of contact forces; empty without a hand.
    pub(crate) drive_forces: Vec<SVector<f64, 3>>,
    /// The motion of the object in the engine's coordinates, about the centroid of the contacts.
    pub(crate) twist: Coordinates,
    pub(crate) free_motions: Vec<Coordinates>,
    /// Finger offsets, m, in the contact frames: commanded displacements minus clearance and minus `slips`.
    pub(crate) offsets: Vec<SVector<f64, 3>>,
    /// The slips accumulated along a load path, m; they were subtracted from `offsets`.
    pub(crate) slips: Vec<SVector<f64, 3>>,
    /// Present friction cones, narrower at contacts that slide with kinetic friction. An empty list means the static cones.
    pub(crate) cones: Vec<Coulomb>,
}

/// The effort of a search for an equilibrium: numbers of pivots of Lemke's method, of complementary pairs, and of combinations of contact states.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct WorkDone {
    /// Pivots of Lemke's method, all runs together.
    pub pivots: usize,
    /// Number of complementary pairs of the largest complementarity problem that the search made.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub rows_made: usize,
    /// Complementary pairs that the search left out of the kinematic form (the complementarity problem for gaps and slips), and why. A form without
    /// omissions has one pair for each gap and one for each facet of every contact.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub rows_left_out: Vec<OmittedPairs>,
    /// Combinations of contact states that were tried one by one.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub combinations: usize,
}

/// No equilibrium was found, and no proof that none exists.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Undecided {
    /// The reason why it is undecided whether an equilibrium exists.
    pub doubt: Doubt,
    /// The effort of the search: numbers of pivots of Lemke's method, of complementary pairs, and of combinations of contact states. Not serialised.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub work: WorkDone,
}
