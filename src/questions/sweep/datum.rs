//! The data that are not known exactly, one by one.

use super::off::{ContactErrors, factor};
use super::uncertainty::Uncertainty;
use crate::error::Error;
use crate::grasp::{ContactPoints, Engine};
use crate::numerics::unit;
use crate::prelude::*;

/// One datum, with its error of one σ.
pub(super) enum UncertainDatum {
    /// Errors of all points of a contact.
    OfContact(usize, ContactErrors),
    /// The logarithm of the stiffness of a joint.
    OfJoint(usize, f64),
}

impl UncertainDatum {
    /// The engine with this datum off by z σ.
    pub(super) fn engine(&self, of: &Engine, z: f64) -> Result<Engine, Error> {
        let mut contacts = of.contacts().to_vec();
        if let Self::OfContact(contact, errors) = self {
            for point in &mut contacts[of.wholes()[*contact].range.clone()] {
                *point = errors.times(z).applied_to(point);
            }
        }
        of.with_data(contacts, &|joint| match self {
            Self::OfJoint(of, sigma) if *of == joint => factor(sigma * z),
            _ => 1.0,
        })
    }
}

impl Engine {
    /// The uncertain data that change forces while contacts stick. Friction does not, and the load is one factor on all forces that it causes.
    pub(super) fn data(&self, uncertainty: &Uncertainty) -> Vec<UncertainDatum> {
        let Uncertainty { stiffness, squeeze, position, normal, .. } = *uncertainty;
        let none = ContactErrors::default();
        let axes = self.space().axes();
        let mut data = Vec::new();
        for ContactPoints { label, range } in self.wholes().iter() {
            let given = &self.contacts()[range.start];
            let mut add = |errors| data.push(UncertainDatum::OfContact(label.index, errors));
            if stiffness != 0.0 {
                add(ContactErrors { stiffness, ..none });
            }
            let presses = given.commanded()[0] != 0.0 || given.force.is_some() || given.suction != 0.0;
            if squeeze != 0.0 && presses {
                add(ContactErrors { squeeze, ..none });
            }
            for axis in (0..axes).filter(|_| position != 0.0) {
                add(ContactErrors { moved: unit(axis) * position, ..none });
            }
            for axis in (1..axes).filter(|_| normal != 0.0) {
                add(ContactErrors { tilt: unit(axis) * normal, ..none });
            }
        }
        let driven = |joint: &usize| stiffness != 0.0 && self.drives_of(*joint).next().is_some();
        let joints = (0..self.joint_commands().len()).filter(driven);
        data.extend(joints.map(|joint| UncertainDatum::OfJoint(joint, stiffness)));
        data
    }
}
