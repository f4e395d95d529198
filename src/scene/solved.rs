//! Answers to "where does the object go, and what do contacts carry?"

use serde::{Deserialize, Serialize};

use super::held::HoldAnswer;
use super::labels::SceneNames;
use crate::ask::Grasp;
use crate::equilibrium::Outcome;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::words::Words;

/// The equilibrium under a load, or the proof that there is none; see [`Outcome`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SolveAnswer<const C: usize> {
    /// How the question ends.
    #[serde(flatten)]
    pub outcome: Outcome<C>,
    /// What becomes of the load where it is put on from rest: of an outcome that is undecided, and of an equilibrium that has lost a vacuum.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from_rest: Option<HoldAnswer<C>>,
}

impl SceneNames {
    /// The answer to a question, and what a path says where the search does not tell whether the load is held.
    pub(super) fn solve<const C: usize>(
        &self,
        grasp: &Grasp<C>,
        load: &Wrench<C>,
        outcome: Outcome<C>,
        words: Words,
    ) -> Result<SolveAnswer<C>, Error> {
        let tells = match &outcome {
            Outcome::Equilibrium(state) => state.open_cups.is_empty(),
            Outcome::NoEquilibrium(_) => true,
            Outcome::Undecided(_) => false,
        };
        let from_rest = if tells { None } else { Some(self.verdict(grasp.hold(*load)?, words)) };
        Ok(SolveAnswer { outcome: self.solved(grasp, outcome), from_rest })
    }
}
