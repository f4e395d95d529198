//! Legs (sections) of a load program in serialised form. Each quantity that changes along the leg has a field `…_by`, its change, or `…_to`, its
//! value at the end. A command is a prescribed displacement of a finger. A contact with a constant normal force gets a prismatic joint of its own, in
//! addition to the joints of fingers.

use crate::numerics::IntoList;
use alloc::collections::BTreeMap;

use nalgebra::SVector;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::leg::{Leg, LegGoal, LegLoad};
use super::turn::Turn;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::serial::{AsGiven, object};
use crate::words::printable;

#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, bound = "")]
struct WrittenLeg<const C: usize> {
    /// The change of the load along the leg.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    load_by: Option<Wrench<C>>,
    /// The load at the end of the leg, instead of `load_by`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    load_to: Option<Wrench<C>>,
    /// The change of the finger commands along the leg: one row for each contact, m.
    #[serde(
        default,
        with = "AsGiven::<Option<Vec<SVector<f64, C>>>>",
        skip_serializing_if = "Option::is_none"
    )]
    #[cfg_attr(feature = "schema", schemars(!default))]
    commands_by: Option<Vec<SVector<f64, C>>>,
    /// The finger commands at the end of the leg, instead of `commands_by`.
    #[serde(
        default,
        with = "AsGiven::<Option<Vec<SVector<f64, C>>>>",
        skip_serializing_if = "Option::is_none"
    )]
    #[cfg_attr(feature = "schema", schemars(!default))]
    commands_to: Option<Vec<SVector<f64, C>>>,
    /// The change of the commands of joints and then tendons along the leg, rad or m.
    #[serde(default, with = "AsGiven::<Option<Vec<f64>>>", skip_serializing_if = "Option::is_none")]
    joints_by: Option<Vec<f64>>,
    /// The commands of joints and then tendons at the end of the leg, instead of `joints_by`.
    #[serde(default, with = "AsGiven::<Option<Vec<f64>>>", skip_serializing_if = "Option::is_none")]
    joints_to: Option<Vec<f64>>,
    /// The change along the leg of the constant torques on joints, one for each joint, N m or N. The constant forces of contacts that have one come
    /// last.
    #[serde(default, with = "AsGiven::<Option<Vec<f64>>>", skip_serializing_if = "Option::is_none")]
    torques_by: Option<Vec<f64>>,
    /// The constant torques on joints at the end of the leg, instead of `torques_by`.
    #[serde(default, with = "AsGiven::<Option<Vec<f64>>>", skip_serializing_if = "Option::is_none")]
    torques_to: Option<Vec<f64>>,
    /// The change of the loads of bodies along the leg, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    body_loads_by: BTreeMap<String, Wrench<C>>,
    /// The loads of bodies at the end of the leg, by name, on top of the `load` and the weight of each body. A body may not be in `body_loads_by` as well.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    body_loads_to: BTreeMap<String, Wrench<C>>,
    /// The turn of the load along the leg, instead of all other fields. It begins with the load before the leg, `start` or `base` of a first leg.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    turn: Option<Turn<C>>,
}

impl<T: Clone> LegGoal<T> {
    /// The change of the quantity `name` along a leg, from its fields `…_by` (change) and `…_to` (value at the end): [`LegGoal::Stay`] if neither is
    /// given, and an error if both are given.
    fn read(by: Option<T>, to: Option<T>, name: &str) -> Result<Self, String> {
        match (by, to) {
            (None, None) => Ok(Self::Stay),
            (Some(by), None) => Ok(Self::By(by)),
            (None, Some(to)) => Ok(Self::To(to)),
            (Some(_), Some(_)) => Err(format!("{name}_by and {name}_to: a leg has one of them")),
        }
    }

    /// The values of the serialised fields `…_by` and `…_to` for this goal, at most one of which is given.
    fn written(&self) -> (Option<T>, Option<T>) {
        match self {
            Self::Stay => (None, None),
            Self::By(by) => (Some(by.clone()), None),
            Self::To(to) => (None, Some(to.clone())),
        }
    }
}

