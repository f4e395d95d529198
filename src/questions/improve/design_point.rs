//! The variables of the search for better finger placement (question [`Improve`]), their values, and the grasp with these values. The variables are
//! places (positions of contacts on their curves or surfaces) and commanded normal forces. The latter are those that commands cause with the object
//! held in place; a command is the displacement that a finger would make if there were no object. A [`DesignPoint`] is one choice of all variables.
//! At rest means before the loads of the question grow. A surface consists of triangles, a curve of segments.

use nalgebra::SVector;

use super::places::clockwise;
use super::question::Improve;
use super::surface_location::SurfaceLocation;
use super::tolerances::OFF_THE_SURFACE;
use crate::ask::Grasp;
use crate::equilibrium::Settings;
use crate::error::Error;
use crate::grasp::{Contact, Hold, Space, WholeContacts};
use crate::numerics::{Draw, IntoList, chosen, largest, numbered};
use crate::prelude::*;

/// One variable of the search: the place of a contact along one direction, or its commanded normal force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct DesignVariable {
    pub(super) contact: usize,
    pub(super) what: DesignKind,
    /// The unit of the variable, m or N. The search divides each variable by its unit, so that steps of all variables have similar magnitude.
    pub(super) unit: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum DesignKind {
    /// The position of the contact along one of the tangent directions of its surface, given by the index of the direction.
    Along(usize),
    /// The normal force that the command of the contact causes with the object held in place, from 0 to `most`, N.
    Press { most: f64 },
}

/// The variables of the search, and the data of the given grasp and the question that stay fixed.
#[derive(Debug)]
pub(super) struct DesignSpace<'q> {
    pub(super) question: &'q Improve<3>,
    pub(super) contacts: &'q [Contact<3>],
    /// The contacts of the given grasp, each with its points; a soft fingertip has several points.
    pub(super) wholes: &'q WholeContacts,
    pub(super) settings: &'q Settings,
    /// For each contact the first tangent of its frame in the given grasp.
    tangents: Vec<SVector<f64, 3>>,
    pub(super) variables: Vec<DesignVariable>,
}

/// Values of all variables: the place of each contact that may move, and the normal force of each command that may change.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct DesignPoint {
    pub(super) spots: Vec<Option<SurfaceLocation>>,
    /// For each contact the first tangent of its frame, a unit vector.
    pub(super) tangents: Vec<SVector<f64, 3>>,
    /// For each contact the normal force that its command causes with the object held in place, N; `None` if the command may not change.
    pub(super) presses: Vec<Option<f64>>,
    /// For each contact whether it is idle: at rest it is open or touches without force, and it stays so until a load pushes it. Its command keeps
    /// its value.
    pub(super) idle: Vec<bool>,
}

impl DesignPoint {
    /// This design point with the contacts in `idle` idle: they are open or without force until a load pushes them, and their commands do not vary.
    pub(super) fn with_idle(&self, idle: &[bool]) -> Self {
        let mut design_point = self.clone();
        for contact in chosen(idle.len(), &|contact| idle[*contact]) {
            design_point.presses[contact] = None;
        }
        design_point.idle = idle.to_vec();
        design_point
    }
}

impl<'q> DesignSpace<'q> {
    /// The variables of a question, and their values in the given grasp. Returns an error for a contact that does not lie on its surface, or whose
    /// normal differs from the normal of the surface.
    pub(super) fn of(grasp: &'q Grasp<3>, question: &'q Improve<3>) -> Result<(Self, DesignPoint), Error> {
        let contacts = grasp.contacts();
        let tangents: Vec<SVector<f64, 3>> = grasp.frames().map(|frame| frame.column(1).into_owned()).list();
        let length = grasp.engine.length();
        let (mut variables, mut spots, mut presses) = (Vec::new(), Vec::new(), Vec::new());
        for (contact, at) in contacts.iter().enumerate() {
            let surface = question.surface_of(contact);
            let location = surface.map(|surface| SurfaceLocation::nearest(surface, &at.point, &at.normal));
            if let Some(location) = &location {
                let refused = |field, value, allowed| {
                    Err(Error::Surface { contact: at.label(contact), field, value, allowed })
                };
                let distance = (location.point - at.point).norm();
                if distance > OFF_THE_SURFACE * (length + at.point.norm()) {
                    return refused(
                        "distance of its point from its surface",
                        distance,
                        "0 m: the point has to lie on it",
                    );
                }
                let aside = (at.normal.normalize() - location.normal).norm();
                if aside > OFF_THE_SURFACE {
                    return refused("angle between its normal and that of its surface", aside, "0 rad");
                }
                for axis in 0..location.along.len() {
                    variables.push(DesignVariable { contact, what: DesignKind::Along(axis), unit: length });
                }
            }
            spots.push(location);
            let most = question.most_of(contact).filter(|_| at.hold != Hold::Bonded);
            let stiffness = at.series_stiffness_of_axes()[0];
            let given = |most: f64| (stiffness * (at.command[0] - at.clearance)).clamp(0.0, most);
            presses.push(most.map(given));
            if let Some(most) = most {
                variables.push(DesignVariable { contact, what: DesignKind::Press { most }, unit: most });
            }
        }
        let (settings, tangents_given) = (grasp.settings(), tangents.clone());
        let (wholes, idle) = (grasp.engine.wholes(), vec![false; contacts.len()]);
        let design_space = Self { question, contacts, wholes, settings, tangents: tangents_given, variables };
        Ok((design_space, DesignPoint { spots, tangents, presses, idle }))
    }

