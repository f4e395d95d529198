//! A grasp: the contacts that were given, checked, with what the arithmetic needs of them.

use nalgebra::{SMatrix, SVector};

use super::bodies::{PlacedBodies, refuse_sides};
use super::contact::Contact;
use super::hand::{Drive, HandPart, Linkage};
use super::remembered::Remembered;
use super::rotation::{assert_plane_or_space, of_the_object};
use super::site::Site;
use super::vacuum::Vacuum;
#[cfg(feature = "serde")]
use super::wrench::Wrench;
use crate::error::{Error, Field, LARGEST, MODERATE, is_moderate};
use crate::numerics::{Fixed, Size, cleared_for};
use crate::prelude::*;

/// A checked list of contacts in D coordinates: those of the object, 3 in the plane and 6 in space, and those of joints behind them.
#[derive(Debug, Clone)]
pub(crate) struct Engine<D: Size, const C: usize> {
    size: D,
    contacts: Vec<Contact<C>>,
    sites: Vec<Site<D, C>>,
    /// Centroid of the contact points: inside, moments and rotations are taken about it, so that a
    /// far away reference point costs no digits.
    pub(super) origin: SVector<f64, C>,
    /// Root mean square distance of the contact points from their centroid: inside, the unit of
    /// length of arms, so that rotations and translations have comparable size whatever the user's
    /// unit.
    pub(super) length: f64,
    /// The joints behind the contacts, if any.
    pub(super) linkage: Option<Box<Linkage<D, C>>>,
    /// What vacuums pull with beside the caller's loads, if there are any.
    pub(super) vacuum: Option<Box<Vacuum<D, C>>>,
    /// The factors of the elastic trial.
    trial: Remembered,
}

impl<const D: usize, const C: usize> Engine<Fixed<D>, C> {
    /// [`Grasp::new`](crate::ask::Grasp::new).
    pub(crate) fn new(contacts: Vec<Contact<C>>) -> Result<Self, Error> {
        const { assert_plane_or_space::<D, C>() };
        refuse_sides(&contacts)?;
        Self::of(Fixed, contacts, |_| true)
    }
}

impl<D: Size, const C: usize> Engine<D, C> {
    /// A grasp by contacts that joints move, in so many coordinates.
    pub(super) fn by_hand(size: D, contacts: Vec<Contact<C>>, linkage: Linkage<D, C>) -> Result<Self, Error> {
        let on_object =
            |i: usize| linkage.bodies.as_ref().map_or(1.0, |bodies| bodies.sign(i, bodies.object));
        let mut grasp = Self::of(size, contacts, |i| on_object(i) != 0.0)?;
        for (i, (site, motions)) in grasp.sites.iter_mut().zip(&linkage.motions).enumerate() {
            site.move_with(motions, &linkage.lengths, on_object(i));
        }
        grasp.sites.extend(linkage.drives.iter().map(|drive| drive.site(size)));
        grasp.linkage = Some(Box::new(linkage));
        grasp.vacuum = Vacuum::of(&grasp.contacts, &grasp.sites);
        Ok(grasp)
    }

    /// This grasp with other data of its contacts, at the same places, and with own springs of joints and tendons so many times as stiff.
    pub(crate) fn with_data(
        &self,
        contacts: Vec<Contact<C>>,
        stiffer: impl Fn(usize) -> f64,
    ) -> Result<Self, Error> {
        match &self.linkage {
            None => Self::of(self.size, contacts, |_| true),
            Some(linkage) => {
                let mut linkage = linkage.stiffened(stiffer);
                linkage.press_instead(&self.contacts, &contacts);
                Self::by_hand(self.size, contacts, linkage)
            }
        }
    }

    /// These bodies with other loads on them.
    pub(super) fn with_bodies(&self, bodies: PlacedBodies<C>) -> Self {
        let mut grasp = self.clone();
        if let Some(linkage) = &mut grasp.linkage {
            linkage.bodies = Some(Box::new(bodies));
        }
        grasp
    }

