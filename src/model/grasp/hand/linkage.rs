//! Joints, tendons and drives of a hand as parts of a grasp, and the bodies of a grasp with several bodies. A drive is the spring of a joint or
//! tendon, with its force limit. A command is a prescribed displacement of a joint or tendon, which stretches this spring. In the engine's
//! coordinates moments and rotations refer to the centroid of the contacts.

use alloc::sync::Arc;
use core::fmt;

use nalgebra::SVector;

use super::drive::{Drive, DriveOwner};
use super::joint::{JointKind, Limit};
use crate::grasp::bodies::PlacedBodies;
use crate::grasp::contact::Contact;
use crate::numerics::{IntoList, Space, Square, Vector, chosen, picked};
use crate::prelude::*;
use crate::words::printable;

/// Joints, tendons and drives behind the contacts of a grasp, and the bodies of the grasp, in the engine's coordinates.
#[derive(Debug, Clone)]
pub(crate) struct Linkage {
    pub(crate) joints: Vec<NamedPart>,
    pub(crate) tendons: Vec<NamedPart>,
    /// Factors by which the displacements of joints and other bodies are multiplied, so that all coordinates are lengths: m per rad for a rotation,
    /// without unit for a translation. Entries of the object's coordinates are 1.
    pub(crate) lengths: Vector,
    /// For each contact the coordinates of joints and other bodies that move it, as pairs. A pair has the index of a coordinate, counted from the
    /// first one after the object's coordinates. It also has the displacement of the contact along x, y and z per unit of this coordinate.
    pub(crate) motions: Vec<Vec<(usize, SVector<f64, 3>)>>,
    /// The drives. The engine's list of sites holds all contacts, then these drives in the same order.
    pub(crate) drives: Vec<Drive>,
    /// Constant generalised forces on the coordinates: from joint torques, from tensions of tendons, and from contacts with a constant force.
    pub(crate) held_forces: Vector,
    /// External torques on the joints, in the engine's coordinates.
    pub(crate) external_torques: Vector,
    /// The bodies of a grasp that was made from named bodies; `None` for a single object without a name.
    pub(crate) bodies: Option<Box<PlacedBodies>>,
    /// Line segments from joint to joint and on to the contacts, for pictures only.
    pub(crate) bones: Vec<[SVector<f64, 3>; 2]>,
    /// The unit vector along the axis of each revolute joint; `None` for other joints.
    pub(crate) axes: Vec<Option<SVector<f64, 3>>>,
    /// A point on the axis of each revolute joint, `None` for other joints; for pictures only.
    pub(crate) centres: Vec<Option<SVector<f64, 3>>>,
    /// Commanded displacements of the joints (rad or m), then of the tendons (m).
    pub(crate) commands: Vec<f64>,
}

/// Name, limit and constant torque or tension of a joint or a tendon.
#[derive(Debug, Clone)]
pub(crate) struct NamedPart {
    pub(crate) name: Option<Arc<str>>,
    pub(crate) limit: Option<Limit>,
    /// Kind of the joint's motion; not used for a tendon.
    pub(crate) kind: JointKind,
    /// Constant torque on the joint, N m or N, or constant tension of the tendon, N.
    pub(crate) held_torque: f64,
    /// Generalised force on the coordinates of the grasp per unit of the joint's torque or the tendon's tension.
    pub(crate) along: Vector,
}

impl NamedPart {
    /// Multiplies the constant torque or tension by `factor`, and adds the change to the generalised forces `held_forces`.
    fn hold(&mut self, factor: f64, held_forces: &mut Vector) {
        *held_forces += &self.along * ((factor - 1.0) * self.held_torque);
        self.held_torque *= factor;
    }
}

/// A joint or a tendon of a hand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum HandPart {
    /// The joint with this index, from 0, finger by finger.
    Joint(usize),
    /// The tendon with this index, from 0.
    Tendon(usize),
}

impl fmt::Display for HandPart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Joint(joint) => write!(f, "joint {joint}"),
            Self::Tendon(tendon) => write!(f, "tendon {tendon}"),
        }
    }
}

/// Number and name of a joint or a tendon in answers.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PartLabel {
    /// The joint or tendon. Joints are numbered from 0 finger by finger. Each contact with a constant force has a prismatic joint of its own along
    /// its normal; these joints follow. Written as `"joint": 3`.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub part: HandPart,
    /// The user's name; omitted if there is none.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub name: Option<Arc<str>>,
}

impl PartLabel {
    /// The user's name, safe to print, or without one the kind and the number.
    #[must_use]
    pub fn text(&self) -> String {
        let name = self.name.as_deref().map(|name| printable(name).into_owned());
        name.unwrap_or_else(|| self.part.to_string())
    }
}

impl Linkage {
    /// Adds the geometric stiffness of the joints that move a contact, whose force F, N, acts on the object. Behind a revolute joint with the axis e, a
    /// displacement J of the contact per unit of a joint turns with the finger. The force on the finger is -F, so that the pair of both joints gets the
    /// stiffness `F·(e × J)`. `first` is the index of the first coordinate after the object's.
    pub(crate) fn add_geometric_stiffness(
        &self,
        (contact, force): (usize, &SVector<f64, 3>),
        first: usize,
        stiffness: &mut Square,
    ) {
        let joints =
            picked(&self.motions[contact], &|motion| (motion.0 < self.joints.len()).then_some(*motion));
        for (at, (inner, _)) in joints.iter().enumerate() {
            let Some(axis) = self.axes[*inner] else { continue };
            for (outer, moved) in &joints[at..] {
                let (i, j) = (first + inner, first + outer);
                let entry = force.dot(&axis.cross(moved)) / (self.lengths[i] * self.lengths[j]);
                stiffness[(i, j)] += entry;
                if i != j {
                    stiffness[(j, i)] += entry;
                }
            }
        }
    }

