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
///
/// ```
/// use grasp_lcp::scene::Scene;
///
/// let scene: Scene = serde_json::from_str(r#"{
///     "format": "grasp-lcp/1",
///     "planar": {
///         "contacts": [
///             { "name": "left", "point": [-0.03, 0], "normal": [1, 0], "series_stiffness": [1e3, 8e2], "friction": 0.5, "pressed_with": 10 },
///             { "name": "right", "point": [0.03, 0], "normal": [-1, 0], "series_stiffness": [1e3, 8e2], "friction": 0.5, "pressed_with": 10 }
///         ],
///         "questions": [{ "need": { "quantity": "squeeze", "load": { "force": [0, -12] }, "friction_less": 0 } }]
///     }
/// }"#)?;
/// let answers = serde_json::to_value(scene.answers()?)?;
/// let says = answers[0]["need"]["says"].as_str().unwrap_or_default();
/// let needs = "NEEDS 12 N at left and right so that it holds and nothing slides, 12.6316 N if the squeeze is 5 % less. With less: SLIPS OUT at 12 N of 12 N";
/// assert!(says.starts_with(needs), "{says}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
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