    /// Whether some drive pushes at rest, or a force is held, or a vacuum pulls, or a body has a weight.
    #[cfg(feature = "serde")]
    pub(crate) fn presses(&self) -> bool {
        let by_force = self.linkage().is_some_and(|linkage| linkage.held.iter().any(|force| *force != 0.0));
        let by_load =
            self.bodies().is_some_and(|bodies| bodies.loads.iter().any(|load| *load != Wrench::ZERO));
        by_force || by_load || self.vacuum().is_some() || self.drives().iter().any(|drive| drive[0] > 0.0)
    }

    /// [`Grasp::links`](crate::ask::Grasp::links).
    pub(crate) fn links(&self) -> &[[SVector<f64, C>; 2]] {
        self.linkage().map_or(&[], |linkage| &linkage.bones)
    }

    /// [`Grasp::joint_centres`](crate::ask::Grasp::joint_centres).
    pub(crate) fn joint_centres(&self) -> &[Option<SVector<f64, C>>] {
        self.linkage().map_or(&[], |linkage| &linkage.centres)
    }

    /// A grasp by contacts, about the middle of those that are meant.
    fn of(size: D, contacts: Vec<Contact<C>>, is_meant: impl Fn(usize) -> bool) -> Result<Self, Error> {
        if contacts.is_empty() {
            return Err(Error::EmptyGrasp);
        }
        for (index, contact) in contacts.iter().enumerate() {
            contact.check(index)?;
        }
        let contacts: Vec<_> = contacts.into_iter().map(Contact::resolved).collect();
        let meant = || contacts.iter().enumerate().filter(|(i, _)| is_meant(*i)).map(|(_, contact)| contact);
        let count = meant().count().max(1) as f64;
        let origin = meant().fold(SVector::zeros(), |sum, c| sum + c.point / count);
        let spread = meant().map(|c| (c.point - origin).norm_squared() / count).sum::<f64>().sqrt();
        // A single point has no size of its own; then any unit of length does.
        let length = if spread * LARGEST > 1.0 { spread } else { 1.0 };
        let site = |(index, contact)| Site::new(size, (contact, index), (&origin, length));
        let sites = contacts.iter().enumerate().map(site).collect::<Result<Vec<_>, Error>>()?;
        let (vacuum, trial) = (Vacuum::of(&contacts, &sites), Remembered::default());
        Ok(Self { size, contacts, sites, origin, length, linkage: None, vacuum, trial })
    }

    /// How many coordinates it has.
    #[inline]
    pub(crate) fn size(&self) -> D {
        self.size
    }

    /// [`Grasp::len`](crate::ask::Grasp::len).
    pub(crate) fn len(&self) -> usize {
        self.contacts.len()
    }

    /// [`Grasp::contacts`](crate::ask::Grasp::contacts).
    pub(crate) fn contacts(&self) -> &[Contact<C>] {
        &self.contacts
    }

    /// One of [`Grasp::frames`](crate::ask::Grasp::frames).
    pub(crate) fn frame(&self, contact: usize) -> &SMatrix<f64, C, C> {
        &self.sites[contact].frame
    }

    /// [`Grasp::with_commands`](crate::ask::Grasp::with_commands).
    pub(crate) fn with_commands(&self, commands: &[SVector<f64, C>]) -> Result<Self, Error> {
        self.check_commands(commands, "commands", Field::Command)?;
        let mut grasp = self.clone();
        for (contact, command) in grasp.contacts.iter_mut().zip(commands) {
            contact.command = *command;
        }
        Ok(grasp)
    }

    /// [`Grasp::with_joint_commands`](crate::ask::Grasp::with_joint_commands).
    pub(crate) fn with_joint_commands(&self, commands: &[f64]) -> Result<Self, Error> {
        self.check_joint_commands(commands, "joint commands")?;
        let mut grasp = self.clone();
        if let Some(linkage) = &mut grasp.linkage {
            linkage.commands.copy_from_slice(commands);
        }
        Ok(grasp)
    }

