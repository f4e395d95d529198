//! Motions of an object, and of the joints of the hand that holds it.

use super::bodies::BodyMotion;
use super::wrench::Twist;
use crate::prelude::*;

/// A motion that an answer speaks of: of the object, and of the joints of the hand that holds it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Motion<const C: usize> {
    /// Of the object: translation of the origin (m) and rotation (rad).
    pub object: Twist<C>,
    /// Of the joints, finger by finger, rad or m; empty without a hand.
    pub joints: Vec<f64>,
    /// Of [several bodies](super::Bodies), each; empty where there is one.
    pub bodies: Vec<BodyMotion<C>>,
}

#[cfg(feature = "plot")]
impl<const C: usize> Motion<C> {
    /// Of one of several bodies, or of the object where there is one.
    pub(crate) fn of_body(&self, body: usize) -> &Twist<C> {
        self.bodies.get(body).map_or(&self.object, |motion| &motion.twist)
    }
}
