//! Changes of the drives of a hand's joints and tendons, as reported in events. A drive is the spring of a joint or tendon, with its force limit. An
//! event is a change of contact states, or of drives, at one point of a load path.

use crate::grasp::PartLabel;

/// A joint or a tendon whose drive changes its behaviour at an event.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PartChange {
    /// The joint or tendon whose drive changes its behaviour.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub part: PartLabel,
    /// The behaviour of the drive from this event on.
    pub what: DriveChange,
}

/// The behaviour of the drive of a joint or of a tendon from an event on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum DriveChange {
    /// The drive gives way at a constant force or torque, which has reached its greatest allowed value.
    Yields,
    /// The drive holds again like a spring.
    Holds,
    /// A tendon loses its tension.
    Slackens,
    /// A slack tendon pulls again.
    Tightens,
}