impl<const C: usize> WrittenLeg<C> {
    fn leg(self) -> Result<Leg<C>, String> {
        let load = match (LegGoal::read(self.load_by, self.load_to, "load")?, self.turn) {
            (straight, None) => LegLoad::Straight(straight),
            (LegGoal::Stay, Some(turn)) => LegLoad::Turn(turn),
            (LegGoal::By(_), Some(_)) => return Err("load_by and turn: a leg has one of them".to_owned()),
            (LegGoal::To(_), Some(_)) => return Err("load_to and turn: a leg has one of them".to_owned()),
        };
        if let Some(name) = self.body_loads_by.keys().find(|name| self.body_loads_to.contains_key(*name)) {
            return Err(format!("body_loads_by and body_loads_to: {} is in both", printable(name)));
        }
        let by = self.body_loads_by.into_iter().map(|(name, change)| (name.into(), LegGoal::By(change)));
        let to = self.body_loads_to.into_iter().map(|(name, load)| (name.into(), LegGoal::To(load)));
        let bodies = by.chain(to).list();
        let commands = LegGoal::read(self.commands_by, self.commands_to, "commands")?;
        let joints = LegGoal::read(self.joints_by, self.joints_to, "joints")?;
        let torques = LegGoal::read(self.torques_by, self.torques_to, "torques")?;
        let changes = commands != LegGoal::Stay || joints != LegGoal::Stay || torques != LegGoal::Stay;
        if changes && matches!(load, LegLoad::Turn(_)) {
            return Err(Error::CommandsWhileTurning.to_string());
        }
        Ok(Leg { load, commands, joints, torques, bodies })
    }
}

impl<const C: usize> Leg<C> {
    /// Refuses, with an error, a list of the wrong length. Commands have one entry for each contact, joint commands one for each drive (joints, then
    /// tendons), and torques one for each joint.
    pub(crate) fn check_lengths(&self, [contacts, drives, joints]: [usize; 3]) -> Result<(), Error> {
        if let LegGoal::By(rows) | LegGoal::To(rows) = &self.commands {
            check_rows(rows.len(), "commands of a leg", contacts)?;
        }
        if let LegGoal::By(list) | LegGoal::To(list) = &self.joints {
            check_drives(list.len(), "joint commands of a leg", drives)?;
        }
        match &self.torques {
            LegGoal::Stay => Ok(()),
            LegGoal::By(list) | LegGoal::To(list) => check_drives(list.len(), "torques of a leg", joints),
        }
    }

    /// Names of the bodies whose own loads change along the leg.
    pub(crate) fn loaded_bodies(&self) -> impl Iterator<Item = &str> {
        self.bodies.iter().map(|(name, _)| &**name)
    }

    /// The change of the load along this leg, or the load at its end, whichever the leg gives; `None` if the load stays constant or turns.
    pub(crate) fn straight_load(&self) -> Option<Wrench<C>> {
        match self.load {
            LegLoad::Straight(LegGoal::By(load) | LegGoal::To(load)) => Some(load),
            _ => None,
        }
    }

    /// The angle by which the load turns along this leg, rad; 0 if it does not turn.
    pub(crate) fn turned_by(&self) -> f64 {
        match &self.load {
            LegLoad::Turn(turn) => turn.angle(),
            LegLoad::Straight(_) => 0.0,
        }
    }
}

/// Refuses, with an error, a list `what` of commands whose length `given` is not `expected`, the number of contacts.
pub(super) fn check_rows(given: usize, what: &'static str, expected: usize) -> Result<(), Error> {
    if given == expected { Ok(()) } else { Err(Error::Size { what, given, expected }) }
}

/// Refuses, with an error, a list `what` whose length `given` is not `expected`, the number of drives or joints.
pub(super) fn check_drives(given: usize, what: &'static str, expected: usize) -> Result<(), Error> {
    if given == expected { Ok(()) } else { Err(Error::JointCommands { what, given, expected }) }
}

/// A leg is written with a field `…_by` or `…_to` for each quantity that changes (feature `serde`).
impl<const C: usize> Serialize for Leg<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let ((load_by, load_to), turn) = match &self.load {
            LegLoad::Straight(goal) => (goal.written(), None),
            LegLoad::Turn(turn) => ((None, None), Some(*turn)),
        };
        let (commands_by, commands_to) = self.commands.written();
        let (joints_by, joints_to) = self.joints.written();
        let (torques_by, torques_to) = self.torques.written();
        let [mut body_loads_by, mut body_loads_to] = [BTreeMap::new(), BTreeMap::new()];
        for (name, goal) in &self.bodies {
            let (by, to) = goal.written();
            body_loads_by.extend(by.map(|change| (name.to_string(), change)));
            body_loads_to.extend(to.map(|load| (name.to_string(), load)));
        }
        WrittenLeg {
            load_by,
            load_to,
            commands_by,
            commands_to,
            joints_by,
            joints_to,
            torques_by,
            torques_to,
            body_loads_by,
            body_loads_to,
            turn,
        }
        .serialize(serializer)
    }
}

/// A leg is read from a field `…_by` or `…_to` for each quantity that changes (feature `serde`). A quantity with both fields is refused.
impl<'de, const C: usize> Deserialize<'de> for Leg<C> {
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        object::read(deserializer, "a leg", WrittenLeg::leg)
    }
}

#[cfg(feature = "schema")]
crate::serial::schema_as_written!("Leg", Leg<C>, WrittenLeg<C>, C);