    /// [`Grasp::with_joint_torques`](crate::ask::Grasp::with_joint_torques).
    pub(crate) fn with_joint_torques(&self, torques: &[f64]) -> Result<Self, Error> {
        let what = "torques on joints";
        let expected = self.linkage().map_or(0, |linkage| linkage.joints.len());
        if torques.len() != expected {
            return Err(Error::JointCommands { what, given: torques.len(), expected });
        }
        if let Some(k) = torques.iter().position(|x| !is_moderate(*x)) {
            let (what, field) = (format!("{what}, number {k}"), "torque");
            return Err(Error::Hand { what, field, value: torques[k], allowed: MODERATE });
        }
        let mut grasp = self.clone();
        if let Some(linkage) = &mut grasp.linkage {
            for (k, torque) in torques.iter().enumerate() {
                let k = of_the_object::<C>() + k;
                linkage.pulled[k] = torque / linkage.lengths[k];
            }
        }
        Ok(grasp)
    }

    /// [`Grasp::with_friction`](crate::ask::Grasp::with_friction).
    pub(crate) fn with_friction(&self, friction: &dyn Fn(usize, f64) -> f64) -> Result<Self, Error> {
        let mut contacts = self.contacts.clone();
        for (i, contact) in contacts.iter_mut().enumerate() {
            contact.set_friction(friction(i, contact.friction));
        }
        self.with_data(contacts, |_| 1.0)
    }

    /// This grasp as if everything slid: with friction of sliding from the beginning.
    pub(crate) fn with_friction_of_sliding(&self) -> Result<Self, Error> {
        let mut contacts = self.contacts.clone();
        for contact in &mut contacts {
            contact.friction = contact.kinetic.take().unwrap_or(contact.friction);
        }
        self.with_data(contacts, |_| 1.0)
    }

    /// [`Grasp::squeezed`](crate::ask::Grasp::squeezed).
    pub(crate) fn squeezed(&self, factor: f64) -> Result<Self, Error> {
        if !is_moderate(factor) {
            return Err(Error::Argument { what: "factor of the squeeze", value: factor, allowed: MODERATE });
        }
        let mut grasp = self.clone();
        for contact in &mut grasp.contacts {
            contact.command *= factor;
            contact.force = contact.force.map(|force| force * factor);
            contact.suction *= factor;
        }
        grasp.vacuum = Vacuum::of(&grasp.contacts, &grasp.sites);
        if let Some(linkage) = &mut grasp.linkage {
            linkage.squeeze(factor);
        }
        Ok(grasp)
    }

    pub(crate) fn check_joint_commands(&self, commands: &[f64], what: &'static str) -> Result<(), Error> {
        let expected = self.joint_commands().len();
        if commands.len() != expected {
            return Err(Error::JointCommands { what, given: commands.len(), expected });
        }
        match commands.iter().position(|x| !is_moderate(*x)) {
            Some(k) => Err(Error::Hand {
                what: format!("{what}, number {k}"),
                field: "command",
                value: commands[k],
                allowed: MODERATE,
            }),
            None => Ok(()),
        }
    }

    /// [`Grasp::joint_commands`](crate::ask::Grasp::joint_commands).
    pub(crate) fn joint_commands(&self) -> &[f64] {
        self.linkage.as_ref().map_or(&[], |linkage| &linkage.commands)
    }

    /// [`Grasp::label_of`](crate::ask::Grasp::label_of).
    pub(crate) fn label_of(&self, part: HandPart) -> String {
        self.linkage.as_ref().map_or_else(String::new, |linkage| linkage.label(part).text())
    }

    /// For questions that know no joints.
    pub(crate) fn refuse_hands(&self, question: &'static str) -> Result<(), Error> {
        if self.linkage.is_some() { Err(Error::NotForHands { question }) } else { Ok(()) }
    }

    /// For questions that would have to tell of sliding contacts, and do not know that their friction is lower.
    pub(crate) fn refuse_kinetic(&self, question: &'static str) -> Result<(), Error> {
        match self.weaker_once_they_slide().next() {
            Some(i) => Err(Error::KineticFriction { question, contact: self.contacts[i].label(i) }),
            None => Ok(()),
        }
    }

    /// Contacts whose friction is lower once they slide.
    pub(crate) fn weaker_once_they_slide(&self) -> impl Iterator<Item = usize> {
        (0..self.len()).filter(|&i| self.sites()[i].kinetic.is_some())
    }

