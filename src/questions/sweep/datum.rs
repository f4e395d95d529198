//! The data that are not known exactly, one by one.

use core::ops::Range;

use super::off::ContactErrors;
use super::uncertainty::Uncertainty;
use crate::equilibrium::Parameter;
use crate::error::Error;
use crate::grasp::Engine;
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
        match self.what {
            DatumKind::Stiffness { .. } => off.stiffness = factor,
            DatumKind::Squeeze { .. } => off.squeeze = factor,
            DatumKind::Point { axis, .. } => off.moved[axis] = added,
            DatumKind::Normal { axis, .. } => off.tilt[axis] = added,
            DatumKind::Joint(_) => {}
        }
        let mut contacts = of.contacts().to_vec();
        for contact in &mut contacts[self.contacts(of)] {
            *contact = off.applied_to(contact);
        }
        of.with_data(contacts, &|joint| {
            if matches!(self.what, DatumKind::Joint(j) if j == joint) { factor } else { 1.0 }
        })
    }

    /// The contacts that this datum belongs to: the points of a soft fingertip together; none of a joint.
    fn contacts(&self, of: &Engine) -> Range<usize> {
        match self.what {
            DatumKind::Joint(_) => 0..0,
            DatumKind::Stiffness { contact }
            | DatumKind::Squeeze { contact }
            | DatumKind::Point { contact, .. }
            | DatumKind::Normal { contact, .. } => {
                let further = of.contacts().iter().skip(contact + 1);
                contact..contact + 1 + further.take_while(|point| !point.begins_a_whole()).count()
            }
        }
    }

    /// The parameters of which this is a datum, each with its change by one σ.
    pub(super) fn parameters(&self, of: &Engine) -> Vec<(Parameter, f64)> {
        let mut parameters = Vec::new();
        for contact in self.contacts(of) {
            let given = &of.contacts()[contact];
            match self.what {
                DatumKind::Stiffness { .. } => {
                    let series = given.series_stiffness_of_axes();
                    let along = |axis| (Parameter::Stiffness { contact, axis }, series[axis]);
                    parameters.extend((0..of.space().axes()).map(along));
                }
                DatumKind::Squeeze { .. } => {
                    parameters.push((Parameter::Command { contact, axis: 0 }, given.commanded()[0]));
                }
                DatumKind::Point { axis, .. } => parameters.push((Parameter::Point { contact, axis }, 1.0)),
                DatumKind::Normal { axis, .. } => parameters.push((Parameter::Normal { contact, axis }, 1.0)),
                DatumKind::Joint(_) => {}
            }
        }
        if let DatumKind::Joint(joint) = self.what {
            let drive = of.drives_of(joint).next().map(|(_, drive)| drive.stiffness_of_owner());
            parameters.extend(drive.map(|stiffness| (Parameter::JointStiffness { joint }, stiffness)));
        }
        parameters.iter_mut().for_each(|(_, change)| *change *= self.sigma);
        parameters
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
