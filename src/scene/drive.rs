//! Which joint or tendon of the scene an answer speaks of, and what it says of it.

use serde::{Deserialize, Serialize};

use super::place::Places;
use crate::equilibrium::{DriveState, JointAnswer, TendonAnswer};
use crate::grasp::HandPart;
use crate::load_path::DriveChange;
use crate::serial::AsComputed;

/// A joint or a tendon, as the scene knows it: `{"joint": 3, "name": "knuckle"}`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Part {
    /// Which: joints are counted from 0 finger by finger, a finger that presses with a force counts as one.
    #[serde(flatten)]
    pub part: HandPart,
    /// Its name; left out if it has none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
}

/// One joint of an equilibrium; see [`JointAnswer`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct JointTold {
    /// Which joint.
    #[serde(flatten)]
    pub part: Part,
    /// What its own drive does.
    pub state: DriveState,
    /// Displacement from the posture in which the contacts were given, rad or m.
    #[serde(with = "AsComputed::<f64>")]
    pub displacement: f64,
    /// Torque of all drives on it, N m or N.
    #[serde(with = "AsComputed::<f64>")]
    pub torque: f64,
    /// What its own drive exerts, N m or N.
    #[serde(with = "AsComputed::<f64>")]
    pub drive: f64,
    /// What is left of its limit, N m or N; "infinite" without one.
    #[serde(with = "AsComputed::<f64>")]
    pub margin: f64,
    /// How far its drive has given way beyond its spring, rad or m.
    #[serde(with = "AsComputed::<f64>")]
    pub yielded: f64,
}

/// One tendon of an equilibrium; see [`TendonAnswer`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct TendonTold {
    /// Which tendon.
    #[serde(flatten)]
    pub part: Part,
    /// What its drive does.
    pub state: DriveState,
    /// Its tension, N.
    #[serde(with = "AsComputed::<f64>")]
    pub tension: f64,
    /// What is left of its limit, N; "infinite" without one.
    #[serde(with = "AsComputed::<f64>")]
    pub margin: f64,
    /// How far its drive has given way beyond its spring, m.
    #[serde(with = "AsComputed::<f64>")]
    pub yielded: f64,
}

/// A joint or a tendon that does something else from an event on.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct DriveTurn {
    /// Which joint or tendon.
    #[serde(flatten)]
    pub part: Part,
    /// What it does from here on.
    pub what: DriveChange,
}

impl Part {
    /// Its name, or what it is and its number.
    #[must_use]
    pub fn label(&self) -> String {
        let (kind, number) = match self.part {
            HandPart::Joint(joint) => ("joint", joint),
            HandPart::Tendon(tendon) => ("tendon", tendon),
        };
        self.name.clone().unwrap_or_else(|| format!("{kind} {number}"))
    }
}

impl Places {
    pub(super) fn part(&self, part: HandPart) -> Part {
        let name = match part {
            HandPart::Joint(joint) => self.joints[joint].clone(),
            HandPart::Tendon(tendon) => self.tendons[tendon].clone(),
        };
        Part { part, name }
    }

    pub(super) fn joints(&self, answers: &[JointAnswer]) -> Vec<JointTold> {
        let told = |(joint, answer): (usize, &JointAnswer)| JointTold {
            part: self.part(HandPart::Joint(joint)),
            state: answer.state,
            displacement: answer.displacement,
            torque: answer.torque,
            drive: answer.drive,
            margin: answer.margin,
            yielded: answer.yielded,
        };
        answers.iter().enumerate().map(told).collect()
    }

    pub(super) fn tendons(&self, answers: &[TendonAnswer]) -> Vec<TendonTold> {
        let told = |(tendon, answer): (usize, &TendonAnswer)| TendonTold {
            part: self.part(HandPart::Tendon(tendon)),
            state: answer.state,
            tension: answer.tension,
            margin: answer.margin,
            yielded: answer.yielded,
        };
        answers.iter().enumerate().map(told).collect()
    }

    pub(super) fn turns(&self, changes: &[(HandPart, DriveChange)]) -> Vec<DriveTurn> {
        changes.iter().map(|(part, what)| DriveTurn { part: self.part(*part), what: *what }).collect()
    }
}