    /// Refuses questions that know no joints.
    ///
    /// # Errors
    /// [`Error::NotForHands`] for a hand, [`Error::NotForJoints`] where several bodies are held by one, or pressed by a given force.
    pub(crate) fn refuse_joints(&self, question: &'static str) -> Result<(), Error> {
        match &self.linkage {
            Some(linkage) if linkage.bodies.is_none() => Err(Error::NotForHands { question }),
            Some(linkage) if !linkage.drives.is_empty() || !linkage.joints.is_empty() => {
                Err(Error::NotForJoints { question })
            }
            _ => Ok(()),
        }
    }

    /// The drives of a joint or, behind the joints, of a tendon, with the numbers of their sites.
    pub(crate) fn drives_of(&self, actuator: usize) -> impl Iterator<Item = (usize, &Drive<D>)> {
        let first = self.len();
        self.linkage()
            .into_iter()
            .flat_map(move |linkage| linkage.of_actuator(actuator))
            .map(move |(k, drive)| (first + k, drive))
    }

    /// The joints behind the contacts, if any.
    pub(crate) fn linkage(&self) -> Option<&Linkage<D, C>> {
        self.linkage.as_deref()
    }

    pub(crate) fn check_commands(
        &self,
        commands: &[SVector<f64, C>],
        what: &'static str,
        field: Field,
    ) -> Result<(), Error> {
        if commands.len() != self.len() {
            return Err(Error::Size { what, given: commands.len(), expected: self.len() });
        }
        for (index, (contact, command)) in self.contacts.iter().zip(commands).enumerate() {
            if let Some(&value) = command.iter().find(|x| !is_moderate(**x)) {
                return Err(Error::Contact {
                    contact: contact.label(index),
                    field,
                    value,
                    allowed: MODERATE,
                });
            }
        }
        Ok(())
    }

    /// Where the factors of the elastic trial are kept.
    pub(crate) fn remembered_trial(&self) -> &Remembered {
        &self.trial
    }

    pub(crate) fn sites(&self) -> &[Site<D, C>] {
        &self.sites
    }

    /// What every site is driven by: a_i of the contacts, commands in the contact frames, the normal part less the clearance; then those of
    /// the drives of a hand.
    pub(crate) fn drives(&self) -> Vec<SVector<f64, C>> {
        let mut drives = Vec::new();
        self.drives_into(&mut drives);
        drives
    }

    /// [`Self::drives`] in memory that is there.
    pub(crate) fn drives_into(&self, drives: &mut Vec<SVector<f64, C>>) {
        self.driven_by(self.contacts.iter().map(|contact| contact.command), self.joint_commands(), drives);
    }

    /// The drives with other commands.
    pub(crate) fn driven_by(
        &self,
        commands: impl Iterator<Item = SVector<f64, C>>,
        of_joints: &[f64],
        drives: &mut Vec<SVector<f64, C>>,
    ) {
        cleared_for(drives, self.sites.len());
        drives.extend(commands.zip(&self.contacts).map(|(mut a, contact)| {
            a[0] -= contact.clearance;
            a
        }));
        if let Some(linkage) = self.linkage() {
            drives.extend(linkage.stretches(of_joints));
        }
    }

    /// What the drives change by with these changes of commands; without any they stay.
    pub(crate) fn drive_changes(
        &self,
        commands: Option<&[SVector<f64, C>]>,
        of_joints: Option<&[f64]>,
    ) -> Vec<SVector<f64, C>> {
        let mut changes = Vec::new();
        self.changed_by(commands.into_iter().flatten().copied(), of_joints, &mut changes);
        changes
    }

    /// [`Self::drive_changes`] in memory that is there; commands that are missing stay.
    pub(crate) fn changed_by(
        &self,
        commands: impl Iterator<Item = SVector<f64, C>>,
        of_joints: Option<&[f64]>,
        changes: &mut Vec<SVector<f64, C>>,
    ) {
        cleared_for(changes, self.sites.len());
        changes.extend(commands);
        changes.resize(self.len(), SVector::zeros());
        match (self.linkage(), of_joints) {
            (Some(linkage), Some(commands)) => changes.extend(linkage.changes(commands)),
            _ => changes.resize(self.sites.len(), SVector::zeros()),
        }
    }
}
