//! What happens to a drive of a hand.

/// What the drive of a joint or of a tendon does from an event on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum DriveChange {
    /// It has reached its limit and yields.
    Yields,
    /// It holds again.
    Holds,
    /// A tendon loses its tension.
    Slackens,
    /// A slack tendon pulls again.
    Tightens,
}
