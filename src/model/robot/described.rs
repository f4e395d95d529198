//! Links and joints of a robot, as read from the URDF file.

use std::fs;
use std::path::{Path, PathBuf};

use nalgebra::{Isometry3, UnitVector3};
use roxmltree::{Document, Node, ParsingOptions};

use super::shapes::Shape;
use super::urdf::{child, children, number, numbers, place, version, word};
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
        let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
        let file = Document::parse_with_options(text.trim_start(), options);
        let file = file.map_err(|error| fault(error.to_string()))?;
        let [links, joints] = ["link", "joint"].map(|kind| children(file.root_element(), kind));
        if links.is_empty() {
            return Err(fault("has no links, must be a URDF".to_owned()));
        }
        let shapes_of = |link: &Node| children(*link, "collision").into_iter().map(Shape::read).collect();
        let mut robot = Self {
            carried_by: vec![None; links.len()],
            links: links
                .iter()
                .map(|link| Ok(word(*link, "name")?.to_owned()))
                .collect::<Result<_, Error>>()?,
            joints: Vec::new(),
            base: Isometry3::identity(),
            shapes: links.iter().map(shapes_of).collect::<Result<_, Error>>()?,
            folder: PathBuf::new(),
        };
        let mut left = Vec::with_capacity(joints.len());
        for joint in joints {
            let link = |end| robot.link(word(child(joint, end).unwrap_or(joint), "link")?);
            left.push((joint, link("parent")?, link("child")?));
        }
        let mut mimicking = Vec::new();
        // Joints are added from the root links outwards, each after the joint that carries its parent link.
        let mut is_placed: Vec<bool> =
            (0..links.len()).map(|link| left.iter().all(|(_, _, child)| *child != link)).collect();
        while !left.is_empty() {
            let before = left.len();
            for (joint, parent, moved) in std::mem::take(&mut left) {
                if !is_placed[parent] {
                    left.push((joint, parent, moved));
                } else if robot.carried_by[moved].is_some() {
                    let name = &robot.links[moved];
                    return Err(fault(format!("link {name}: two joints carry it, must be one")));
                } else {
                    (robot.carried_by[moved], is_placed[moved]) = (Some(robot.joints.len()), true);
                    mimicking.extend(child(joint, "mimic").map(|mimic| (robot.joints.len(), mimic)));
                    robot.joints.push(described(joint, parent)?);
                }
            }
            if left.len() == before {
                let name = word(left[0].0, "name")?;
                return Err(fault(format!("joint {name}: is in a loop, joints must form a tree")));
            }
        }
        for (index, mimic) in mimicking {
            let [factor, offset] =
                [number(Some(mimic), "multiplier", 1.0)?, number(Some(mimic), "offset", 0.0)?];
            let joint = robot.index(word(mimic, "joint")?)?;
            robot.joints[index].mimics = Some(Mimics { joint, factor, offset });
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

fn described(joint: Node, parent: usize) -> Result<RobotJoint, Error> {
    let name = word(joint, "name")?.to_owned();
    let of = word(joint, "type")?;
    let kind = match of {
        "fixed" => None,
        "revolute" | "continuous" => Some(JointKind::Turns),
        "prismatic" => Some(JointKind::Slides),
        _ => {
            let allowed = "must be revolute, continuous, prismatic or fixed";
            return Err(fault(format!("joint {name}: is {of}, {allowed}")));
        }
    };
    let axis = child(joint, "axis").map_or(Ok(None), |axis| numbers(axis, "xyz"))?;
    let axis = UnitVector3::try_new(axis.unwrap_or([1.0, 0.0, 0.0]).into(), 0.0)
        .ok_or_else(|| fault(format!("joint {name}: axis has no direction")))?;
    let limit = child(joint, "limit");
    // From version 1.2 on a number that is left out of the limits is no limit.
    let is_newer = limit.is_some() && version(joint) >= [1, 2];
    let left_out = if is_newer { f64::INFINITY } else { 0.0 };
    let range = [number(limit, "lower", 0.0 - left_out)?, number(limit, "upper", left_out)?];
    let effort = number(limit, "effort", left_out)?;
    if is_newer && !(range[0] <= range[1] && effort >= 0.0) {
        return Err(fault(format!("joint {name}: limits must be lower ≤ upper and effort ≥ 0")));
    }
    Ok(RobotJoint {
        name,
        parent,
        origin: place(joint)?,
        axis,
        kind,
        range: if of == "continuous" { [0.0; 2] } else { range },
        effort,
        mimics: None,
        position: 0.0,
        commanded: None,
        stiffness: 0.0,
        limit: None,
    })
}
