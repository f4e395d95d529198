//! Answers to `hold` and `need`.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::labels::SceneNames;
use crate::hold::Verdict;
use crate::need::Needed;
use crate::words::Words;

/// The fate of a load that is put on from rest; see [`Verdict`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct HoldAnswer<const C: usize> {
    /// The answer in a sentence.
    pub says: String,
    /// The answer.
    #[serde(flatten)]
    pub verdict: Verdict<C>,
}

/// The amount of a quantity that the grasp needs; see [`Needed`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct NeedAnswer {
    /// The answer in a sentence.
    pub says: String,
    /// The answer.
    #[serde(flatten)]
    pub needed: Needed,
}

impl SceneNames {
    pub(super) fn verdict<const C: usize>(&self, mut verdict: Verdict<C>, words: Words) -> HoldAnswer<C> {
        let says = said(&verdict, words);
        let at_the_loss = verdict.lost.as_mut().and_then(|lost| lost.state.as_mut());
        for state in verdict.state.as_mut().into_iter().chain(at_the_loss) {
            **state = self.equilibrium(state.as_ref().clone());
        }
        HoldAnswer { says, verdict }
    }
}

impl NeedAnswer {
    pub(super) fn of(needed: Needed, words: Words) -> Self {
        Self { says: said(&needed, words), needed }
    }
}

pub(super) fn said(answer: &impl fmt::Display, words: Words) -> String {
    let digits = words.digits();
    format!("{answer:.digits$}")
}
