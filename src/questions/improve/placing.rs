//! The variables of the search, their values ([`Placing`]), and the grasp with these values.

use nalgebra::SVector;

use super::places::clockwise;
use super::question::Improve;
use super::spot::Spot;
use super::tolerances::OFF_THE_SURFACE;
use crate::ask::Grasp;
use crate::equilibrium::Settings;
use crate::error::Error;
use crate::grasp::{Contact, Hold, Space, WholeContacts};
use crate::numerics::{Draw, largest, numbered};
use crate::prelude::*;

/// One variable of the search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct DesignVariable {
    pub(super) contact: usize,
    pub(super) what: DesignKind,
    /// The unit of the variable, m or N. Steps are divided by it, so that all variables have numbers of like size.
    pub(super) unit: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum DesignKind {
    /// The position of the contact along this tangent direction of its surface.
    Along(usize),
    /// The normal force that the command of the contact presses with, from 0 to `most`, N.
    Press { most: f64 },
}

/// The variables of the search, and the data that stay fixed.
#[derive(Debug)]
pub(super) struct Choice<'q> {
    pub(super) question: &'q Improve<3>,
    pub(super) contacts: &'q [Contact<3>],
    /// The given contacts, each with its points.
    pub(super) wholes: &'q WholeContacts,
    pub(super) settings: &'q Settings,
    /// The first tangents of the contact frames in the given grasp.
    tangents: Vec<SVector<f64, 3>>,
    pub(super) variables: Vec<DesignVariable>,
}

/// Values of all variables: where each contact that may move is, and how hard each contact presses whose squeeze may change.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Placing {
    pub(super) spots: Vec<Option<Spot>>,
    /// The first tangents of all contact frames.
    pub(super) tangents: Vec<SVector<f64, 3>>,
    /// Pressing forces of contacts whose squeeze may change, N.
    pub(super) presses: Vec<Option<f64>>,
}

impl<'q> Choice<'q> {
    /// The variables of a question, and their values in the given grasp. Refuses a contact that does not lie on its surface.
    pub(super) fn of(grasp: &'q Grasp<3>, question: &'q Improve<3>) -> Result<(Self, Placing), Error> {
        let contacts = grasp.contacts();
        let tangents: Vec<SVector<f64, 3>> =
            grasp.frames().map(|frame| frame.column(1).into_owned()).collect();
        let length = grasp.engine.length();
        let (mut variables, mut spots, mut presses) = (Vec::new(), Vec::new(), Vec::new());
        for (contact, at) in contacts.iter().enumerate() {
            let surface = question.surface_of(contact);
            let spot = surface.map(|surface| Spot::nearest(surface, &at.point, &at.normal));
            if let Some(spot) = &spot {
                let refused = |field, value, allowed| {
                    Err(Error::Surface { contact: at.label(contact), field, value, allowed })
                };
                let distance = (spot.point - at.point).norm();
                if distance > OFF_THE_SURFACE * (length + at.point.norm()) {
                    return refused(
                        "distance of its point from its surface",
                        distance,
                        "0 m: the point has to lie on it",
                    );
                }
                let aside = (at.normal.normalize() - spot.normal).norm();
                if aside > OFF_THE_SURFACE {
                    return refused("angle between its normal and that of its surface", aside, "0 rad");
                }
                for axis in 0..spot.along.len() {
                    variables.push(DesignVariable { contact, what: DesignKind::Along(axis), unit: length });
                }
            }
            spots.push(spot);
            let most = question.most_of(contact).filter(|_| at.hold != Hold::Bonded);
            let stiffness = at.series_stiffness_of_axes()[0];
            let given = |most: f64| (stiffness * (at.command[0] - at.clearance)).clamp(0.0, most);
            presses.push(most.map(given));
            if let Some(most) = most {
                variables.push(DesignVariable { contact, what: DesignKind::Press { most }, unit: most });
            }
        }
        let (settings, tangents_given) = (grasp.settings(), tangents.clone());
        let wholes = grasp.engine.wholes();
        let choice = Self { question, contacts, wholes, settings, tangents: tangents_given, variables };
        Ok((choice, Placing { spots, tangents, presses }))
    }

