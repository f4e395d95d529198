//! Commands and torques of a grasp, and copies of the grasp with other commands or torques. A drive is the spring of a joint or tendon of a hand,
//! with its force limit; the engine treats it like a contact. The offset of a contact is its commanded displacement less the clearance; the offset of
//! a drive is the stretch of its spring if nothing has moved.

use alloc::borrow::Cow;

use nalgebra::SVector;

use super::engine::Engine;
use super::vacuum::Vacuum;
use crate::error::{Error, Field, MODERATE, is_moderate};
use crate::numerics::{IntoList, cleared_for, mapped};
use crate::prelude::*;

impl Engine {
    /// A copy of this grasp with other commanded displacements of all contacts, m, in the contact frames; see
    /// [`Grasp::with_commands`](crate::ask::Grasp::with_commands).
    pub(crate) fn with_commands(&self, commands: &[SVector<f64, 3>]) -> Result<Self, Error> {
        self.check_commands(commands, "commands", Field::Command)?;
        let mut grasp = self.clone();
        for (contact, command) in grasp.contacts.iter_mut().zip(commands) {
            contact.command = *command;
        }
        Ok(grasp)
    }

    /// A copy of this grasp with other commanded displacements of the joints (rad or m), then of the tendons (m); see
    /// [`Grasp::with_joint_commands`](crate::ask::Grasp::with_joint_commands).
    pub(crate) fn with_joint_commands(&self, commands: &[f64]) -> Result<Self, Error> {
        self.check_joint_commands(commands, "joint commands")?;
        let mut grasp = self.clone();
        if let Some(linkage) = &mut grasp.linkage {
            linkage.commands.copy_from_slice(commands);
        }
        Ok(grasp)
    }

