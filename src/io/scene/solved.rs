//! Answers about the equilibrium under a load: motion of the object and contact forces.

use serde::{Deserialize, Serialize};

use super::labels::SceneNames;
use super::sentence_answers::HoldAnswer;
use crate::equilibrium::Outcome;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::words::Words;

/// The equilibrium under a load, or the proof that there is none; see [`Outcome`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SolveAnswer<const C: usize> {
    /// The equilibrium, the proof that none exists, or the reason why neither was found.
    #[serde(flatten)]
    pub outcome: Outcome<C>,
    /// The answer of `hold` for the same load, growing from zero. It is given if the outcome is undecided, or if a suction cup has lost its vacuum.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from_rest: Option<HoldAnswer<C>>,
}

impl SceneNames<'_> {
    /// The answer to `solve`. If the outcome does not decide whether the load is held, the answer of `hold` is added.
    pub(super) fn solve(
        &self,
        load: &Wrench<3>,
        outcome: Outcome<3>,
        words: Words,
    ) -> Result<SolveAnswer<3>, Error> {
        let tells = match &outcome {
            Outcome::Equilibrium(state) => state.open_cups.is_empty(),
            Outcome::NoEquilibrium(_) => true,
            Outcome::Undecided(_) => false,
        };
        let from_rest = if tells { None } else { Some(self.verdict(self.0.hold(*load)?, words)) };
        Ok(SolveAnswer { outcome: self.solved(outcome), from_rest })
    }
}
