//! Proofs that no equilibrium exists.

use crate::grasp::Motion;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// No equilibrium exists: the grasp gives way under this load.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct NoEquilibrium<const C: usize> {
    /// Proof that no equilibrium exists.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub proof: Proof<C>,
}

/// Proof that no equilibrium exists.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "proof", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Proof<const C: usize> {
    /// No contact resists this unit motion in any contact state, and the load does work along it.
    FreeMotion {
        /// The unit motion, signed so that the load does positive work along it; its norm is one. The norm combines the translation of the centroid
        /// of the contacts, and the rotation times the root mean square distance of the contacts from this centroid.
        /// [`Equilibrium::free_motions`](super::Equilibrium::free_motions) have the same norm.
        motion: Motion<C>,
        /// Work of the load W along the unit motion q, `W·q` > 0, J.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        work: f64,
    },
    /// The load lies outside the friction wrench cone. Along this unit motion no admissible contact force does negative work, and the load does
    /// positive work. The proof holds for any stiffness and any command.
    SeparatingMotion {
        /// The unit motion, signed so that the load does positive work along it; its norm is one. The norm combines the translation of the centroid
        /// of the contacts, and the rotation times the root mean square distance of the contacts from this centroid.
        /// [`Equilibrium::free_motions`](super::Equilibrium::free_motions) have the same norm.
        motion: Motion<C>,
        /// Work of the load W along the unit motion q, `W·q` > 0, J.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        work: f64,
    },
    /// Every combination of contact states was tried, and each violates a condition by more than rounding. This proof exists only in the plane, and
    /// in space with polygonal friction cones.
    EveryStateTried {
        /// Number of combinations of contact states.
        combinations: usize,
    },
    /// On the round cone: contact states were divided into cases, open or closed, sticking or sliding, friction between two angles. In each case a
    /// linear combination of the conditions contradicts the contact laws, even when these laws are relaxed to convex sets. Just beyond the first slip
    /// or the end of a load path a single case may be enough, in the plane too. All contacts on the boundary of their cones then slide, and nothing
    /// resists a motion.
    EveryCaseContradicted {
        /// Number of cases into which the contact states were divided.
        cases: usize,
        /// The safety factor of the proof against rounding, at least 1e4. The elastic trial is the solution in which every contact sticks. Because of
        /// rounding the proof does not exclude equilibria whose stretches and forces exceed those of the elastic trial by at least this factor. Their
        /// norm in energy units, √J, is compared.
        escape: f64,
    },
}
