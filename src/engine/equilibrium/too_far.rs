//! Motions that are no longer small: a body or a joint turns too far, or a contact slips or opens too far.
//!
//! Contact points and normals are those of the undeformed grasp. Beyond [`SmallMotions`] an equilibrium therefore satisfies all equations, but says
//! little about the real object. This file alone measures motions against the limits, for answers and along load paths. Finger offsets are commanded
//! displacements minus clearances and slips.

use core::{fmt, slice};

use nalgebra::SVector;

use crate::contact::State;
use crate::grasp::{Engine, HandPart, JointKind, PartLabel, WholeContact};
use crate::numerics::tolerances::{NEGLIGIBLE, SOLVED_ROUNDING};
use crate::numerics::{Vector, any_index, highest, largest};
use crate::object::Problem;
use crate::prelude::*;
use crate::search::{SearchSolution, SmallMotions};
#[cfg(feature = "serde")]
use crate::serial::AsComputed;
use crate::words::{Words, listed, printable};

/// The reason why a theory of small motions says little: a motion beyond [`SmallMotions`], a leak of a suction cup, or buckling.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "motion", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum TooFar {
    /// A body turns too far.
    Turns {
        /// The name of the body; `None` if there is only one object.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        body: Option<String>,
        /// The largest rotation that is still taken as small, rad.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        limit: f64,
    },
    /// A revolute joint turns too far, and moves a contact that is closed.
    JointTurns {
        /// The joint that turns.
        joint: PartLabel,
        /// The largest rotation that is still taken as small, rad.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        limit: f64,
    },
    /// The surfaces of a closed contact have moved past each other too far.
    Slips {
        /// The contact that slips.
        contact: WholeContact,
        /// The largest displacement that is still taken as small, m.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        limit: f64,
    },
    /// The object has moved too far away from a finger.
    Opens {
        /// The contact that opens.
        contact: WholeContact,
        /// The largest displacement that is still taken as small, m.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        limit: f64,
    },
    /// The lip of a suction cup opens at some of its points, where air flows in. The answer assumes that the vacuum lasts.
    Leaks {
        /// The cup, with the number of its points that are open.
        cup: WholeContact,
    },
    /// The grasp buckles: forces turn with the parts on which they act, and in some motion this lowers the stiffness by more than the springs
    /// provide. The grasp also buckles if it snaps through, as a toggle does before its dead centre: with finite rotations of its parts, no equilibrium
    /// leads from no load to this load.
    Buckles,
    /// The object turns over: every contact holds, but no spring resists a rotation along which forces drive the object on. Only loads whose points of
    /// action are known are checked; see [`Wrench`](crate::planar::Wrench::force_at).
    TurnsOver,
}

/// The sentence for a suction cup whose lip is open at some of its points.
pub(crate) const AIR_FLOWS_IN: &str = "air flows in where the lip opens";

/// The sentence for a grasp that buckles.
const TAKES_ALL: &str = "as the forces turn with the parts they act on, they take all that resists";

/// The sentence for an object that turns over.
const DRIVEN_ON: &str = "every contact holds, but nothing resists a rotation, and the load drives it on unless round surfaces roll there";

/// Writes the body or contact and its motion, for example "it turns by more than 5.7°", "left slips by more than 4 mm".
impl fmt::Display for TooFar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = match self {
            Self::Turns { body, .. } => body.as_ref().map_or("it".into(), |body| printable(body)),
            Self::JointTurns { joint, .. } => joint.text().into(),
            Self::Slips { contact, .. } | Self::Opens { contact, .. } | Self::Leaks { cup: contact } => {
                contact.text()
            }
            Self::Buckles | Self::TurnsOver => "it".into(),
        };
        write!(f, "{name} {}", self.verb_phrase(Words::of(f)))
    }
}

impl TooFar {
    /// Whether this is a motion beyond its limit. False for buckling, turning over and the leak of a suction cup: with each the grasp fails even if all
    /// motions are small.
    #[must_use]
    pub fn is_motion(&self) -> bool {
        !self.is_unstable() && !matches!(self, Self::Leaks { .. })
    }

    /// Whether the equilibrium is not stable: the grasp buckles, or the object turns over.
    pub(crate) fn is_unstable(&self) -> bool {
        self.why_unstable().is_some()
    }

