//! Motions of an object and of the joints of a hand: `{"translation": …, "rotation": …, "joints": […]}`.

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::grasp::{BodyMotion, Motion, Twist};
use crate::serial::AsComputed;

/// As it is written.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct WrittenMotion<const C: usize> {
    /// Of the object: translation of the origin (m) and rotation (rad).
    #[serde(flatten)]
    object: Twist<C>,
    /// Of the joints of a hand, finger by finger, rad or m; left out without a hand.
    #[serde(default, with = "AsComputed::<Vec<f64>>", skip_serializing_if = "Vec::is_empty")]
    joints: Vec<f64>,
    /// Of several bodies, each; left out where there is one.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    bodies: Vec<BodyMotion<C>>,
}

/// The motion of the object, and `"joints": […]` with a hand (feature `serde`), see [`crate::scene`].
impl<const C: usize> Serialize for Motion<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let bodies = self.bodies.clone();
        WrittenMotion { object: self.object, joints: self.joints.clone(), bodies }.serialize(serializer)
    }
}

/// The motion of the object, and `"joints": […]` with a hand (feature `serde`), see [`crate::scene`].
impl<'de, const C: usize> Deserialize<'de> for Motion<C> {
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        let WrittenMotion { object, joints, bodies } = WrittenMotion::deserialize(deserializer)?;
        Ok(Self { object, joints, bodies })
    }
}

#[cfg(feature = "schema")]
schema_as_written!("Motion", Motion<C>, WrittenMotion<C>, C);
