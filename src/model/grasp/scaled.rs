//! Parts of a grasp whose forces can be scaled (bodies by their loads; contacts, joints and tendons by their commands), and copies of the grasp with
//! one such force scaled. A command is a prescribed displacement of a finger, joint or tendon.

use super::engine::Engine;
use super::hand::Linkage;
use super::whole_contact::ContactPoints;
use super::wrench::Wrench;
use crate::error::{Error, MODERATE, is_moderate};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{any_index, chosen, mapped};
use crate::prelude::*;
use crate::words::{listed, printable};

/// A part whose force on the grasp can be scaled: a body by its load, or a contact, a cable or a joint by its command.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PressOfPart {
    pub(crate) name: String,
    pub(crate) is_body: bool,
    /// Whether the part is a contact that presses by a command alone, without a given force, tension or vacuum.
    pub(crate) is_command: bool,
    /// Magnitude of the force or moment that the part exerts, with the unit; `None` if no single number describes it.
    pub(crate) size: Option<(f64, &'static str)>,
}

impl Engine {
    /// Whether this contact point has a nonzero command, constant force or vacuum.
    pub(crate) fn is_commanded(&self, point: usize) -> bool {
        let contact = &self.contacts[point];
        contact.command.amax() > 0.0 || contact.force.unwrap_or(0.0) != 0.0 || contact.suction != 0.0
    }

    /// Whether the joint or tendon with this index, tendons after joints, has a nonzero command, constant torque or constant tension. Slides, the
    /// joints that are added for contacts with a constant force, do not count.
    pub(crate) fn is_driven(&self, part: usize) -> bool {
        self.linkage().is_some_and(|linkage| {
            let mut slides = self.contacts.iter().zip(&linkage.motions).filter(|(contact, motions)| {
                contact.force.is_some() && motions.first().is_some_and(|(slide, _)| *slide == part)
            });
            let named = linkage.joints.iter().chain(&linkage.tendons).nth(part);
            let is_held = named.is_some_and(|named| named.held_torque != 0.0);
            linkage.commands[part] != 0.0 || is_held && slides.next().is_none()
        })
    }

    /// Whether some joint or tendon has a nonzero command, constant torque or constant tension. Slides do not count.
    pub(crate) fn is_hand_driven(&self) -> bool {
        any_index(self.joint_commands().len(), &|part| self.is_driven(part))
    }

    /// Whether the grasp has a squeeze: a nonzero command, constant force or torque, or vacuum.
    pub(crate) fn is_squeezed(&self) -> bool {
        self.is_hand_driven() || any_index(self.len(), &|point| self.is_commanded(point))
    }

    /// Whether contacts overlap by more than rounding: clearances below zero, as in a press fit.
    pub(crate) fn overlaps(&self) -> bool {
        self.contacts.iter().any(|contact| contact.clearance < -NEGLIGIBLE * self.length())
    }

    /// A copy of this grasp with all clearances below zero multiplied by `factor`.
    pub(crate) fn with_overlaps(&self, factor: f64) -> Result<Self, Error> {
        let mut contacts = self.contacts.clone();
        for contact in contacts.iter_mut().filter(|contact| contact.clearance < 0.0) {
            contact.clearance *= factor;
        }
        self.with_data(contacts, &|_| [1.0; 2])
    }

    /// Whether the grasp carries twice the load with twice the squeeze, i.e. if all commands, constant forces and vacuums are doubled. This is so
    /// without constant loads of bodies, external torques, clearances and joint limits. `false` for any grasp with tendons.
    pub(crate) fn is_proportional(&self) -> bool {
        let stays = self.linkage().is_some_and(|linkage| {
            let loads = linkage.bodies.as_ref().map_or(&[][..], |bodies| &bodies.loads);
            loads.iter().any(|load| *load != Wrench::ZERO)
                || linkage.external_torques.norm() > 0.0
                || !linkage.tendons.is_empty()
                || linkage.joints.iter().any(|joint| joint.limit.is_some())
        });
        !stays && self.contacts.iter().all(|contact| contact.clearance == 0.0)
    }

