//! The answer to one question, of whichever kind.

use serde::{Deserialize, Serialize};

use super::compared::CompareAnswer;
use super::onset::{OnsetAnswer, TurnAnswer};
use super::path::PathAnswer;
use super::sentence_answers::{
    HoldAnswer, IdentifyAnswer, ImproveAnswer, NeedAnswer, ShakeAnswer, ShakedownAnswer,
};
use super::solved::SolveAnswer;

/// The answer to a [`Question`](super::Question). Its variant has the name of the question.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Answer<const C: usize> {
    /// The answer to `hold`.
    Hold(HoldAnswer<C>),
    /// The answer to `need`.
    Need(NeedAnswer),
    /// The answer to `improve`.
    Improve(ImproveAnswer<C>),
    /// The answer to `solve`.
    Solve(SolveAnswer<C>),
    /// The answer to `compare`.
    Compare(CompareAnswer<C>),
    /// The answer to `onset`.
    Onset(OnsetAnswer<C>),
    /// The answer to `onset_of_turn`.
    OnsetOfTurn(TurnAnswer<C>),
    /// The answer to `follow`.
    Follow(PathAnswer<C>),
    /// The answer to `shake`.
    Shake(ShakeAnswer<C>),
    /// The answer to `shakedown`.
    Shakedown(ShakedownAnswer<C>),
    /// The answer to `identify`.
    Identify(IdentifyAnswer),
}
