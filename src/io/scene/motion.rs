//! Motions of an object and of the joints of a hand: `{"translation": …, "rotation": …, "joints": […]}`.

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::grasp::{BodyMotion, Motion, Twist};
use crate::serial::AsComputed;

/// A motion in its written form.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct WrittenMotion<const C: usize> {
    /// The motion of the object: translation of the origin (m) and rotation (rad).
    #[serde(flatten)]
    object: Twist<C>,
    /// The displacements of a hand's joints, finger by finger, rad or m; left out without a hand.
    #[serde(default, with = "AsComputed::<Vec<f64>>", skip_serializing_if = "Vec::is_empty")]
    joints: Vec<f64>,
    /// The motion of each of several bodies; left out if there is one object.
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
crate::serial::schema_as_written!("Motion", Motion<C>, WrittenMotion<C>, C);