    fn why_unstable(&self) -> Option<&'static str> {
        match self {
            Self::Buckles => Some(TAKES_ALL),
            Self::TurnsOver => Some(DRIVEN_ON),
            _ => None,
        }
    }

    /// The text that follows a [verb](crate::hold::LossVerb) such as "BUCKLES: " and explains it. For buckling and turning over it says why the
    /// equilibrium is not stable. Otherwise the text of [`Self::caution`].
    #[must_use]
    pub fn reason(&self, words: Words) -> String {
        self.why_unstable().map_or_else(|| self.caution(words), ToOwned::to_owned)
    }

    /// The caution for answers beyond small motions: "left slips by more than 4 mm: results for small motions no longer apply".
    #[must_use]
    pub fn caution(&self, words: Words) -> String {
        let digits = words.precision();
        if let Self::Leaks { cup } = self {
            return format!("{AIR_FLOWS_IN}, at {}", listed(slice::from_ref(cup)));
        }
        let why = self.why_unstable().unwrap_or("results for small motions no longer apply");
        format!("{self:.digits$}: {why}")
    }

    /// The motion beyond its limit, with a verb, without the name of the body or contact: "turns by more than 5.7°". Limits have two significant
    /// digits.
    #[must_use]
    pub fn verb_phrase(&self, words: Words) -> String {
        let words = words.rounded_to(2);
        match self {
            Self::Turns { limit, .. } | Self::JointTurns { limit, .. } => {
                format!("turns by more than {}", words.angle(*limit))
            }
            Self::Slips { limit, .. } => format!("slips by more than {}", words.length(*limit)),
            Self::Opens { limit, .. } => format!("opens by more than {}", words.length(*limit)),
            Self::Leaks { .. } => "leaks".to_owned(),
            Self::Buckles => "buckles".to_owned(),
            Self::TurnsOver => "turns over".to_owned(),
        }
    }
}

/// A motion whose length is compared with a limit of small motions: the rotation of a body or joint, or the slip or opening of a contact. In given
/// contact states its vector is affine in the motion of the object, the contact forces and the commands.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CountedMotion {
    /// The vector of the rotation (rad) or slip (m). For the rotation of a joint and for an opening (m), only the first component is used. An opening
    /// is positive if the surfaces have moved apart; a negative opening is never too large.
    pub(crate) shift: SVector<f64, 3>,
    /// Upper limit of the length of a small motion, rad or m.
    pub(crate) limit: f64,
    of: MotionOf,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum MotionOf {
    /// The rotation of a body, given by the index of its first coordinate.
    Body(usize),
    /// The rotation of a revolute joint, given by the index of the joint, from 0.
    Joint(usize),
    Slip(usize),
    Opening(usize),
}

impl CountedMotion {
    /// Whether the motion is an opening of a contact. Its component is compared with the limit with its sign, not by its magnitude.
    pub(crate) fn is_opening(&self) -> bool {
        matches!(self.of, MotionOf::Opening(_))
    }

    /// The length of the motion divided by its limit: above 1 the motion is not small. Negative for an opening if the object has moved towards the
    /// finger.
    pub(crate) fn over_the_limit(&self) -> f64 {
        if self.is_opening() { self.shift[0] / self.limit } else { self.shift.norm() / self.limit }
    }
}

/// The motion whose length is the largest multiple of its own limit, even if it is below the limit; `None` for an empty list.
pub(crate) fn farthest(motions: &[CountedMotion]) -> Option<&CountedMotion> {
    highest(motions, &CountedMotion::over_the_limit)
}

/// The data of an equilibrium from which its motions are measured: contact states, forces, finger offsets, slips and twist.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MotionData<'s> {
    pub(crate) offsets: &'s [SVector<f64, 3>],
    pub(crate) slips: &'s [SVector<f64, 3>],
    pub(crate) states: &'s [State],
    pub(crate) forces: &'s [SVector<f64, 3>],
    pub(crate) twist: &'s Vector,
}

impl<'s> MotionData<'s> {
    /// The data of the equilibrium `found` of a problem, with the problem's finger offsets and slips.
    pub(crate) fn found(problem: &'s Problem<'_>, found: &'s SearchSolution) -> Self {
        let (offsets, slips) = (&problem.offsets, &problem.slips);
        Self { offsets, slips, states: &found.states, forces: &found.forces, twist: &found.twist }
    }
}

impl Engine {
    /// The root mean square distance of contact points from their centroid, m; with several bodies the largest value of any body. Infinite if all
    /// points coincide.
    pub(crate) fn size_of_grasp(&self) -> f64 {
        let first = self.contacts()[0].point;
        let far = largest(self.contacts(), &|contact| contact.point.amax());
        // Contact points nearer to each other than the fraction `SOLVED_ROUNDING` of their coordinates count as one point, because the rounding error
        // of their centroid is as large.
        if self.contacts().iter().all(|contact| (contact.point - first).amax() <= SOLVED_ROUNDING * far) {
            return f64::INFINITY;
        }
        let places = self.bodies().map_or(&[][..], |bodies| &bodies.places);
        places.iter().map(|place| place.rms_radius).fold(self.length(), f64::max)
    }