    /// Names of the bodies to which the user gave a nonzero load; weights do not count.
    pub(crate) fn loaded_bodies(&self) -> Vec<String> {
        let Some(bodies) = self.bodies() else { return Vec::new() };
        let loaded = chosen(bodies.names.len(), &|body| bodies.user_loads[*body] != Wrench::ZERO);
        mapped(&loaded, &|body| bodies.names[*body].to_string())
    }

    /// Looks up the part with this name, and returns it with a copy of the grasp in which its load or command is multiplied by `factor`. For a body
    /// the factor multiplies its load, but not its weight. For a contact or a link it multiplies command, force and vacuum. For a joint or a tendon
    /// it multiplies command and constant torque or tension.
    ///
    /// # Errors
    /// [`Error::Part`] if no part has this name, or its load or command is zero; [`Error::Argument`] if the factor is out of range.
    pub(crate) fn scaled(&self, name: &str, factor: f64) -> Result<(PressOfPart, Self), Error> {
        if !is_moderate(factor) {
            return Err(Error::Argument { what: "factor of a force", value: factor, allowed: MODERATE });
        }
        let of = |is_body, is_command, size| PressOfPart { name: name.to_owned(), is_body, is_command, size };
        if let Some(bodies) = self.bodies()
            && let Some(body) = bodies.names.iter().position(|other| **other == *name)
            && bodies.user_loads[body] != Wrench::ZERO
        {
            let given = bodies.user_loads[body];
            let mut bodies = bodies.clone();
            bodies.loads[body] = bodies.loads[body] + given * (factor - 1.0);
            bodies.user_loads[body] = given * factor;
            return Ok((of(true, false, given.measure()), self.with_bodies(bodies)));
        }
        let parts = self.wholes();
        if let Some(part) = parts.iter().find(|part| part.text() == *name) {
            let mut contacts = self.contacts.clone();
            let (mut size, mut presses, mut is_command) = (Some(0.0), false, true);
            for contact in &mut contacts[part.range.clone()] {
                let force = contact
                    .at_rest
                    .or(contact.force)
                    .unwrap_or(contact.suction + contact.stiffness.series()[0] * contact.command[0]);
                let is_given = contact.link.is_some() || contact.at_rest.or(contact.force).is_some();
                is_command &= !is_given && contact.suction == 0.0;
                presses |= contact.command.amax() > 0.0 || force != 0.0;
                size = size.filter(|_| contact.clearance == 0.0).map(|sum| sum + force);
                contact.squeeze(factor);
            }
            if presses {
                return Ok((
                    of(false, is_command, size.map(|size: f64| (size.abs(), "N"))),
                    self.with_data(contacts, &|_| [1.0; 2])?,
                ));
            }
        }
        let mut grasp = self.clone();
        if grasp.linkage.as_mut().is_some_and(|linkage| linkage.scale_named(name, factor)) {
            let tendon = self.linkage().and_then(|linkage| {
                linkage.tendons.iter().find(|tendon| tendon.name.as_deref() == Some(name))
            });
            let tension = tendon
                .filter(|tendon| tendon.held_torque != 0.0)
                .map(|tendon| (tendon.held_torque.abs(), "N"));
            return Ok((of(false, false, tension), grasp));
        }
        let mut pressing = self.loaded_bodies();
        let is_commanded = |part: &&ContactPoints| {
            part.range.clone().any(|point| self.is_commanded(point) || self.contacts[point].at_rest.is_some())
        };
        pressing.extend(parts.iter().filter(is_commanded).map(ContactPoints::text));
        pressing.extend(self.linkage().map_or_else(Vec::new, Linkage::names_that_press));
        let all: Vec<_> = mapped(&pressing, &|name| printable(name));
        let allowed = if all.is_empty() { String::new() } else { listed(&all) };
        Err(Error::Part { name: name.to_owned(), allowed })
    }
}
