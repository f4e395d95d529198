//! Motions of an object, and of the joints of the hand that holds it.

use super::bodies::BodyMotion;
use super::wrench::Twist;
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// A motion in an answer: of the object, of the joints of its hand, and of other bodies.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Motion<const C: usize> {
    /// Motion of the object: translation of the origin (m) and rotation (rad).
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub object: Twist<C>,
    /// Displacements of the joints, finger by finger, rad or m; empty without a hand.
    #[cfg_attr(
        feature = "serde",
        serde(default, with = "AsComputed::<Vec<f64>>", skip_serializing_if = "Vec::is_empty")
    )]
    pub joints: Vec<f64>,
    /// Motion of each of [several bodies](super::Bodies); empty for a single object.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub bodies: Vec<BodyMotion<C>>,
}

#[cfg(feature = "plot")]
impl<const C: usize> Motion<C> {
    /// Twist of the body with this index, or of the object if the grasp has no further bodies.
    pub(crate) fn of_body(&self, body: usize) -> &Twist<C> {
        self.bodies.get(body).map_or(&self.object, |motion| &motion.twist)
    }
}
