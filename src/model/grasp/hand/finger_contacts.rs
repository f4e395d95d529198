//! Contacts of a finger: their motion with the joints, the compliance behind them, and the commands that make them press. A command is a prescribed
//! displacement of a contact or joint. Links are the rigid parts of a finger between its joints.

use nalgebra::{DMatrix, DVector};

use super::compliant::split;
use super::draft::{Assembly, Columns, refuse};
use super::drive::Drive;
use super::finger::{ContactMover, Finger};
use crate::error::{Error, MODERATE, is_moderate};
use crate::grasp::contact::Contact;
use crate::grasp::of_axes;
use crate::numerics::{IntoList, Reals, numbered, vector_of};
use crate::prelude::*;

impl Assembly {
    /// Adds the contacts of a finger to the grasp. `number` is the index of the finger, and `first` the index of its first joint, both from 0.
    pub(super) fn add_contacts(
        &mut self,
        finger: &Finger<3>,
        number: usize,
        first: usize,
    ) -> Result<(), Error> {
        let axes = self.space.axes();
        let (pads, own) = match &finger.compliance {
            None => (DVector::zeros(0), Vec::new()),
            Some(matrix) => split(matrix, axes * finger.contacts.len())
                .or_else(|fault| refuse(fault, format!("finger {number}"), "compliance"))?,
        };
        for (place, carried) in finger.contacts.iter().enumerate() {
            let index = self.contacts.len();
            let mut contact = carried.contact.clone();
            if !pads.is_empty() {
                contact.stiffness = contact.stiffness.softened(&of_axes(axes, |a| pads[axes * place + a]));
            }
            contact.check(index)?;
            let frame = contact.frame(index)?;
            let press = contact.press.unwrap_or(0.0);
            self.presses.push((press, frame.column(0) * press));
            let mut columns = match &carried.by {
                ContactMover::World(matrix) => given(matrix, (finger, first), (&contact, index))?,
                ContactMover::Link(link) => self.on_link(*link, finger, (&contact, index), first)?,
            };
            columns.extend(self.on_slide(finger, (&contact, index), &frame)?);
            // The compliance matrix of the finger is C = D + V Vᵀ with a diagonal D. The columns of V couple the contacts. For each column of V the
            // hand gets one more coordinate, with a spring of stiffness 1; it is not the displacement of a joint.
            for (k, column) in own.iter().enumerate() {
                let along = of_axes(axes, |a| column[axes * place + a]);
                columns.push((self.used + k, frame * along));
            }
            self.contacts.push(contact);
            self.motions.push(columns);
        }
        self.press_on_compliance(finger, &own);
        for k in 0..own.len() {
            self.drives.push(Drive::unowned(self.object() + self.used + k, 1.0));
        }
        self.used += own.len();
        Ok(())
    }

    /// Displacements of a contact on a link per unit displacement of each joint between palm and link, from the joints' axes and directions. `link`
    /// is the number of these joints.
    fn on_link(
        &mut self,
        link: usize,
        finger: &Finger<3>,
        (contact, index): (&Contact<3>, usize),
        first: usize,
    ) -> Result<Columns, Error> {
        if link > finger.joints.len() {
            let what = format!("contact {}", contact.label(index));
            return Self::fault(what, "link", link as f64, "at most the number of joints of its finger");
        }
        let joints = &finger.joints[..link];
        let corners: Vec<_> =
            joints.iter().filter_map(|joint| joint.motion.centre()).chain([contact.point]).list();
        corners.windows(2).map(|pair| [pair[0], pair[1]]).append_to(&mut self.bones);
        let mut columns = Columns::new();
        for (j, joint) in joints.iter().enumerate() {
            let label = || self.label(first + j);
            let velocity = match joint.motion.of_point(&contact.point) {
                Ok(velocity) => velocity,
                Err(axis) => return Self::fault(label(), "axis", axis, "of positive, finite length"),
            };
            if let Some(&value) = velocity.iter().find(|x| !is_moderate(**x)) {
                return Self::fault(label(), "axis or point", value, MODERATE);
            }
            columns.push((first + j, velocity));
        }
        Ok(columns)
    }

    /// Adds to the commands of a finger's contacts what its compliance takes away, so that the contacts press with the given forces
    /// `Contact::pressed_with`. The springs of the contacts have only the diagonal part D of the finger's compliance matrix D + V Vᵀ. Under the
    /// pressing forces the part V Vᵀ displaces the contacts, too; these displacements are added. `own` has the columns of V.
    fn press_on_compliance(&mut self, finger: &Finger<3>, own: &[DVector<f64>]) {
        let (axes, first) = (self.space.axes(), self.contacts.len() - finger.contacts.len());
        for column in own {
            let presses = self.presses[first..].iter().enumerate();
            let pushed: f64 = presses.map(|(i, (force, _))| column[axes * i] * force).added();
            for (i, contact) in self.contacts[first..].iter_mut().enumerate() {
                let along = of_axes(axes, |a| column[axes * i + a] * pushed);
                if pushed != 0.0 {
                    *contact = contact.clone().resolved();
                    contact.command += along;
                }
            }
        }
    }

    /// Joint commands under which the contacts press with the forces F of `Contact::pressed_with`. They are `K⁻¹ Σ Jᵀ F`, with the joint stiffness K
    /// and the Jacobians J of the contacts.
    pub(super) fn pressed(&self, fingers: &[Finger<3>]) -> Result<Vec<f64>, Error> {
        let mut torques = vec![0.0; self.joints.len()];
        for (motions, (_, force)) in self.motions.iter().zip(&self.presses) {
            for (k, motion) in motions.iter().filter(|(k, _)| *k < self.joints.len()) {
                torques[*k] += motion.dot(force);
            }
        }
        let mut first = 0;
        for finger in fingers {
            let count = finger.joints.len();
            let torque = vector_of(count, &|j| torques[first + j]);
            if torque.amax() != 0.0 {
                let mut stiffness = finger.coupling.clone().unwrap_or_else(|| DMatrix::zeros(count, count));
                for j in 0..count {
                    stiffness[(j, j)] += finger.joints[j].stiffness;
                }
                let Some(commands) = stiffness.lu().solve(&torque) else {
                    let what = self.label(first);
                    return Self::fault(
                        what,
                        "stiffness",
                        0.0,
                        "positive where a contact has `pressed_with`; where a tendon moves the joint, its `pull` presses instead",
                    );
                };
                torques[first..first + count].copy_from_slice(commands.as_slice());
            }
            first += count;
        }
        Ok(torques)
    }
}

/// Displacements of a contact, along the coordinate axes, per unit of each joint of its finger: the columns of a Jacobian that the user gave.
fn given(
    matrix: &DMatrix<f64>,
    (finger, first): (&Finger<3>, usize),
    (contact, index): (&Contact<3>, usize),
) -> Result<Columns, Error> {
    let axes = contact.space.axes();
    let expected = (axes, finger.joints.len());
    if matrix.shape() != expected {
        let what = format!("jacobian of contact {}", contact.label(index));
        return Err(Error::Shape { what, given: matrix.shape(), expected });
    }
    if let Some(&value) = matrix.as_slice().iter().find(|x| !is_moderate(**x)) {
        let what = format!("contact {}", contact.label(index));
        return Err(Error::Hand { what, field: "jacobian", value, allowed: MODERATE });
    }
    let column = |j: usize| of_axes(axes, |a| matrix[(a, j)]);
    Ok(numbered(expected.1, &|j| (first + j, column(j))))
}
