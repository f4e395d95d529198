//! Joints in the text of a scene. The drive of a joint is the spring that pulls the joint to its commanded position, with a force limit.

use crate::numerics::by_axis;
use std::sync::Arc;

use nalgebra::SVector;
use serde::de::{Deserialize, Deserializer};
use serde::ser::{Serialize, Serializer};

use crate::grasp::{Joint, JointMotion, Limit, Space};
use crate::serial::{AsGiven, AxisRow, Given, is_absent, object, space_of_text};

#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
struct WrittenJoint<const C: usize> {
    /// The name of the joint in answers.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    name: Option<Arc<str>>,
    /// The axis of a revolute joint.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    revolute: Option<Hinge<C>>,
    /// The direction of a prismatic joint.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    prismatic: Option<AxisRow<Given, C>>,
    /// Stiffness of the drive, N m/rad or N/m; without a stiffness only `torque` acts.
    #[serde(default, with = "AsGiven::<f64>", skip_serializing_if = "is_absent")]
    stiffness: f64,
    /// Commanded position of the drive, rad or m; 0 if left out.
    #[serde(default, with = "AsGiven::<f64>", skip_serializing_if = "is_absent")]
    command: f64,
    /// Constant torque or force in addition to the drive, at any position of the joint, N m or N; 0 if left out.
    #[serde(default, with = "AsGiven::<f64>", skip_serializing_if = "is_absent")]
    torque: f64,
    /// The largest torque or force of the drive, N m or N; no limit if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    limit: Option<Limit>,
}

/// The axis of a revolute joint.
#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "JointAxis"))]
#[serde(deny_unknown_fields)]
struct Hinge<const C: usize> {
    /// A point on the axis, m.
    #[serde(with = "AsGiven::<SVector<f64, C>>")]
    point: SVector<f64, C>,
    /// The direction of the axis, right-handed; in space only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    axis: Option<AxisRow<Given, C>>,
}

impl<const C: usize> Serialize for Joint<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let is_spatial = space_of_text::<C>() == Space::Spatial;
        let (revolute, prismatic) = match &self.motion {
            JointMotion::Revolute { point, axis } => {
                (Some(Hinge { point: *point, axis: is_spatial.then(|| AxisRow::new(*axis)) }), None)
            }
            JointMotion::Prismatic { direction } => (None, Some(AxisRow::new(*direction))),
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
                (None, Some(direction)) => JointMotion::Prismatic { direction: direction.0 },
                (Some(Hinge { point, axis }), None) => match (space_of_text::<C>().axes(), axis) {
                    (3, Some(axis)) => JointMotion::Revolute { point, axis: axis.0 },
                    (3, None) => return Err("missing field `axis` of a revolute joint in space".to_owned()),
                    // A joint of the plane turns about z.
                    (_, None) => {
                        JointMotion::Revolute { point, axis: by_axis(|a| f64::from(u8::from(a == 2))) }
                    }
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

#[cfg(feature = "schema")]
crate::serial::schema_as_written!("Joint", Joint<C>, WrittenJoint<C>, C);