    /// A copy of this grasp with these external torques on the joints: N m, or a force in N on a prismatic joint; see
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
                let k = self.space.of_the_object() + k;
                linkage.external_torques[k] = torque / linkage.lengths[k];
            }
        }
        Ok(grasp)
    }

    /// The constant torque on each joint, in addition to the torque of its spring: N m, or a force in N on a prismatic joint.
    pub(crate) fn held_torques(&self) -> Vec<f64> {
        self.linkage().map_or_else(Vec::new, |linkage| mapped(&linkage.joints, &|joint| joint.held_torque))
    }

    /// A copy of the grasp with other constant torques on the joints, one per joint: N m, or a force in N on a prismatic joint.
    pub(crate) fn with_held_torques(&self, torques: &[f64]) -> Self {
        let mut grasp = self.clone();
        if let Some(linkage) = &mut grasp.linkage {
            for (j, torque) in torques.iter().enumerate() {
                let k = self.space.of_the_object() + j;
                linkage.held_forces[k] += (torque - linkage.joints[j].held_torque) / linkage.lengths[k];
                linkage.joints[j].held_torque = *torque;
            }
        }
        grasp
    }

    /// A copy of this grasp in which the squeeze, all by which contacts press without a load, is multiplied by `factor`: commands, constant forces
    /// and torques, tensions, vacuums. See [`Grasp::squeezed`](crate::ask::Grasp::squeezed).
    pub(crate) fn squeezed(&self, factor: f64) -> Result<Self, Error> {
        if !is_moderate(factor) {
            return Err(Error::Argument { what: "factor of the squeeze", value: factor, allowed: MODERATE });
        }
        let mut grasp = self.clone();
        grasp.contacts.iter_mut().for_each(|contact| contact.squeeze(factor));
        grasp.vacuum = Vacuum::of(grasp.space, &grasp.contacts, &grasp.sites);
        if let Some(linkage) = &mut grasp.linkage {
            linkage.squeeze(&|_| factor);
        }
        Ok(grasp)
    }

    /// Commands of all contact points. The list `rows` has one command for each point, or one for each contact that is not a link. In the second case
    /// all points of a soft fingertip get the command of the fingertip. A point that belongs to a link then gets `links(i)`, where i is the index of
    /// the point among all points.
    ///
    /// # Errors
    /// [`Error::Size`] for another number of commands; [`Error::Contact`] for a number that is not finite.
    pub(crate) fn commands_of_points<'c>(
        &self,
        rows: &'c [SVector<f64, 3>],
        links: &dyn Fn(usize) -> SVector<f64, 3>,
        what: &'static str,
    ) -> Result<Cow<'c, [SVector<f64, 3>]>, Error> {
        let mut all = Cow::Borrowed(rows);
        if rows.len() != self.len() {
            let (mut points, mut count) = (Vec::with_capacity(self.len()), 0);
            for contact in self.wholes().iter() {
                let is_link = contact.label.link.is_some();
                let row = rows.get(count).copied().unwrap_or_default();
                contact.range.clone().map(|i| if is_link { links(i) } else { row }).append_to(&mut points);
                count += usize::from(!is_link);
            }
            if rows.len() != count {
                return Err(Error::Size { what, given: rows.len(), expected: count });
            }
            all = Cow::Owned(points);
        }
        self.check_commands(&all, what, Field::CommandChange)?;
        Ok(all)
    }

    pub(crate) fn check_commands(
        &self,
        commands: &[SVector<f64, 3>],
        what: &'static str,
        field: Field,
    ) -> Result<(), Error> {
        if commands.len() != self.len() {
            return Err(Error::Size { what, given: commands.len(), expected: self.len() });
        }
        for (index, (contact, command)) in self.contacts.iter().zip(commands).enumerate() {
            if let Some(&value) = command.as_slice().iter().find(|x| !is_moderate(**x)) {
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

    /// Commanded displacements of the joints (rad or m), then of the tendons (m); empty without a hand.
    pub(crate) fn joint_commands(&self) -> &[f64] {
        self.linkage.as_ref().map_or(&[], |linkage| &linkage.commands)
    }

    /// Offsets of all contacts, then of the drives, m, in their contact frames. The offset a_i of a contact is its command, less the clearance along
    /// the normal.
    pub(crate) fn offsets(&self) -> Vec<SVector<f64, 3>> {
        let mut offsets = Vec::new();
        self.offsets_into(&mut offsets);
        offsets
    }

    /// Writes the offsets of all contacts, then of the drives, m, to the list `offsets`, whose storage is used again.
    pub(crate) fn offsets_into(&self, offsets: &mut Vec<SVector<f64, 3>>) {
        self.offsets_under(
            self.contacts.iter().map(|contact| contact.command),
            self.joint_commands(),
            offsets,
        );
    }

    /// Writes the offsets of all contacts and drives, m, under the given commands to the list `offsets`. The commands may differ from those of the
    /// grasp.
    pub(crate) fn offsets_under(
        &self,
        commands: impl Iterator<Item = SVector<f64, 3>>,
        of_joints: &[f64],
        offsets: &mut Vec<SVector<f64, 3>>,
    ) {
        cleared_for(offsets, self.sites.len());
        for (mut offset, contact) in commands.zip(&self.contacts) {
            offset[0] -= contact.clearance;
            offsets.push(offset);
        }
        if let Some(linkage) = self.linkage() {
            linkage.stretches(of_joints).append_to(offsets);
        }
    }

    /// Changes of the offsets of all contacts and drives, m, for given changes of the commands of contacts and of joints and tendons. `None` in place
    /// of a list means that these commands do not change.
    pub(crate) fn offset_changes(
        &self,
        commands: Option<&[SVector<f64, 3>]>,
        of_joints: Option<&[f64]>,
    ) -> Vec<SVector<f64, 3>> {
        let mut changes = Vec::new();
        self.changed_by(commands.unwrap_or_default().iter().copied(), of_joints, &mut changes);
        changes
    }

    /// Writes the changes of the offsets of all contacts and drives, m, to the list `changes`, whose storage is used again. `commands` and
    /// `of_joints` are changes of commands. Contacts after the end of `commands` have a change of zero.
    pub(crate) fn changed_by(
        &self,
        commands: impl Iterator<Item = SVector<f64, 3>>,
        of_joints: Option<&[f64]>,
        changes: &mut Vec<SVector<f64, 3>>,
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
