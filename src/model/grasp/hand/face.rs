//! Conversion of hands between vectors of two components, which users of the plane give, and the engine's vectors of three. A revolute joint of the
//! plane turns about z.

use nalgebra::SVector;

use super::finger::{ContactMover, Finger, FingerContact};
use super::hand_builder::Hand;
use super::joint::{Joint, JointMotion, Limit};
use super::tendon::Tendon;
use crate::grasp::{Face, face_of_struct, same_on_both_sides};

same_on_both_sides! { ContactMover, Limit, Tendon }

face_of_struct! {
    Hand { fingers, tendons }
    Finger { joints, coupling, compliance, contacts }
    FingerContact { contact, by }
    Joint { name, motion, stiffness, command, torque, limit }
}

impl<const C: usize> Face for JointMotion<C> {
    type Inside = JointMotion<3>;
    const SAME: bool = C == 3;

    fn widen(&self) -> JointMotion<3> {
        match self {
            Self::Revolute { point, .. } => {
                // A revolute joint of the plane stores no axis vector; it turns about z.
                JointMotion::Revolute { point: point.to_inside(), axis: SVector::from([0.0, 0.0, 1.0]) }
            }
            Self::Prismatic { direction } => JointMotion::Prismatic { direction: direction.to_inside() },
            Self::Given => JointMotion::Given,
        }
    }

    fn narrow(inside: JointMotion<3>) -> Self {
        match inside {
            JointMotion::Revolute { point, axis } => {
                Self::Revolute { point: Face::from_inside(point), axis: Face::from_inside(axis) }
            }
            JointMotion::Prismatic { direction } => {
                Self::Prismatic { direction: Face::from_inside(direction) }
            }
            JointMotion::Given => Self::Given,
        }
    }
}
