//! Answers about repeated loads.

use serde::{Deserialize, Serialize};

use super::held::said;
use super::labels::SceneNames;
use crate::shake::{Shakedown, Shaken};
use crate::words::Words;

/// The fate of a repeated load; see [`Shaken`].
///
/// ```
/// use grasp_lcp::scene::Scene;
///
/// let scene: Scene = serde_json::from_str(r#"{
///     "format": "grasp-lcp/1",
///     "planar": {
///         "contacts": [
///             { "name": "left foot", "point": [-1, 0], "normal": [0, 1], "stiffness": 1e3, "friction": 0.5 },
///             { "name": "right foot", "point": [1, 0], "normal": [0, 1], "stiffness": 1e3, "friction": 0.5 }
///         ],
///         "questions": [{ "shake": { "base": { "force": [1.5, -10] }, "loads": [{ "moment": 3 }, { "moment": -3 }] } }]
///     }
/// }"#)?;
/// let answers = serde_json::to_value(scene.answers()?)?;
/// assert_eq!(answers[0]["shake"]["repeats"], "rests");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ShakeAnswer<const C: usize> {
    /// The answer in a sentence.
    pub says: String,
    /// The answer.
    #[serde(flatten)]
    pub shaken: Shaken<C>,
}

/// Whether the grasp comes to rest in any order of the loads; see [`Shakedown`].
///
/// ```
/// use grasp_lcp::scene::Scene;
///
/// let scene: Scene = serde_json::from_str(r#"{
///     "format": "grasp-lcp/1",
///     "planar": {
///         "contacts": [
///             { "name": "left foot", "point": [-1, 0], "normal": [0, 1], "stiffness": 1e3, "friction": 0.5 },
///             { "name": "right foot", "point": [1, 0], "normal": [0, 1], "stiffness": 1e3, "friction": 0.5 }
///         ],
///         "questions": [{ "shakedown": { "base": { "force": [1.5, -10] }, "loads": [{ "moment": 3.5 }, { "moment": -3.5 }] } }]
///     }
/// }"#)?;
/// let answers = serde_json::to_value(scene.answers()?)?;
/// assert_eq!(answers[0]["shakedown"]["rests"], true);
/// assert_eq!(answers[0]["shakedown"]["says"], "RESTS in whichever order they come, up to 2 times these loads. With more, left foot and right foot slide");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ShakedownAnswer<const C: usize> {
    /// The answer in a sentence.
    pub says: String,
    /// Whether the grasp comes to rest under these loads; left out if the order decides, or if it is unknown.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rests: Option<bool>,
    /// The answer, if there is one.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub found: Option<Shakedown<C>>,
}

/// The sentence without an answer.
const NO_SHAKEDOWN: &str = "UNDECIDED: with all contacts closed no slips keep what is there at rest, or nothing resists one of the loads";

impl<const C: usize> ShakedownAnswer<C> {
    pub(super) fn of(found: Option<Shakedown<C>>, words: Words) -> Self {
        let says = found.as_ref().map_or_else(|| NO_SHAKEDOWN.to_owned(), |found| said(found, words));
        Self { says, rests: found.as_ref().and_then(|found| found.rests(1.0)), found }
    }
}

impl SceneNames {
    pub(super) fn shaken<const C: usize>(&self, mut shaken: Shaken<C>, words: Words) -> ShakeAnswer<C> {
        let says = said(&shaken, words);
        if let Some(state) = shaken.state.as_mut() {
            **state = self.equilibrium(state.as_ref().clone());
        }
        ShakeAnswer { says, shaken }
    }
}
