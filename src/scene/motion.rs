//! Motions of an object and of the joints of a hand: `{"translation": …, "rotation": …, "joints": […]}`.

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::grasp::{Motion, Twist};
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
}

/// The motion of the object, and `"joints": […]` with a hand (feature `serde`), see [`crate::scene`].
impl<const C: usize> Serialize for Motion<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        WrittenMotion { object: self.object, joints: self.joints.clone() }.serialize(serializer)
    }
}

/// The motion of the object, and `"joints": […]` with a hand (feature `serde`), see [`crate::scene`].
impl<'de, const C: usize> Deserialize<'de> for Motion<C> {
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        let WrittenMotion { object, joints } = WrittenMotion::deserialize(deserializer)?;
        Ok(Self { object, joints })
    }
}

#[cfg(feature = "schema")]
schema_as_written!("Motion", Motion<C>, WrittenMotion<C>, C);
