//! A robot from its description file, and contacts on its links in place of fingers (feature `urdf`).

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use nalgebra::{Isometry3, Translation3, UnitQuaternion};

use super::finger::FingerSetup;
use super::fingertip::{Fingertip, MovedBy};
use super::setup::Setup;
use crate::error::Error;
use crate::grasp::Space;
use crate::robot::{Mover, Robot};
use crate::touch::Pad;

/// The robot that holds the object, `{"urdf": "hand.urdf", "joints": {"thumb_base": 20}, "stiffness": {"others": 3}, "effort": "from file"}`; see
/// [`Robot`]. Once the file is read, fingers with joints replace this field.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct RobotSetup<const C: usize> {
    /// The description file of the robot; a relative path counts from the folder of the scene.
    pub urdf: String,
    /// The position of the robot's root link, m; the origin if left out.
    #[serde(default)]
    pub at: [f64; 3],
    /// Roll, pitch and yaw of the robot's root link, degrees; 0 if left out.
    #[serde(default)]
    pub turned_deg: [f64; 3],
    /// Positions of the joints by name, degrees, or m for prismatic joints; 0 if left out.
    #[serde(default)]
    pub joints: BTreeMap<String, f64>,
    /// Commanded positions of the joints by name, degrees or m; the positions in `joints` if left out.
    #[serde(default)]
    pub commanded: BTreeMap<String, f64>,
    /// Stiffness of the joints by name, N m/rad or N/m; `others` is the stiffness of all joints without an entry.
    pub stiffness: BTreeMap<String, f64>,
    /// Limits of the motors: with `"from file"` motors stall at the efforts of the description file; no limits if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub effort: Option<MotorLimits>,
    /// Contacts by the name of the link on which they lie, in the frame of this link.
    pub contacts: BTreeMap<String, Vec<Fingertip<C>>>,
}

/// The source of the limits of motors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum MotorLimits {
    /// The `effort` limits of the description file.
    #[serde(rename = "from file")]
    FromFile,
}

impl RobotSetup<3> {
    /// Reads the robot and sets its posture; a relative path counts from `folder`.
    fn read_from(&self, folder: &Path) -> Result<Robot, Error> {
        let mut robot = Robot::read(folder.join(&self.urdf))?;
        let [roll, pitch, yaw] = self.turned_deg.map(f64::to_radians);
        let turned = UnitQuaternion::from_euler_angles(roll, pitch, yaw);
        robot = robot.placed(Isometry3::from_parts(Translation3::from(self.at), turned));
        for (name, given) in &self.joints {
            let position = robot.in_radians(name, *given)?;
            robot = robot.posed(name, position)?;
            check_range(&robot, (name, "position", *given))?;
        }
        for (name, given) in &self.commanded {
            let position = robot.in_radians(name, *given)?;
            robot = robot.commanded(name, position)?;
            check_range(&robot, (name, "command", *given))?;
        }
        robot = robot.stiffness(self.stiffness.get("others").copied().unwrap_or(0.0));
        for (name, stiffness) in self.stiffness.iter().filter(|(name, _)| *name != "others") {
            robot = robot.joint_stiffness(name, *stiffness)?;
        }
        for name in self.commanded.keys() {
            let stiffness = self.stiffness.get(name).or_else(|| self.stiffness.get("others"));
            if stiffness.is_none_or(|stiffness| *stiffness == 0.0) {
                let fault = format!(
                    "joint {name}: is commanded without stiffness, and would move freely: give it in `stiffness`, or `others`"
                );
                return Err(Error::Robot { fault });
            }
        }
        Ok(if self.effort.is_some() { robot.limited_by_effort() } else { robot })
    }