    /// Stretches of the springs of all drives under these commands of joints and tendons, m.
    pub(crate) fn stretches(&self, commands: &[f64]) -> impl Iterator<Item = SVector<f64, 3>> {
        self.drives.iter().map(move |drive| drive.stretch(commands))
    }

    /// Changes of the stretches of the springs of all drives, m, for a change of the commands of joints and tendons.
    pub(crate) fn changes(&self, commands: &[f64]) -> impl Iterator<Item = SVector<f64, 3>> {
        self.drives.iter().map(move |drive| drive.change(commands))
    }

    /// This linkage with the stiffnesses of the springs of joints and tendons multiplied by `times(index)`; tendons are numbered after the joints.
    pub(crate) fn stiffened(&self, times: &dyn Fn(usize) -> f64) -> Self {
        let mut linkage = self.clone();
        let joints = self.joints.len();
        for drive in &mut linkage.drives {
            match drive.owner {
                DriveOwner::Joint(joint) => drive.stiffen(times(joint)),
                DriveOwner::Tendon(tendon) => drive.stiffen(times(joints + tendon)),
                DriveOwner::Nobody => {}
            }
        }
        linkage
    }

    /// Multiplies the command and the constant torque or tension of the joint or tendon with index k by `times(k)`; tendons are numbered after the
    /// joints.
    pub(crate) fn squeeze(&mut self, times: &dyn Fn(usize) -> f64) {
        self.commands.iter_mut().enumerate().for_each(|(k, command)| *command *= times(k));
        for (k, part) in self.joints.iter_mut().chain(&mut self.tendons).enumerate() {
            part.hold(times(k), &mut self.held_forces);
        }
    }

    /// Multiplies the command and the constant torque or tension of the joint or tendon with this name by `factor`. Returns whether such a joint or
    /// tendon exists and has a nonzero command, torque or tension.
    pub(crate) fn scale_named(&mut self, name: &str, factor: f64) -> bool {
        let mut presses = false;
        for (part, command) in self.joints.iter_mut().chain(&mut self.tendons).zip(&mut self.commands) {
            if part.name.as_deref() == Some(name) && (*command != 0.0 || part.held_torque != 0.0) {
                *command *= factor;
                part.hold(factor, &mut self.held_forces);
                presses = true;
            }
        }
        presses
    }

    /// Names of the joints and tendons with a command, a constant torque or a constant tension; joints and tendons without a name are omitted.
    pub(crate) fn names_that_press(&self) -> Vec<String> {
        let parts = self.joints.iter().chain(&self.tendons).list();
        let presses = |k: &usize| self.commands[*k] != 0.0 || parts[*k].held_torque != 0.0;
        let pressing = chosen(parts.len().min(self.commands.len()), &presses);
        picked(&pressing, &|k| parts[*k].name.as_deref().map(str::to_owned))
    }

    /// Replaces the constant normal forces of the contacts `before` by the constant normal forces of the contacts `now`. Each of these forces acts
    /// on the slide of its contact, a joint along the normal.
    pub(crate) fn replace_pressing_forces(
        &mut self,
        space: Space,
        before: &[Contact<3>],
        now: &[Contact<3>],
    ) {
        for ((before, now), motions) in before.iter().zip(now).zip(&self.motions) {
            if let (Some(before), Some(now), Some((slide, _))) = (before.force, now.force, motions.first()) {
                let k = space.of_the_object() + slide;
                self.held_forces[k] += (now - before) / self.lengths[k];
                self.joints[*slide].held_torque += now - before;
            }
        }
    }

    pub(crate) fn label(&self, part: HandPart) -> PartLabel {
        let named = match part {
            HandPart::Joint(joint) => &self.joints[joint],
            HandPart::Tendon(tendon) => &self.tendons[tendon],
        };
        PartLabel { part, name: named.name.clone() }
    }

    /// The drives of a joint or tendon, with their indices in the list of drives. `actuator` is the index of the joint or tendon, from 0: joints
    /// first, then tendons.
    pub(crate) fn of_actuator(&self, actuator: usize) -> impl Iterator<Item = (usize, &Drive)> {
        let joints = self.joints.len();
        let owner = if actuator < joints {
            DriveOwner::Joint(actuator)
        } else {
            DriveOwner::Tendon(actuator - joints)
        };
        self.drives.iter().enumerate().filter(move |(_, drive)| drive.owner == owner)
    }

    /// The joint or tendon to which the drive with this index belongs; `None` for a spring of a stiffness or compliance matrix.
    pub(crate) fn part(&self, drive: usize) -> Option<HandPart> {
        match self.drives[drive].owner {
            DriveOwner::Joint(joint) => Some(HandPart::Joint(joint)),
            DriveOwner::Tendon(tendon) => Some(HandPart::Tendon(tendon)),
            DriveOwner::Nobody => None,
        }
    }
}
