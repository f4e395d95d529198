//! What a grasp knows of the hand that holds it.

use alloc::sync::Arc;
use core::fmt;

use nalgebra::SVector;

use super::drive::{Drive, Owner};
use super::joint::{JointKind, Limit};
use crate::grasp::bodies::PlacedBodies;
use crate::grasp::contact::Contact;
use crate::grasp::rotation::of_the_object;
use crate::numerics::{Size, Vector};
use crate::prelude::*;
use crate::words::printable;

/// The joints behind a grasp, in inside coordinates.
#[derive(Debug, Clone)]
pub(crate) struct Linkage<D: Size, const C: usize> {
    pub(crate) joints: Vec<Named>,
    pub(crate) tendons: Vec<Named>,
    /// Joint displacements become lengths by these factors, one a coordinate; those of the object are left alone.
    pub(crate) lengths: Vector<D>,
    /// Motion of each contact along the coordinate axes, for one unit of each coordinate beside those of the object.
    pub(crate) motions: Vec<Vec<(usize, SVector<f64, C>)>>,
    /// One for each site beyond the contacts.
    pub(crate) drives: Vec<Drive<D>>,
    /// Torques and tensions that act whatever the joints do.
    pub(crate) held: Vector<D>,
    /// Torques on joints from outside.
    pub(crate) pulled: Vector<D>,
    /// The bodies, if there are several.
    pub(crate) bodies: Option<Box<PlacedBodies<C>>>,
    /// Links, from joint to joint and on to the contacts: only drawn.
    pub(crate) bones: Vec<[SVector<f64, C>; 2]>,
    /// Where the joints that turn are, those of the plane and the axes of space: only drawn.
    pub(crate) centres: Vec<Option<SVector<f64, C>>>,
    /// Commands of joints, then of tendons.
    pub(crate) commands: Vec<f64>,
}

/// What answers need to know of a joint or a tendon.
#[derive(Debug, Clone)]
pub(crate) struct Named {
    pub(crate) name: Option<Arc<str>>,
    pub(crate) limit: Option<Limit>,
    /// Of a joint what it does.
    pub(crate) kind: JointKind,
    /// The torque or tension that acts whatever it does.
    pub(crate) held: f64,
}

/// A part of a hand that can give way.
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

/// A joint or a tendon as answers name it.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PartLabel {
    /// Which: joints are counted from 0 finger by finger, slides of contacts that are held by a force behind them. Written as `"joint": 3`.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub part: HandPart,
    /// The user's name for it; not written if it has none.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub name: Option<Arc<str>>,
}

impl PartLabel {
    /// How messages and pictures call it: its name, or what it is and its number.
    #[must_use]
    pub fn text(&self) -> String {
        let name = self.name.as_deref().map(|name| printable(name).into_owned());
        name.unwrap_or_else(|| self.part.to_string())
    }
}

impl<D: Size, const C: usize> Linkage<D, C> {
    /// What commands stretch the sites of all drives by.
    pub(crate) fn stretches(&self, commands: &[f64]) -> impl Iterator<Item = SVector<f64, C>> {
        self.drives.iter().map(move |drive| drive.stretch(commands))
    }

    /// What a change of commands stretches the sites of all drives by.
    pub(crate) fn changes(&self, commands: &[f64]) -> impl Iterator<Item = SVector<f64, C>> {
        self.drives.iter().map(move |drive| drive.change(commands))
    }

    /// With own springs of joints and then tendons so many times as stiff.
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

    /// With commands and with torques that hold joints so many times as large.
    pub(crate) fn squeeze(&mut self, factor: f64) {
        self.commands.iter_mut().for_each(|command| *command *= factor);
        for (j, joint) in self.joints.iter_mut().enumerate() {
            let k = of_the_object::<C>() + j;
            self.held[k] += (factor - 1.0) * (joint.held / self.lengths[k]);
            joint.held *= factor;
        }
    }

    /// With the forces that hold some contacts in place of those that held them before.
    pub(crate) fn press_instead(&mut self, before: &[Contact<C>], now: &[Contact<C>]) {
        for ((before, now), motions) in before.iter().zip(now).zip(&self.motions) {
            if let (Some(before), Some(now), Some((slide, _))) = (before.force, now.force, motions.first()) {
                let k = of_the_object::<C>() + slide;
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

    /// The drives of a joint or, behind the joints, of a tendon.
    pub(crate) fn of_actuator(&self, actuator: usize) -> impl Iterator<Item = (usize, &Drive<D>)> {
        let joints = self.joints.len();
        let owner = if actuator < joints { Owner::Joint(actuator) } else { Owner::Tendon(actuator - joints) };
        self.drives.iter().enumerate().filter(move |(_, drive)| drive.owner == owner)
    }

    /// Whose drive it is.
    pub(crate) fn part(&self, drive: usize) -> Option<HandPart> {
        match self.drives[drive].owner {
            Owner::Joint(joint) => Some(HandPart::Joint(joint)),
            Owner::Tendon(tendon) => Some(HandPart::Tendon(tendon)),
            Owner::Nobody => None,
        }
    }
}