    /// A design point with random places on all surfaces and the greatest allowed commanded normal forces.
    pub(super) fn random(&self, from: &DesignPoint, draw: &mut Draw) -> DesignPoint {
        let mut design_point = from.clone();
        for (contact, surface) in &self.question.surfaces {
            let location =
                design_point.spots[*contact].as_ref().map(|location| location.random(&surface.0, draw));
            design_point.tangents[*contact] =
                self.tangent(*contact, &self.tangents[*contact], location.as_ref());
            design_point.spots[*contact] = location;
        }
        for (contact, press) in design_point.presses.iter_mut().enumerate() {
            *press = self.question.most_of(contact).filter(|_| press.is_some());
        }
        design_point
    }

    /// The design point `from` with one contact moved to the place `location` of its surface.
    pub(super) fn with_location(
        &self,
        from: &DesignPoint,
        contact: usize,
        location: SurfaceLocation,
    ) -> DesignPoint {
        let mut design_point = from.clone();
        design_point.tangents[contact] = self.tangent(contact, &from.tangents[contact], Some(&location));
        design_point.spots[contact] = Some(location);
        design_point
    }

    /// The design point after a step; each entry of `step` is the change of a variable divided by its unit. Each contact stays on its segment or
    /// triangle of the surface, and each commanded normal force within its limits.
    pub(super) fn stepped(&self, from: &DesignPoint, step: &[f64]) -> DesignPoint {
        let mut design_point = from.clone();
        for (contact, surface) in &self.question.surfaces {
            let mut along = Vec::new();
            for (variable, step) in self.variables.iter().zip(step) {
                if variable.contact == *contact && matches!(variable.what, DesignKind::Along(_)) {
                    along.push(variable.unit * step);
                }
            }
            let location = from.spots[*contact].as_ref().map(|location| location.stepped(&surface.0, &along));
            design_point.tangents[*contact] =
                self.tangent(*contact, &from.tangents[*contact], location.as_ref());
            design_point.spots[*contact] = location;
        }
        for (variable, step) in self.variables.iter().zip(step) {
            if let (DesignKind::Press { most }, Some(press)) =
                (variable.what, &mut design_point.presses[variable.contact])
            {
                *press = (*press + variable.unit * step).clamp(0.0, most);
            }
        }
        design_point
    }

    /// The first tangent of the contact frame at the place `location`. It is the tangent `from`, projected on the tangent plane of the new place, so
    /// that the frame does not turn about the normal. For a contact without a surface it is `from` itself.
    fn tangent(
        &self,
        contact: usize,
        from: &SVector<f64, 3>,
        location: Option<&SurfaceLocation>,
    ) -> SVector<f64, 3> {
        let Some(normal) = location.map(|location| location.normal) else { return *from };
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

    /// The unit of forces, N: the largest of the greatest allowed normal forces of commands, or 1 N if no command may change.
    pub(super) fn unit_of_force(&self) -> f64 {
        let press = |variable: &DesignVariable| {
            if let DesignKind::Press { most } = variable.what { most } else { 0.0 }
        };
        let most = largest(&self.variables, &press);
        if most > 0.0 { most } else { 1.0 }
    }

    /// The contacts of the given grasp with the places and commanded normal forces of this design point.
    pub(super) fn contacts(&self, design_point: &DesignPoint) -> Vec<Contact<3>> {
        numbered(self.contacts.len(), &|i| {
            let mut contact = self.contacts[i].clone();
            if let Some(location) = &design_point.spots[i] {
                (contact.point, contact.normal) = (location.point, location.normal);
                contact.tangent = Some(design_point.tangents[i]);
            }
            if let Some(press) = design_point.presses[i] {
                contact.command[0] = contact.clearance + press / contact.series_stiffness_of_axes()[0];
            }
            contact
        })
    }
}
