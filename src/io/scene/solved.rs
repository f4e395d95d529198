//! Answers about the equilibrium under a load: motion of the object and contact forces.

use serde::{Deserialize, Serialize};

use super::held::HoldAnswer;
use super::labels::SceneNames;
use crate::equilibrium::Outcome;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::words::Words;

/// The equilibrium under a load, or the proof that there is none; see [`Outcome`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SolveAnswer<const C: usize> {
    /// The outcome.
    #[serde(flatten)]
    pub outcome: Outcome<C>,
    /// The answer of `hold` for the same load from rest. It is given for an undecided outcome, and for an equilibrium that has lost a vacuum.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from_rest: Option<HoldAnswer<C>>,
}

impl SceneNames<'_> {
    /// The answer to a question; if the search does not decide whether the load is held, with the answer of a path from rest.
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