    /// Reads the robot, and returns its contacts on links that no joint moves, and fingers with all other contacts.
    fn spread(self, folder: &Path) -> Result<(Vec<Fingertip<3>>, Vec<FingerSetup<3>>), Error> {
        let robot = self.read_from(folder)?;
        let (mut links, mut entries) = (Vec::new(), Vec::new());
        for (name, on_link) in self.contacts {
            for entry in on_link {
                let link = robot.link(&name)?;
                entries.push(placed(&robot, link, links.len(), entry)?);
                links.push(link);
            }
        }
        let (fixed, groups) = robot.fingers(&links);
        let mut fingers = Vec::new();
        for group in groups {
            let joints = robot.joints_in(&group);
            let mut finger = FingerSetup::new(joints);
            for &k in &group.contacts {
                let moved_by = match robot.mover(&group, links[k], &entries[k].contact) {
                    Mover::Link(joints) => MovedBy::Link(joints),
                    Mover::Jacobian(twists) => MovedBy::Jacobian(twists),
                };
                finger = finger.contact(entries[k].clone().moved_by(moved_by));
            }
            fingers.push(finger);
        }
        Ok((fixed.into_iter().map(|k| entries[k].clone()).collect(), fingers))
    }
}

/// Refuses a joint whose position or command (`what`), degrees or m, is beyond its limits in the description file: no controller drives it there. A
/// thousandth of the distance of the limits is allowed, since angles in degrees are often written with three digits.
fn check_range(robot: &Robot, (name, what, value): (&str, &str, f64)) -> Result<(), Error> {
    let (unit, joint) =
        (robot.in_radians(name, 1.0)?, robot.joints().iter().find(|joint| joint.name() == name));
    let [low, high] = joint.map_or([0.0; 2], |joint| joint.range().map(|limit| limit / unit));
    let slack = 1e-3 * (high - low);
    if low < high && !(low - slack..=high + slack).contains(&value) {
        let fault =
            format!("joint {name}: {what} is {value}, must be from {low} to {high}, its limits in the file");
        return Err(Error::Robot { fault });
    }
    Ok(())
}

/// Transforms a contact, with the position and direction of its pad, from the frame of its link to the frame of the scene.
fn placed(robot: &Robot, link: usize, index: usize, mut entry: Fingertip<3>) -> Result<Fingertip<3>, Error> {
    if let Some(touches) = entry.touches.as_mut().filter(|touches| touches.collision_shapes) {
        let surface = robot.surface(&robot.links()[link])?;
        let strips = touches.strips.unwrap_or([4, 4]);
        let (pad, contact) = Pad::of_surface(&surface, &entry.contact, touches.rectangle, strips)?;
        touches.shape = Some(Arc::new(pad));
        entry.contact = contact;
    }
    entry.contact = robot.placed_on(link, index, &entry.contact)?;
    if let Some(touches) = &mut entry.touches {
        touches.from = std::array::from_fn(|a| entry.contact.point[a]);
        touches.closing = std::array::from_fn(|a| entry.contact.normal[a]);
    }
    Ok(entry)
}

impl Setup<3> {
    /// Refuses a robot in the plane, a robot without contacts, and robot contacts with a field `surface`.
    pub(super) fn check_robot(&self) -> Result<(), String> {
        let Some(robot) = &self.robot else { return Ok(()) };
        let mut entries = robot.contacts.values().flatten();
        if self.space == Space::Planar {
            return Err("robot: belongs to a spatial scene".to_owned());
        }
        if entries.clone().next().is_none() {
            return Err("robot: contacts: none given, must be at least one".to_owned());
        }
        if entries.any(|entry| entry.surface.is_some()) {
            return Err("robot: contacts: surface given, must be left out on a link".to_owned());
        }
        Ok(())
    }

    /// This setup with the contacts and fingers of its robot in place of the robot's description file.
    pub(super) fn with_robot_from(mut self, folder: &Path) -> Result<Self, Error> {
        if let Some(robot) = self.robot.take() {
            let (fixed, fingers) = robot.spread(folder)?;
            self.contacts.extend(fixed);
            self.fingers.extend(fingers);
        }
        Ok(self)
    }
}
