//! The parts of a grasp, collected from a hand: contacts, joints and drives. A drive is the spring of a joint or tendon, with its force limit.

use nalgebra::SVector;

use super::drive::Drive;
use super::joint::Joint;
use super::positive::NotPositive;
use crate::error::Error;
use crate::grasp::contact::Contact;
use crate::numerics::{Space, Vector};
use crate::prelude::*;
use crate::words::printable;

/// Motion of one contact with joints and other bodies, as a list of pairs. The first entry of a pair is the index of a coordinate, counted after the
/// object's coordinates. The second is the displacement of the contact per unit of this coordinate, along the axes x, y and z.
pub(in crate::model::grasp) type Columns = Vec<(usize, SVector<f64, 3>)>;

pub(in crate::model::grasp) struct Assembly {
    pub(in crate::model::grasp) space: Space,
    pub(in crate::model::grasp) contacts: Vec<Contact<3>>,
    pub(in crate::model::grasp) motions: Vec<Columns>,
    /// Joints of all fingers, then the slides of contacts with a constant force. Such a slide is a prismatic joint along the contact normal.
    pub(super) joints: Vec<Joint<3>>,
    /// Number of coordinates assigned so far to joints, drives and bodies; the coordinates of the object are not counted.
    pub(in crate::model::grasp) used: usize,
    pub(in crate::model::grasp) lengths: Vector,
    pub(super) drives: Vec<Drive>,
    pub(in crate::model::grasp) held_forces: Vector,
    pub(super) bones: Vec<[SVector<f64, 3>; 2]>,
    /// For each contact the pressing force of `Contact::pressed_with`, N: its magnitude, and its vector along the coordinate axes.
    pub(super) presses: Vec<(f64, SVector<f64, 3>)>,
}

impl Assembly {
    /// Number of coordinates of the object, which precede the coordinates of the joints.
    pub(super) fn object(&self) -> usize {
        self.space.of_the_object()
    }

    pub(super) fn fault<T>(
        what: String,
        field: &'static str,
        value: f64,
        allowed: &'static str,
    ) -> Result<T, Error> {
        Err(Error::Hand { what, field, value, allowed })
    }

    pub(super) fn label(&self, joint: usize) -> String {
        self.joints[joint]
            .name
            .as_ref()
            .map_or_else(|| format!("joint {joint}"), |name| format!("joint {joint} ({})", printable(name)))
    }
}

/// The error for a stiffness or compliance matrix that is not symmetric positive semidefinite. `what` names the finger in the message, and `field`
/// the matrix.
pub(super) fn refuse<T>(fault: NotPositive, what: String, field: &'static str) -> Result<T, Error> {
    Err(match fault {
        NotPositive::Shape { rows, columns, size } => Error::Shape {
            what: format!("{field} of {what}"),
            given: (rows, columns),
            expected: (size, size),
        },
        NotPositive::Entry(value) => Error::Hand { what, field, value, allowed: crate::error::MODERATE },
        NotPositive::Asymmetry(value) => {
            Error::Matrix { what, field, fault: "differs across its diagonal by", value }
        }
        NotPositive::Eigenvalue(value) => Error::Matrix { what, field, fault: "has the eigenvalue", value },
    })
}
