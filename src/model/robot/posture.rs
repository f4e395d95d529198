//! The posture of a robot: positions, commands and stiffnesses of its joints, and the poses of its links.

use nalgebra::{Isometry3, Point3, Translation3, Vector3};

use super::described::{Robot, RobotJoint, fault};
use crate::error::{Error, MODERATE, is_moderate};
use crate::grasp::{JointKind, Limit};

impl Robot {
    /// This robot with its root links at the pose `base` in the frame of the object.
    pub fn placed(self, base: Isometry3<f64>) -> Self {
        Self { base, ..self }
    }

    /// This robot with one joint at another position, rad or m. Joints that mimic it follow.
    ///
    /// # Errors
    /// [`Error::Robot`] for a joint that is unknown, fixed or mimics another, and for a position that is not finite or too large.
    pub fn posed(mut self, joint: &str, position: f64) -> Result<Self, Error> {
        self.independent_joint(joint, position, "position")?.position = position;
        Ok(self)
    }

    /// This robot with one joint commanded to a position, rad or m. By default a joint is commanded to its actual position.
    ///
    /// # Errors
    /// [`Error::Robot`] for a joint that is unknown, fixed or mimics another, and for a number that is not finite or too large.
    pub fn commanded(mut self, joint: &str, position: f64) -> Result<Self, Error> {
        self.independent_joint(joint, position, "commanded position")?.commanded = Some(position);
        Ok(self)
    }

    /// Converts a position in degrees to rad; a position of a prismatic joint stays in m.
    #[cfg(feature = "serde")]
    pub(crate) fn in_radians(&self, joint: &str, position: f64) -> Result<f64, Error> {
        let slides = self.joints[self.index(joint)?].kind == Some(JointKind::Slides);
        Ok(if slides { position } else { position.to_radians() })
    }

    /// This robot with the same stiffness for all joints, N m/rad or N/m, of structure and controller in series.
    pub fn stiffness(mut self, stiffness: f64) -> Self {
        for joint in &mut self.joints {
            joint.stiffness = stiffness;
        }
        self
    }

    /// This robot with another stiffness of one joint, N m/rad or N/m.
    ///
    /// # Errors
    /// [`Error::Robot`] for a joint that is unknown, fixed or mimics another, and for a number that is not finite or too large.
    pub fn joint_stiffness(mut self, joint: &str, stiffness: f64) -> Result<Self, Error> {
        self.independent_joint(joint, stiffness, "stiffness")?.stiffness = stiffness;
        Ok(self)
    }

    /// This robot with motors that yield at the efforts of the file: the torque, N m, or force, N, stays at this limit ([`Limit::Saturates`]). A
    /// joint without an effort has no limit.
    pub fn limited_by_effort(mut self) -> Self {
        for joint in &mut self.joints {
            joint.limit = (joint.effort > 0.0).then_some(Limit::Saturates(joint.effort));
        }
        self
    }

    /// The independent joint with this name, for a setter. Returns an error for a joint that is unknown, fixed or mimics another, and for a `value`
    /// that is not finite or too large; `what` names the value in the message.
    fn independent_joint(&mut self, name: &str, value: f64, what: &str) -> Result<&mut RobotJoint, Error> {
        let index = self.index(name)?;
        let joint = &self.joints[index];
        let refused = if joint.kind.is_none() {
            "is fixed".to_owned()
        } else if let Some(mimics) = joint.mimics {
            format!("mimics {}: set that of the joint it follows", self.joints[mimics.joint].name)
        } else if is_moderate(value) {
            return Ok(&mut self.joints[index]);
        } else {
            format!("{what} is {value}, must be {MODERATE}")
        };
        Err(fault(format!("joint {name}: {refused}")))
    }

    /// The pose of a link in the frame of the object.
    ///
    /// # Errors
    /// [`Error::Robot`] for an unknown link.
    pub fn pose(&self, link: &str) -> Result<Isometry3<f64>, Error> {
        Ok(self.pose_of(self.link(link)?))
    }

    pub(super) fn pose_of(&self, link: usize) -> Isometry3<f64> {
        let Some(index) = self.carried_by[link] else { return self.base };
        let joint = &self.joints[index];
        let position = joint.mimics.map_or(joint.position, |mimics| {
            mimics.factor.mul_add(self.joints[mimics.joint].position, mimics.offset)
        });
        let moved = match joint.kind {
            Some(JointKind::Turns) => Isometry3::rotation(*joint.axis * position),
            Some(_) => Translation3::from(*joint.axis * position).into(),
            None => Isometry3::identity(),
        };
        self.pose_of(joint.parent) * joint.origin * moved
    }

    /// A point on the axis of a joint, m, and the unit vector of the axis, in the frame of the object.
    pub(super) fn axis_of(&self, joint: usize) -> (Point3<f64>, Vector3<f64>) {
        let joint = &self.joints[joint];
        let frame = self.pose_of(joint.parent) * joint.origin;
        (frame.translation.vector.into(), frame.rotation * *joint.axis)
    }

    /// Indices of the joints that move a link, from the root outwards; joints that mimic others are included.
    pub(super) fn movers_of(&self, mut link: usize) -> Vec<usize> {
        let mut movers = Vec::new();
        while let Some(index) = self.carried_by[link] {
            if self.joints[index].kind.is_some() {
                movers.push(index);
            }
            link = self.joints[index].parent;
        }
        movers.reverse();
        movers
    }

    /// The joints that move a link, from the root link outwards, including joints that mimic others.
    ///
    /// # Errors
    /// [`Error::Robot`] for an unknown link.
    pub fn joints_of(&self, link: &str) -> Result<Vec<&RobotJoint>, Error> {
        Ok(self.movers_of(self.link(link)?).into_iter().map(|index| &self.joints[index]).collect())
    }

    /// A point on the axis of a joint, m, and the unit vector of the axis, in the frame of the object.
    ///
    /// # Errors
    /// [`Error::Robot`] for an unknown joint.
    pub fn axis(&self, joint: &str) -> Result<(Point3<f64>, Vector3<f64>), Error> {
        Ok(self.axis_of(self.index(joint)?))
    }
}
