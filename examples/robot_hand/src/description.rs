//! The description file: chains of joints, and their places in a posture.

use grasp_lcp::nalgebra::{Isometry3, Point3, Translation3, UnitQuaternion, UnitVector3, Vector3};
use urdf_rs::{JointType, Robot};

use crate::Failure;

/// One joint of a chain that leads from the palm to a tip.
pub struct ChainJoint {
    pub name: String,
    /// Pose of the joint's frame in the link before it.
    origin: Isometry3<f64>,
    axis: UnitVector3<f64>,
    /// Upper end of its range, rad.
    pub upper: f64,
    /// Largest torque of its motor, N m.
    pub effort: f64,
}

/// A finger: its joints from the palm outwards, and its tip in the frame of the last link.
pub struct Chain {
    pub name: String,
    pub joints: Vec<ChainJoint>,
    tip: Isometry3<f64>,
}

/// A finger in a posture, in the frame of the palm.
pub struct Placed {
    /// A point on each joint's axis, and the axis.
    pub joints: Vec<(Point3<f64>, UnitVector3<f64>)>,
    /// End of the last link.
    pub tip: Point3<f64>,
}

/// The fingers of a hand, one for each link that carries no further link.
pub fn fingers(text: &str) -> Result<Vec<Chain>, Failure> {
    let robot = urdf_rs::read_from_string(text)?;
    let is_tip = |link: &&urdf_rs::Link| robot.joints.iter().all(|joint| joint.parent.link != link.name);
    robot.links.iter().filter(is_tip).map(|tip| chain(&robot, &tip.name)).collect()
}

fn chain(robot: &Robot, tip: &str) -> Result<Chain, Failure> {
    let mut joints = Vec::new();
    let (mut link, mut beyond) = (tip, Isometry3::identity());
    while let Some(joint) = robot.joints.iter().find(|joint| joint.child.link == link) {
        let origin = pose(&joint.origin);
        match joint.joint_type {
            // A fixed joint is merged into the frame that follows the previous joint.
            JointType::Fixed => beyond = origin * beyond,
            JointType::Revolute if joints.is_empty() => joints.push((joint, origin, beyond)),
            JointType::Revolute => {
                joints.push((joint, origin, std::mem::replace(&mut beyond, Isometry3::identity())));
            }
            ref other => {
                return Err(format!(
                    "joint {}: {other:?} is not read here, must be revolute or fixed",
                    joint.name
                )
                .into());
            }
        }
        link = &joint.parent.link;
    }
    let tip_pose = joints.first().ok_or_else(|| format!("{tip}: no joint moves it"))?.2;
    let read = |(joint, origin, _): &(&urdf_rs::Joint, Isometry3<f64>, Isometry3<f64>)| {
        let axis = Vector3::from(*joint.axis.xyz);
        let axis = UnitVector3::try_new(axis, 0.0).ok_or_else(|| format!("joint {}: no axis", joint.name))?;
        let limit = &joint.limit;
        Ok(ChainJoint {
            name: joint.name.clone(),
            origin: *origin,
            axis,
            upper: limit.upper,
            effort: limit.effort,
        })
    };
    let joints = joints.iter().rev().map(read).collect::<Result<_, Failure>>()?;
    Ok(Chain { name: tip.trim_end_matches("_tip").to_owned(), joints, tip: tip_pose })
}

fn pose(pose: &urdf_rs::Pose) -> Isometry3<f64> {
    let [x, y, z] = *pose.xyz;
    let [roll, pitch, yaw] = *pose.rpy;
    Isometry3::from_parts(Translation3::new(x, y, z), UnitQuaternion::from_euler_angles(roll, pitch, yaw))
}

impl Chain {
    /// Places of the finger at these joint angles.
    pub fn at(&self, angles: &[f64]) -> Placed {
        let mut frame = Isometry3::identity();
        let mut joints = Vec::new();
        for (joint, angle) in self.joints.iter().zip(angles) {
            frame *= joint.origin;
            joints.push((frame.translation.vector.into(), frame.rotation * joint.axis));
            frame *= UnitQuaternion::from_axis_angle(&joint.axis, *angle);
        }
        Placed { joints, tip: (frame * self.tip).translation.vector.into() }
    }
}

impl Placed {
    /// Ends of the link behind joint `joint`.
    pub fn link(&self, joint: usize) -> [Point3<f64>; 2] {
        let end = self.joints.get(joint + 1).map_or(self.tip, |next| next.0);
        [self.joints[joint].0, end]
    }
}
