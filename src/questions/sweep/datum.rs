//! The uncertain data of a grasp on which contact forces depend, each with its standard deviation. The squeeze is everything by which contacts press
//! at rest without a load, such as commands of fingers and constant forces.

use super::contact_errors::{ContactErrors, factor};
use super::uncertainty::Uncertainty;
use crate::error::Error;
use crate::grasp::{ContactPoints, Engine};
use crate::numerics::{Each, Reals, unit};
use crate::prelude::*;

/// One uncertain datum of a grasp, with its error of one standard deviation σ.
#[derive(Debug, Clone)]
pub(super) enum UncertainDatum {
    /// A datum of the contact with this index, common to all points of a soft fingertip. [`ContactErrors`] are the errors of the contact's data if
    /// this datum is off by one σ.
    OfContact(usize, ContactErrors),
    /// A datum of the joint or tendon with this index. The numbers are the errors of the logarithms of its stiffness and its squeeze if this datum is
    /// off by one σ.
    OfPart(usize, [f64; 2]),
}

/// Returns the grasp in which each of the uncertain `data` is in error by its entry of `z`, in standard deviations. Returns an error if a datum
/// leaves its allowed range, or if the grasp cannot hold the given tension of a link (a cable or spring between bodies).
pub(super) fn with_errors(of: &Engine, data: &[UncertainDatum], z: &[f64]) -> Result<Engine, Error> {
    let mut errors = vec![ContactErrors::default(); of.wholes().len()];
    for (datum, z) in data.iter().zip(z) {
        if let UncertainDatum::OfContact(contact, of_datum) = datum {
            errors[*contact].add(*z, of_datum);
        }
    }
    let mut contacts = of.contacts().to_vec();
    for (whole, errors) in of.wholes().iter().zip(&errors) {
        for point in &mut contacts[whole.range.clone()] {
            *point = errors.applied_to(point);
        }
    }
    of.with_data(contacts, &|part| {
        [0, 1].each(|k| {
            let of_part = |(datum, z): (&UncertainDatum, &f64)| match datum {
                UncertainDatum::OfPart(of, errors) if *of == part => errors[k] * z,
                _ => 0.0,
            };
            factor(data.iter().zip(z).map(of_part).added())
        })
    })?
    .installed()
}

impl Engine {
    /// The uncertain data that change contact forces while contacts stick: stiffness, squeeze, positions and normals with σ other than zero. Friction
    /// does not change these forces. An uncertain load is treated separately, because one factor multiplies all forces due to the load.
    pub(super) fn data(&self, uncertainty: &Uncertainty) -> Vec<UncertainDatum> {
        let Uncertainty { stiffness, squeeze, position, normal, .. } = *uncertainty;
        let none = ContactErrors::default();
        let axes = self.space().axes();
        let mut data = Vec::new();
        for ContactPoints { label, range } in self.wholes().iter() {
            let mut add = |errors| data.push(UncertainDatum::OfContact(label.index, errors));
            if stiffness != 0.0 {
                add(ContactErrors { stiffness, ..none });
            }
            if squeeze != 0.0 && range.clone().any(|point| self.is_commanded(point)) {
                add(ContactErrors { squeeze, ..none });
            }
            for axis in (0..axes).filter(|_| position != 0.0) {
                add(ContactErrors { moved: unit(axis) * position, ..none });
            }
            for axis in (1..axes).filter(|_| normal != 0.0) {
                add(ContactErrors { tilt: unit(axis) * normal, ..none });
            }
        }
        for part in 0..self.joint_commands().len() {
            if stiffness != 0.0 && self.drives_of(part).next().is_some() {
                data.push(UncertainDatum::OfPart(part, [stiffness, 0.0]));
            }
            if squeeze != 0.0 && self.is_driven(part) {
                data.push(UncertainDatum::OfPart(part, [0.0, squeeze]));
            }
        }
        data
    }
}
