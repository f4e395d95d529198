//! Joints and tendons as they are written.

use nalgebra::SVector;
use serde::de::{Deserialize, Deserializer};
use serde::ser::{Serialize, Serializer};

use super::fields::given;
use super::object;
use crate::grasp::{Joint, JointMotion, Limit, Tendon};

#[derive(serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenJoint<const C: usize> {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    name: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    revolute: Option<Hinge<C>>,
    #[serde(default, with = "given", skip_serializing_if = "Option::is_none")]
    prismatic: Option<SVector<f64, C>>,
    #[serde(default, with = "given", skip_serializing_if = "is_absent")]
    stiffness: f64,
    #[serde(default, with = "given", skip_serializing_if = "is_absent")]
    command: f64,
    #[serde(default, with = "given", skip_serializing_if = "is_absent")]
    torque: f64,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    limit: Option<Limit>,
}

/// Where a revolute joint turns.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Hinge<const C: usize> {
    #[serde(with = "given")]
    point: SVector<f64, C>,
    #[serde(default, with = "given", skip_serializing_if = "Option::is_none")]
    axis: Option<SVector<f64, C>>,
}

#[derive(serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenTendon {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    name: Option<String>,
    #[serde(with = "given")]
    arms: Vec<f64>,
    #[serde(default, with = "given", skip_serializing_if = "is_absent")]
    stiffness: f64,
    #[serde(default, with = "given", skip_serializing_if = "is_absent")]
    pull: f64,
    #[serde(default, with = "given", skip_serializing_if = "is_absent")]
    tension: f64,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    limit: Option<Limit>,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pushes: bool,
}

/// Positive zero; a negative one is said.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes fields by reference")]
fn is_absent(x: &f64) -> bool {
    x.to_bits() == 0
}

impl<const C: usize> Serialize for Joint<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (revolute, prismatic) = match &self.motion {
            JointMotion::Revolute { point, axis } => {
                (Some(Hinge { point: *point, axis: (C == 3).then_some(*axis) }), None)
            }
            JointMotion::Prismatic { direction } => (None, Some(*direction)),
            JointMotion::Given => (None, None),
        };
        let Self { name, stiffness, command, torque, limit, .. } = self.clone();
        WrittenJoint { name, revolute, prismatic, stiffness, command, torque, limit }.serialize(serializer)
    }
}

impl<'de, const C: usize> Deserialize<'de> for Joint<C> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        object::read(deserializer, "a joint", |written: WrittenJoint<C>| {
            let motion = match (written.revolute, written.prismatic) {
                (None, None) => JointMotion::Given,
                (None, Some(direction)) => JointMotion::Prismatic { direction },
                (Some(Hinge { point, axis }), None) => match (C, axis) {
                    (3, Some(axis)) => JointMotion::Revolute { point, axis },
                    (3, None) => return Err("missing field `axis` of a revolute joint in space".to_owned()),
                    (_, None) => JointMotion::Revolute { point, axis: SVector::zeros() },
                    (_, Some(_)) => {
                        return Err("axis: a revolute joint of the plane has a point alone".to_owned());
                    }
                },
                (Some(_), Some(_)) => return Err("revolute and prismatic: a joint is one of them".to_owned()),
            };
            let WrittenJoint { name, stiffness, command, torque, limit, .. } = written;
            Ok(Self { name, motion, stiffness, command, torque, limit })
        })
    }
}

impl Serialize for Tendon {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { name, arms, stiffness, pull, tension, limit, pushes } = self.clone();
        WrittenTendon { name, arms, stiffness, pull, tension, limit, pushes }.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Tendon {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        object::read(deserializer, "a tendon", |written: WrittenTendon| {
            let WrittenTendon { name, arms, stiffness, pull, tension, limit, pushes } = written;
            Ok(Self { name, arms, stiffness, pull, tension, limit, pushes })
        })
    }
}
