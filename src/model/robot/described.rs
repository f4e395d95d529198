//! Links and joints of a robot, as read from the URDF file.

use std::fs;
use std::path::{Path, PathBuf};

use nalgebra::{Isometry3, Translation3, UnitQuaternion, UnitVector3, Vector3};
use urdf_rs::{JointType, Pose};

use super::shapes::Shape;

use crate::error::Error;
use crate::grasp::{JointKind, Limit};

/// A robot from a URDF, in a posture: links, joints, collision shapes, and the pose of the root links.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Robot {
    pub(super) links: Vec<String>,
    /// Joints, from the roots of the trees outwards.
    pub(super) joints: Vec<RobotJoint>,
    /// For each link the index of the joint that carries it; `None` for a root.
    pub(super) carried_by: Vec<Option<usize>>,
    /// Pose of the root links in the frame of the object.
    pub(super) base: Isometry3<f64>,
    /// Collision shapes of each link.
    pub(super) shapes: Vec<Vec<Shape>>,
    /// Folder of the description file, in which mesh files are searched.
    pub(super) folder: PathBuf,
}

/// A joint of a [`Robot`]. Positions are in rad, or in m for a prismatic joint.
#[derive(Debug, Clone, PartialEq)]
pub struct RobotJoint {
    pub(super) name: String,
    pub(super) parent: usize,
    /// Pose of the joint's frame in the frame of its parent link.
    pub(super) origin: Isometry3<f64>,
    pub(super) axis: UnitVector3<f64>,
    /// Kind of the joint's motion; `None` for a fixed joint.
    pub(super) kind: Option<JointKind>,
    pub(super) range: [f64; 2],
    pub(super) effort: f64,
    pub(super) mimics: Option<Mimics>,
    pub(super) position: f64,
    pub(super) commanded: Option<f64>,
    pub(super) stiffness: f64,
    pub(super) limit: Option<Limit>,
}

/// How a joint follows another joint: its position is `factor · position + offset`, with the position of the joint with the index `joint`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Mimics {
    pub(super) joint: usize,
    pub(super) factor: f64,
    pub(super) offset: f64,
}

impl RobotJoint {
    /// The joint's name in the file.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Lower and upper limit of the position in the file, rad or m; both 0 if the file gives none, and for continuous joints.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// Position, rad or m. It is not used for a joint that mimics another.
    #[must_use]
    pub fn position(&self) -> f64 {
        self.position
    }

    /// Largest torque or force of the motor in the file, N m or N; 0 if the file gives none.
    #[must_use]
    pub fn effort(&self) -> f64 {
        self.effort
    }
}

pub(super) fn fault(fault: String) -> Error {
    Error::Robot { fault }
}