    /// All motions that are compared with limits: the rotation of each body, of each revolute joint that moves a closed contact, and the slip or
    /// opening of each contact except cables and springs.
    pub(crate) fn counted_motions(
        &self,
        small: &SmallMotions,
        standing: &MotionData<'_>,
    ) -> Vec<CountedMotion> {
        let mut motions = Vec::with_capacity(self.len() + 1);
        let places = self.bodies().map_or(&[][..], |bodies| &bodies.places);
        let first_of_each = places.iter().map(|place| place.first);
        for first in first_of_each.chain(places.is_empty().then_some(0)) {
            let mut shift = SVector::zeros();
            let axes = self.space().axes();
            for k in first + axes..first + self.space().of_the_object() {
                let behind = self.linkage().filter(|_| first > 0);
                let length = behind.map_or(self.length(), |linkage| linkage.lengths[k]);
                shift[k - first - axes] = standing.twist[k] / length;
            }
            motions.push(CountedMotion { shift, limit: small.rotation, of: MotionOf::Body(first) });
        }
        self.push_joint_turns(small, standing, &mut motions);
        let limit = small.slip * self.size_of_grasp();
        for (i, site) in self.sites().iter().enumerate().take(self.len()) {
            // Cables and springs are left out: a slack cable is an open contact, but may hang loose by any length, and a spring between two points
            // does not slip where its ends move across it.
            if self.rope(i).is_some() {
                continue;
            }
            let moved = site.map.tr_mul(standing.twist);
            let (mut shift, mut of) = (SVector::zeros(), MotionOf::Slip(i));
            if standing.states[i].is_open() {
                // A gap that a retracting command or a clearance leaves before the object moves is no motion of the object and does not count.
                (shift[0], of) = (moved[0] - standing.offsets[i][0].max(0.0), MotionOf::Opening(i));
            } else {
                let mut slip = standing.slips[i];
                if !standing.states[i].is_sticking() || site.friction.is_frictionless() {
                    slip += site.springs.slip(&(standing.offsets[i] - moved), &standing.forces[i]);
                }
                (1..3).for_each(|axis| shift[axis - 1] = slip[axis]);
            }
            motions.push(CountedMotion { shift, limit, of });
        }
        motions
    }

    /// Appends the rotations of revolute joints that move a closed contact. The joints of an open finger turn without changing the grasp.
    fn push_joint_turns(
        &self,
        small: &SmallMotions,
        standing: &MotionData<'_>,
        motions: &mut Vec<CountedMotion>,
    ) {
        let Some(linkage) = self.linkage() else { return };
        let turns = |joint: &usize| linkage.joints[*joint].kind == JointKind::Turns;
        for joint in (0..linkage.joints.len()).filter(turns) {
            let k = self.space().of_the_object() + joint;
            let moves = |i: usize| {
                !standing.states[i].is_open() && linkage.motions[i].iter().any(|(moved, _)| *moved == joint)
            };
            if any_index(self.len(), &moves) {
                let mut shift = SVector::zeros();
                shift[0] = standing.twist[k] / linkage.lengths[k];
                motions.push(CountedMotion { shift, limit: small.rotation, of: MotionOf::Joint(joint) });
            }
        }
    }

    /// Describes a motion beyond its limit, with the name of its body, joint or contact, for an answer.
    pub(crate) fn too_far(&self, motion: &CountedMotion) -> TooFar {
        let limit = motion.limit;
        let contact = |site: usize| self.wholes().at(site).with(1);
        match motion.of {
            MotionOf::Body(first) => {
                let named = self.bodies().and_then(|bodies| {
                    bodies
                        .places
                        .iter()
                        .position(|place| place.first == first)
                        .map(|body| &bodies.names[body])
                });
                TooFar::Turns { body: named.map(ToString::to_string), limit }
            }
            MotionOf::Joint(joint) => {
                let joint = HandPart::Joint(joint);
                let label = self.linkage().map(|linkage| linkage.label(joint));
                TooFar::JointTurns { joint: label.unwrap_or(PartLabel { part: joint, name: None }), limit }
            }
            MotionOf::Slip(site) => TooFar::Slips { contact: contact(site), limit },
            MotionOf::Opening(site) => TooFar::Opens { contact: contact(site), limit },
        }
    }

    /// Whether no motion of an answer is beyond its limit by more than rounding. A load path ends where a motion is at its limit up to rounding.
    pub(super) fn is_within(&self, small: &SmallMotions, standing: &MotionData<'_>) -> bool {
        let motions = self.counted_motions(small, standing);
        farthest(&motions).is_none_or(|motion| motion.over_the_limit() <= 1.0 + NEGLIGIBLE)
    }

    /// The motion of an answer that is farthest beyond its limit; `None` if all motions are small.
    pub(super) fn farthest_beyond(&self, small: &SmallMotions, standing: &MotionData<'_>) -> Option<TooFar> {
        let motions = self.counted_motions(small, standing);
        farthest(&motions).filter(|motion| motion.over_the_limit() > 1.0).map(|motion| self.too_far(motion))
    }
}
