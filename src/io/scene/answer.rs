//! The answer to one question, of whichever kind.

use serde::{Deserialize, Serialize};

use super::compared::CompareAnswer;
use super::held::{HoldAnswer, IdentifyAnswer, ImproveAnswer, NeedAnswer, ShakeAnswer, ShakedownAnswer};
use super::onset::{OnsetAnswer, TurnAnswer};
use super::path::PathAnswer;
use super::solved::SolveAnswer;

/// The answer to a [`Question`](super::Question), under the same name.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Answer<const C: usize> {
    /// To `hold`.
    Hold(HoldAnswer<C>),
    /// To `need`.
    Need(NeedAnswer),
    /// To `improve`.
    Improve(ImproveAnswer<C>),
    /// To `solve`.
    Solve(SolveAnswer<C>),
    /// To `compare`.
    Compare(CompareAnswer<C>),
    /// To `onset`.
    Onset(OnsetAnswer<C>),
    /// To `onset_of_turn`.
    OnsetOfTurn(TurnAnswer<C>),
    /// To `follow`.
    Follow(PathAnswer<C>),
    /// To `shake`.
    Shake(ShakeAnswer<C>),
    /// To `shakedown`.
    Shakedown(ShakedownAnswer<C>),
    /// To `identify`.
    Identify(IdentifyAnswer),
}
