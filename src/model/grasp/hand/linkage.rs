//! The hand behind a grasp.

use alloc::sync::Arc;
use core::fmt;

use nalgebra::SVector;

use super::drive::{Drive, Owner};
use super::joint::{JointKind, Limit};
use crate::grasp::bodies::PlacedBodies;
use crate::grasp::contact::Contact;
use crate::numerics::Space;
use crate::numerics::Vector;
use crate::prelude::*;
use crate::words::printable;

/// Joints, tendons, drives and bodies behind a grasp, in inside coordinates.
#[derive(Debug, Clone)]
pub(crate) struct Linkage {
    pub(crate) joints: Vec<Named>,
    pub(crate) tendons: Vec<Named>,
    /// Factors that make lengths of the coordinates behind the object's; those of the object are 1.
    pub(crate) lengths: Vector,
    /// Motion of each contact along the coordinate axes, per unit of each coordinate behind the object's.
    pub(crate) motions: Vec<Vec<(usize, SVector<f64, 3>)>>,
    /// Drives, one for each site beyond the contacts.
    pub(crate) drives: Vec<Drive>,
    /// Constant forces on the coordinates, from torques, tensions and held contacts.
    pub(crate) held: Vector,
    /// External torques on the joints.
    pub(crate) pulled: Vector,
    /// The bodies, if there are several.
    pub(crate) bodies: Option<Box<PlacedBodies>>,
    /// Line segments from joint to joint and on to the contacts, for pictures only.
    pub(crate) bones: Vec<[SVector<f64, 3>; 2]>,
    /// Points on the axes of revolute joints, for pictures only.
    pub(crate) centres: Vec<Option<SVector<f64, 3>>>,
    /// Commands of joints, then of tendons.
    pub(crate) commands: Vec<f64>,
}

/// Data of a joint or a tendon for answers.
#[derive(Debug, Clone)]
pub(crate) struct Named {
    pub(crate) name: Option<Arc<str>>,
    pub(crate) limit: Option<Limit>,
    /// Kind of motion of a joint.
    pub(crate) kind: JointKind,
    /// The constant torque or tension.
    pub(crate) held: f64,
}

/// A joint or a tendon of a hand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum HandPart {
    /// A joint, from 0, finger by finger.
    Joint(usize),
    /// A tendon, from 0.
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
    /// The part: joints are numbered from 0 finger by finger, then come slides of contacts that are held by a force. Written as `"joint": 3`.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub part: HandPart,
    /// The user's name for it; omitted if it has none.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub name: Option<Arc<str>>,
}

impl PartLabel {
    /// Its name in messages and pictures, or its kind and its number.
    #[must_use]
    pub fn text(&self) -> String {
        let name = self.name.as_deref().map(|name| printable(name).into_owned());
        name.unwrap_or_else(|| self.part.to_string())
    }
}

impl Linkage {
    /// Stretches of the sites of all drives under these commands.
    pub(crate) fn stretches(&self, commands: &[f64]) -> impl Iterator<Item = SVector<f64, 3>> {
        self.drives.iter().map(move |drive| drive.stretch(commands))
    }

    /// Changes of these stretches for a change of commands.
    pub(crate) fn changes(&self, commands: &[f64]) -> impl Iterator<Item = SVector<f64, 3>> {
        self.drives.iter().map(move |drive| drive.change(commands))
    }

    /// This linkage with own springs multiplied by `times(number)`, of joints and then tendons.
    pub(crate) fn stiffened(&self, times: &dyn Fn(usize) -> f64) -> Self {
        let mut linkage = self.clone();
        let joints = self.joints.len();
        for drive in &mut linkage.drives {
            match drive.owner {
                Owner::Joint(joint) => drive.stiffen(times(joint)),
                Owner::Tendon(tendon) => drive.stiffen(times(joints + tendon)),
                Owner::Nobody => {}
            }
        }
        linkage
    }

    /// Multiplies commands, and torques that hold joints, by `factor`.
    pub(crate) fn squeeze(&mut self, space: Space, factor: f64) {
        self.commands.iter_mut().for_each(|command| *command *= factor);
        (0..self.joints.len()).for_each(|joint| self.hold_joint(space, joint, factor));
    }

    /// With the torque that holds a joint so many times as large.
    pub(crate) fn hold_joint(&mut self, space: Space, joint: usize, factor: f64) {
        let (k, joint) = (space.of_the_object() + joint, &mut self.joints[joint]);
        self.held[k] += (factor - 1.0) * (joint.held / self.lengths[k]);
        joint.held *= factor;
    }

    /// Replaces the forces that hold contacts by those of `now`.
    pub(crate) fn press_instead(&mut self, space: Space, before: &[Contact<3>], now: &[Contact<3>]) {
        for ((before, now), motions) in before.iter().zip(now).zip(&self.motions) {
            if let (Some(before), Some(now), Some((slide, _))) = (before.force, now.force, motions.first()) {
                let k = space.of_the_object() + slide;
                self.held[k] += (now - before) / self.lengths[k];
                self.joints[*slide].held += now - before;
            }
        }
    }

    /// A joint or a tendon with its name.
    pub(crate) fn label(&self, part: HandPart) -> PartLabel {
        let named = match part {
            HandPart::Joint(joint) => &self.joints[joint],
            HandPart::Tendon(tendon) => &self.tendons[tendon],
        };
        PartLabel { part, name: named.name.clone() }
    }

    /// Drives of an actuator: a joint or, numbered behind the joints, a tendon.
    pub(crate) fn of_actuator(&self, actuator: usize) -> impl Iterator<Item = (usize, &Drive)> {
        let joints = self.joints.len();
        let owner = if actuator < joints { Owner::Joint(actuator) } else { Owner::Tendon(actuator - joints) };
        self.drives.iter().enumerate().filter(move |(_, drive)| drive.owner == owner)
    }

    /// The joint or tendon that owns the drive, if any.
    pub(crate) fn part(&self, drive: usize) -> Option<HandPart> {
        match self.drives[drive].owner {
            Owner::Joint(joint) => Some(HandPart::Joint(joint)),
            Owner::Tendon(tendon) => Some(HandPart::Tendon(tendon)),
            Owner::Nobody => None,
        }
    }
}
