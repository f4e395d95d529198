//! Motions of an object, and of the joints of the hand that holds it.

use super::wrench::Twist;

/// A motion that an answer speaks of: of the object, and of the joints of the hand that holds it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Motion<const C: usize> {
    /// Of the object: translation of the origin (m) and rotation (rad).
    pub object: Twist<C>,
    /// Of the joints, finger by finger, rad or m; empty without a hand.
    pub joints: Vec<f64>,
}
