//! The data that are not known exactly, one by one.

use super::off::ContactErrors;
use super::uncertainty::Uncertainty;
use crate::error::Error;
use crate::grasp::{Contact, Engine};
use crate::prelude::*;

/// One datum with its σ, of a factor's logarithm or of an added amount.
pub(super) struct UncertainDatum {
    what: DatumKind,
    sigma: f64,
}

/// The kind of a datum, with its contact (the first one of a soft fingertip) or joint.
#[derive(Clone, Copy)]
enum DatumKind {
    Stiffness { contact: usize },
    Squeeze { contact: usize },
    Point { contact: usize, axis: usize },
    Normal { contact: usize, axis: usize },
    Joint(usize),
}

impl UncertainDatum {
    /// The engine with this datum off by z σ.
    pub(super) fn engine(&self, of: &Engine, z: f64) -> Result<Engine, Error> {
        let (factor, added) = ((self.sigma * z).exp(), self.sigma * z);
        let mut off = ContactErrors::not();
        let whose = match self.what {
            DatumKind::Stiffness { contact } => {
                off.stiffness = factor;
                Some(contact)
            }
            DatumKind::Squeeze { contact } => {
                off.squeeze = factor;
                Some(contact)
            }
            DatumKind::Point { contact, axis } => {
                off.moved[axis] = added;
                Some(contact)
            }
            DatumKind::Normal { contact, axis } => {
                off.tilt[axis] = added;
                Some(contact)
            }
            DatumKind::Joint(_) => None,
        };
        let mut contacts = of.contacts().to_vec();
        let is_meant = |i: usize, contact: &Contact<3>| Some(i) == whose || !contact.begins_a_whole();
        for (i, contact) in contacts.iter_mut().enumerate().skip(whose.unwrap_or(usize::MAX)) {
            if !is_meant(i, contact) {
                break;
            }
            *contact = off.applied_to(contact);
        }
        of.with_data(contacts, &|joint| {
            if matches!(self.what, DatumKind::Joint(j) if j == joint) { factor } else { 1.0 }
        })
    }
}

impl Engine {
    /// The uncertain data, without friction and load, which change no force by themselves.
    pub(super) fn data(&self, uncertainty: &Uncertainty) -> Vec<UncertainDatum> {
        let Uncertainty { stiffness, squeeze, position, normal, .. } = *uncertainty;
        let mut data = Vec::new();
        let mut add = |what: DatumKind, sigma: f64| {
            if sigma != 0.0 {
                data.push(UncertainDatum { what, sigma });
            }
        };
        for (contact, given) in self.contacts().iter().enumerate().filter(|(_, given)| given.begins_a_whole())
        {
            add(DatumKind::Stiffness { contact }, stiffness);
            if given.commanded()[0] != 0.0 || given.force.is_some() || given.suction != 0.0 {
                add(DatumKind::Squeeze { contact }, squeeze);
            }
            (0..self.space().axes()).for_each(|axis| add(DatumKind::Point { contact, axis }, position));
            (1..self.space().axes()).for_each(|axis| add(DatumKind::Normal { contact, axis }, normal));
        }
        for joint in (0..self.joint_commands().len()).filter(|joint| self.drives_of(*joint).next().is_some())
        {
            add(DatumKind::Joint(joint), stiffness);
        }
        data
    }
}