impl Robot {
    /// A robot from a URDF file, with all joints at zero.
    ///
    /// # Errors
    /// [`Error::Robot`] if the file cannot be read or is not a URDF, or if its joints form a loop. The same error for a joint that is not revolute,
    /// continuous, prismatic or fixed.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, Error> {
        let path = path.as_ref();
        let named = |inner: String| fault(format!("{}: {inner}", path.display()));
        let text = fs::read_to_string(path).map_err(|error| named(error.to_string()))?;
        let robot = Self::from_urdf(&text).map_err(|error| match error {
            Error::Robot { fault } => named(fault),
            other => other,
        })?;
        Ok(Self { folder: path.parent().unwrap_or(Path::new("")).to_owned(), ..robot })
    }

    /// A robot from the text of a URDF, with all joints at zero.
    ///
    /// # Errors
    /// [`Error::Robot`] if the text is not a URDF, if its joints form a loop, or for a joint that is not revolute, continuous, prismatic or
    /// fixed.
    pub fn from_urdf(text: &str) -> Result<Self, Error> {
        let read = urdf_rs::read_from_string(text).map_err(|error| fault(error.to_string()))?;
        if read.links.is_empty() {
            return Err(fault("has no links, must be a URDF".to_owned()));
        }
        let links: Vec<String> = read.links.iter().map(|link| link.name.clone()).collect();
        let mut robot = Self {
            carried_by: vec![None; links.len()],
            links,
            joints: Vec::new(),
            base: Isometry3::identity(),
            shapes: read.links.iter().map(shapes_of).collect(),
            folder: PathBuf::new(),
        };
        let mut is_placed: Vec<bool> = robot
            .links
            .iter()
            .map(|link| read.joints.iter().all(|joint| joint.child.link != *link))
            .collect();
        // Joints are added from the root links outwards, each after the joint that carries its parent link.
        let mut left: Vec<&urdf_rs::Joint> = read.joints.iter().collect();
        while !left.is_empty() {
            let before = left.len();
            for joint in std::mem::take(&mut left) {
                let (parent, child) = (robot.link(&joint.parent.link)?, robot.link(&joint.child.link)?);
                if !is_placed[parent] {
                    left.push(joint);
                } else if robot.carried_by[child].is_some() {
                    return Err(fault(format!(
                        "link {}: two joints carry it, must be one",
                        joint.child.link
                    )));
                } else {
                    (robot.carried_by[child], is_placed[child]) = (Some(robot.joints.len()), true);
                    robot.joints.push(described(joint, parent)?);
                }
            }
            if left.len() == before {
                return Err(fault(format!("joint {}: is in a loop, joints must form a tree", left[0].name)));
            }
        }
        for joint in &read.joints {
            let Some(mimic) = &joint.mimic else { continue };
            let (index, followed) = (robot.index(&joint.name)?, robot.index(&mimic.joint)?);
            let (factor, offset) = (mimic.multiplier.unwrap_or(1.0), mimic.offset.unwrap_or(0.0));
            robot.joints[index].mimics = Some(Mimics { joint: followed, factor, offset });
        }
        for joint in &robot.joints {
            let followed = joint.mimics.map(|mimics| &robot.joints[mimics.joint]);
            if let Some(other) = followed.filter(|other| other.mimics.is_some() || other.kind.is_none()) {
                let allowed = "must be a joint that moves by itself";
                return Err(fault(format!("joint {}: mimics {}, {allowed}", joint.name, other.name)));
            }
        }
        Ok(robot)
    }

    /// The index of the link with this name.
    pub(crate) fn link(&self, name: &str) -> Result<usize, Error> {
        let found = self.links.iter().position(|link| link == name);
        found.ok_or_else(|| fault(format!("link {name}: is not there, there are {}", self.links.join(", "))))
    }

    /// The index of the joint with this name.
    pub(super) fn index(&self, name: &str) -> Result<usize, Error> {
        let found = self.joints.iter().position(|joint| joint.name == name);
        let names = || self.joints.iter().map(|joint| &*joint.name).collect::<Vec<_>>().join(", ");
        found.ok_or_else(|| fault(format!("joint {name}: is not there, there are {}", names())))
    }

    /// Names of all links, in file order.
    #[must_use]
    pub fn links(&self) -> &[String] {
        &self.links
    }

    /// All joints, from the roots of the trees outwards.
    #[must_use]
    pub fn joints(&self) -> &[RobotJoint] {
        &self.joints
    }
}

fn shapes_of(link: &urdf_rs::Link) -> Vec<Shape> {
    link.collision.iter().map(|each| Shape::new(&each.origin, &each.geometry)).collect()
}

pub(super) fn pose_in(pose: &Pose) -> Isometry3<f64> {
    let [roll, pitch, yaw] = *pose.rpy;
    let turned = UnitQuaternion::from_euler_angles(roll, pitch, yaw);
    Isometry3::from_parts(Translation3::from(*pose.xyz), turned)
}

fn described(joint: &urdf_rs::Joint, parent: usize) -> Result<RobotJoint, Error> {
    let kind = match joint.joint_type {
        JointType::Fixed => None,
        JointType::Revolute | JointType::Continuous => Some(JointKind::Turns),
        JointType::Prismatic => Some(JointKind::Slides),
        ref other => {
            let allowed = "must be revolute, continuous, prismatic or fixed";
            return Err(fault(format!("joint {}: is {other:?}, {allowed}", joint.name)));
        }
    };
    let axis = UnitVector3::try_new(Vector3::from(*joint.axis.xyz), 0.0)
        .ok_or_else(|| fault(format!("joint {}: axis has no direction", joint.name)))?;
    Ok(RobotJoint {
        name: joint.name.clone(),
        parent,
        origin: pose_in(&joint.origin),
        axis,
        kind,
        range: match joint.joint_type {
            JointType::Continuous => [0.0; 2],
            _ => [joint.limit.lower, joint.limit.upper],
        },
        effort: joint.limit.effort,
        mimics: None,
        position: 0.0,
        commanded: None,
        stiffness: 0.0,
        limit: None,
    })
}