    /// Random places on all surfaces; every squeeze that may change has its greatest value.
    pub(super) fn random(&self, from: &Placing, draw: &mut Draw) -> Placing {
        let mut placing = from.clone();
        for (contact, surface) in &self.question.surfaces {
            let spot = placing.spots[*contact].as_ref().map(|spot| spot.random(&surface.0, draw));
            placing.tangents[*contact] = self.tangent(*contact, &self.tangents[*contact], spot.as_ref());
            placing.spots[*contact] = spot;
        }
        for (contact, press) in placing.presses.iter_mut().enumerate() {
            *press = self.question.most_of(contact).filter(|_| press.is_some());
        }
        placing
    }

    /// The placing with one contact moved to another spot.
    pub(super) fn with_spot(&self, from: &Placing, contact: usize, spot: Spot) -> Placing {
        let mut placing = from.clone();
        placing.tangents[contact] = self.tangent(contact, &from.tangents[contact], Some(&spot));
        placing.spots[contact] = Some(spot);
        placing
    }

    /// The placing after a step; each entry of `step` is relative to the unit of its variable.
    pub(super) fn stepped(&self, from: &Placing, step: &[f64]) -> Placing {
        let mut placing = from.clone();
        for (contact, surface) in &self.question.surfaces {
            let mut along = Vec::new();
            for (variable, step) in self.variables.iter().zip(step) {
                if variable.contact == *contact && matches!(variable.what, DesignKind::Along(_)) {
                    along.push(variable.unit * step);
                }
            }
            let spot = from.spots[*contact].as_ref().map(|spot| spot.stepped(&surface.0, &along));
            placing.tangents[*contact] = self.tangent(*contact, &from.tangents[*contact], spot.as_ref());
            placing.spots[*contact] = spot;
        }
        for (variable, step) in self.variables.iter().zip(step) {
            if let (DesignKind::Press { most }, Some(press)) =
                (variable.what, &mut placing.presses[variable.contact])
            {
                *press = (*press + variable.unit * step).clamp(0.0, most);
            }
        }
        placing
    }

    /// The first tangent of the contact frame at a place. Compared with the frame of the tangent `from`, this frame tilts with its normal and does
    /// not turn about it.
    fn tangent(&self, contact: usize, from: &SVector<f64, 3>, spot: Option<&Spot>) -> SVector<f64, 3> {
        let Some(normal) = spot.map(|spot| spot.normal) else { return *from };
        if self.contacts[contact].space == Space::Planar {
            let sign = clockwise(&self.contacts[contact].normal).dot(&self.tangents[contact]);
            return clockwise(&normal) * sign.signum();
        }
        let across = from - normal * normal.dot(from);
        if across.norm() > OFF_THE_SURFACE {
            return across.normalize();
        }
        let mut axis = SVector::<f64, 3>::zeros();
        axis[normal.iamin()] = 1.0;
        (axis - normal * normal.dot(&axis)).normalize()
    }

    /// The unit of forces: the greatest force that a contact may press with, 1 N if none may change.
    pub(super) fn unit_of_force(&self) -> f64 {
        let press = |variable: &DesignVariable| {
            if let DesignKind::Press { most } = variable.what { most } else { 0.0 }
        };
        let most = largest(&self.variables, &press);
        if most > 0.0 { most } else { 1.0 }
    }

    /// The contacts of the grasp with this placing.
    pub(super) fn contacts(&self, placing: &Placing) -> Vec<Contact<3>> {
        numbered(self.contacts.len(), &|i| {
            let mut contact = self.contacts[i].clone();
            if let Some(spot) = &placing.spots[i] {
                (contact.point, contact.normal) = (spot.point, spot.normal);
                contact.tangent = Some(placing.tangents[i]);
            }
            if let Some(press) = placing.presses[i] {
                contact.command[0] = contact.clearance + press / contact.series_stiffness_of_axes()[0];
            }
            contact
        })
    }
}
