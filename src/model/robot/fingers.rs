//! Grouping of contacts on links into fingers, each with the joints that move it.

use nalgebra::{DMatrix, Point3};

use super::described::Robot;
use crate::error::Error;
use crate::grasp::{Contact, Finger, Hand, Joint, JointKind};

/// A finger of the grasp: its independent joints, i.e. those that mimic no other joint, and the indices of its contacts.
pub(crate) struct JointGroup {
    joints: Vec<usize>,
    pub(crate) contacts: Vec<usize>,
}

/// How the joints of a finger move one of its contacts.
pub(crate) enum Mover {
    /// The contact is on the link behind this number of joints, counted from the base of the finger. Only these joints of the finger move it.
    Link(usize),
    /// For each joint the velocity of the contact point (rows 0 to 2) and the angular velocity of the link (rows 3 to 5).
    Jacobian(DMatrix<f64>),
}

impl Robot {
    /// The hand with these contacts, each with the name of its link and in the frame of the object. [`Self::on_link`] converts a contact from
    /// the frame of its link.
    ///
    /// Contacts on links that no joint moves come first, then the contacts of fingers. Links that share a joint belong to the same finger. Joints
    /// that move no contact are omitted. With the rate φ_j of a revolute joint j, its axis, and a point centre_j on the axis,
    ///
    /// ```text
    /// velocity of a contact = Σ_j factor_j (axis_j × (point - centre_j)) φ_j        factor: 1, or the factor of a joint that mimics another
    /// ```
    ///
    /// # Errors
    /// [`Error::Robot`] for an unknown link.
    pub fn hand(&self, contacts: &[(&str, Contact<3>)]) -> Result<Hand<3>, Error> {
        let links = contacts.iter().map(|(link, _)| self.link(link)).collect::<Result<Vec<_>, _>>()?;
        let (fixed, fingers) = self.fingers(&links);
        let mut hand = Hand::new(fixed.into_iter().map(|k| Finger::fixed(contacts[k].1.clone())));
        for group in fingers {
            let mut finger = Finger::new(self.joints_in(&group));
            for &k in &group.contacts {
                let contact = contacts[k].1.clone();
                finger = match self.mover(&group, links[k], &contact) {
                    Mover::Link(joints) => finger.contact_on(joints, contact),
                    Mover::Jacobian(twists) => {
                        finger.contact_moved_by(twists.rows(0, 3).into_owned(), contact)
                    }
                };
            }
            hand = hand.finger(finger);
        }
        Ok(hand)
    }

    /// Converts a contact from the frame of its link to the frame of the object, for [`Self::hand`]. Its first tangent rotates with the link.
    ///
    /// # Errors
    /// [`Error::Robot`] for an unknown link, [`Error::Contact`] for a normal or a tangent without direction.
    pub fn on_link<'n>(&self, link: &'n str, contact: &Contact<3>) -> Result<(&'n str, Contact<3>), Error> {
        Ok((link, self.placed_on(self.link(link)?, 0, contact)?))
    }

    /// Converts a contact from the frame of its link to the frame of the object. Errors name the contact by `index`.
    pub(crate) fn placed_on(
        &self,
        link: usize,
        index: usize,
        contact: &Contact<3>,
    ) -> Result<Contact<3>, Error> {
        let pose = self.pose_of(link);
        let tangent = contact.frame(index)?.column(1).into_owned();
        let command = Contact { press: None, ..contact.clone() }.commanded();
        Ok(Contact {
            point: (pose * Point3::from(contact.point)).coords,
            normal: pose * contact.normal,
            tangent: Some(pose * tangent),
            ..contact.clone().command(command)
        })
    }

    /// Indices of the contacts on links that no joint moves, and the fingers of all other contacts.
    pub(crate) fn fingers(&self, links: &[usize]) -> (Vec<usize>, Vec<JointGroup>) {
        let (mut fixed, mut fingers) = (Vec::new(), Vec::<JointGroup>::new());
        for (k, &link) in links.iter().enumerate() {
            let mut joints: Vec<usize> =
                self.movers_of(link).into_iter().map(|index| self.coordinate(index).0).collect();
            if joints.is_empty() {
                fixed.push(k);
                continue;
            }
            let mut contacts = vec![k];
            let (shared, apart): (Vec<_>, Vec<_>) = fingers
                .into_iter()
                .partition(|finger| finger.joints.iter().any(|index| joints.contains(index)));
            for finger in shared.into_iter().rev() {
                joints.extend(finger.joints);
                contacts.splice(0..0, finger.contacts);
            }
            joints.sort_unstable();
            joints.dedup();
            fingers = apart;
            fingers.push(JointGroup { joints, contacts });
        }
        fingers.sort_by_key(|finger| finger.contacts[0]);
        (fixed, fingers)
    }

    /// The independent joint that a joint follows, and the factor from its displacement to the displacement of the follower. For an independent joint
    /// the result is the joint itself and 1.
    fn coordinate(&self, joint: usize) -> (usize, f64) {
        self.joints[joint].mimics.map_or((joint, 1.0), |mimics| (mimics.joint, mimics.factor))
    }

    /// The independent joints of a finger, converted to joints of a hand with axis, stiffness, command and limit.
    pub(crate) fn joints_in(&self, finger: &JointGroup) -> Vec<Joint<3>> {
        let joint = |&index: &usize| {
            let (point, axis) = self.axis_of(index);
            let described = &self.joints[index];
            let moving = match described.kind {
                Some(JointKind::Slides) => Joint::prismatic(axis),
                _ => Joint::<3>::revolute(point, axis),
            };
            let command = described.commanded.map_or(0.0, |commanded| commanded - described.position);
            let joint = moving.name(&described.name).stiffness(described.stiffness).command(command);
            described.limit.into_iter().fold(joint, Joint::limit)
        };
        finger.joints.iter().map(joint).collect()
    }

    /// How the joints of a finger move a contact on the link `link`.
    pub(crate) fn mover(&self, finger: &JointGroup, link: usize, contact: &Contact<3>) -> Mover {
        let movers = self.movers_of(link);
        if finger.joints.starts_with(&movers) {
            return Mover::Link(movers.len());
        }
        let mut twists = DMatrix::zeros(6, finger.joints.len());
        for index in movers {
            let (coordinate, factor) = self.coordinate(index);
            let Some(column) = finger.joints.iter().position(|joint| *joint == coordinate) else { continue };
            let (point, axis) = self.axis_of(index);
            let (velocity, turning) = match self.joints[index].kind {
                Some(JointKind::Slides) => (axis, axis * 0.0),
                _ => (axis.cross(&(contact.point - point.coords)), axis),
            };
            for a in 0..3 {
                twists[(a, column)] += factor * velocity[a];
                twists[(3 + a, column)] += factor * turning[a];
            }
        }
        Mover::Jacobian(twists)
    }
}
