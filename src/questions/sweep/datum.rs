//! The data that are not known exactly, one by one.

use crate::numerics::IntoList;
use core::ops::Range;

use super::off::{ContactErrors, factor};
use super::uncertainty::Uncertainty;
use crate::equilibrium::Parameter;
use crate::error::Error;
use crate::grasp::Engine;
use crate::numerics::unit;
use crate::prelude::*;

/// One datum, with its error of one σ.
pub(super) enum UncertainDatum {
    /// Of a contact, or of all points of the soft fingertip that it begins.
    OfContact(usize, ContactErrors),
    /// The logarithm of the stiffness of a joint.
    OfJoint(usize, f64),
}

/// The contact, or all points of the soft fingertip that it begins.
fn points(of: &Engine, contact: usize) -> Range<usize> {
    let further = of.contacts().iter().skip(contact + 1).take_while(|point| !point.begins_a_whole());
    contact..contact + 1 + further.count()
}

impl UncertainDatum {
    /// The engine with this datum off by z σ.
    pub(super) fn engine(&self, of: &Engine, z: f64) -> Result<Engine, Error> {
        let mut contacts = of.contacts().to_vec();
        if let Self::OfContact(contact, errors) = self {
            for point in &mut contacts[points(of, *contact)] {
                *point = errors.times(z).applied_to(point);
            }
        }
        of.with_data(contacts, &|joint| match self {
            Self::OfJoint(of, sigma) if *of == joint => factor(sigma * z),
            _ => 1.0,
        })
    }

    /// The parameters of which this is a datum, each with its change by one σ.
    pub(super) fn parameters(&self, of: &Engine) -> Vec<(Parameter, f64)> {
        match self {
            Self::OfContact(contact, errors) => {
                let mut all = Vec::new();
                for point in points(of, *contact) {
                    all.extend(errors.parameters(of, point));
                }
                all
            }
            &Self::OfJoint(joint, sigma) => {
                let drive = of.drives_of(joint).next();
                let by = drive.map(|(_, drive)| sigma * drive.stiffness_of_owner());
                by.map(|by| (Parameter::JointStiffness { joint }, by)).into_iter().list()
            }
        }
    }
}

impl Engine {
    /// The uncertain data that change forces; those of the load and of friction do not by themselves.
    pub(super) fn data(&self, uncertainty: &Uncertainty) -> Vec<UncertainDatum> {
        let Uncertainty { stiffness, squeeze, position, normal, .. } = *uncertainty;
        let none = ContactErrors::default();
        let axes = self.space().axes();
        let mut data = Vec::new();
        for (i, given) in self.contacts().iter().enumerate().filter(|(_, given)| given.begins_a_whole()) {
            let mut add = |errors| data.push(UncertainDatum::OfContact(i, errors));
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
