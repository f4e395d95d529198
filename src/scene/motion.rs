//! Motions of an object, and of the joints of the hand that holds it.

use serde::{Deserialize, Serialize};

use super::fields::AsFound;
use crate::grasp::Twist;

/// A motion that an answer speaks of.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Motion<const D: usize, const C: usize> {
    /// Of the object: translation of the origin (m) and rotation (rad).
    #[serde(flatten)]
    pub object: Twist<D, C>,
    /// Of the joints of a hand, finger by finger, rad or m; left out without a hand.
    #[serde(default, with = "AsFound::<Vec<f64>>", skip_serializing_if = "Vec::is_empty")]
    pub joints: Vec<f64>,
}
