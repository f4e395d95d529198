//! Answers that begin with a sentence: to `hold`, `need`, `improve`, `identify` and about repeated loads. An amount is a value of the quantity that
//! `need` seeks. A parameter is a number of the grasp that `identify` estimates. The load factor is the multiple of a growing load. The squeeze is
//! everything by which contacts press at rest without a load.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::labels::SceneNames;
use crate::hold::Verdict;
use crate::identify::Identified;
use crate::improve::Improved;
use crate::need::Needed;
use crate::shake::{Shakedown, Shaken};
use crate::words::Words;

/// Whether the grasp holds a load that grows from zero; see [`Verdict`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct HoldAnswer<const C: usize> {
    /// The answer in a sentence.
    pub says: String,
    /// Whether and up to which load factor the grasp holds. In the text the fields of `verdict` are fields of this answer itself.
    #[serde(flatten)]
    pub verdict: Verdict<C>,
}

/// The least squeeze or friction that the grasp needs, or the largest load, arm or angle that it holds; see [`Needed`].
///
/// ```
/// use grasp_lcp::scene::Scene;
///
/// let scene: Scene = serde_json::from_str(r#"{
///     "format": "grasp-lcp/1",
///     "planar": {
///         "contacts": [
///             { "name": "left", "point": [-0.03, 0], "normal": [1, 0], "series_stiffness": [1e4, 8e3], "friction": 0.5, "pressed_with": 10 },
///             { "name": "right", "point": [0.03, 0], "normal": [-1, 0], "series_stiffness": [1e4, 8e3], "friction": 0.5, "pressed_with": 10 }
///         ],
///         "questions": [{ "need": { "quantity": "squeeze", "load": { "force": [0, -12] }, "friction_less": 0 } }]
///     }
/// }"#)?;
/// let answers = serde_json::to_value(scene.answers()?)?;
/// let says = answers[0]["need"]["says"].as_str().unwrap_or_default();
/// let needs = "NEEDS 12 N at left and right so that it holds and nothing slides\n  if the squeeze is 5 % less: 12.6316 N\n  with less: SLIPS OUT at 12 N of 12 N";
/// assert!(says.starts_with(needs), "{says}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct NeedAnswer {
    /// The answer in a sentence, and in further lines what other amounts do.
    pub says: String,
    /// The value of the sought quantity, such as a squeeze. In the text the fields of `needed` are fields of this answer itself.
    #[serde(flatten)]
    pub needed: Needed,
}

impl SceneNames<'_> {
    pub(super) fn verdict(&self, mut verdict: Verdict<3>, words: Words) -> HoldAnswer<3> {
        let says = text(&verdict, words);
        let at_the_loss = verdict.lost.as_mut().and_then(|lost| lost.state.as_mut());
        for state in verdict.state.as_mut().into_iter().chain(at_the_loss) {
            **state = self.equilibrium(state.as_ref().clone());
        }
        HoldAnswer { says, verdict }
    }
}

impl NeedAnswer {
    pub(super) fn of(needed: Needed, words: Words) -> Self {
        Self { says: text(&needed, words), needed }
    }
}

/// The improved places of the fingers; see [`Improved`].
///
/// ```
/// use grasp_lcp::scene::Scene;
///
/// let scene: Scene = serde_json::from_str(r#"{
///     "format": "grasp-lcp/1",
///     "planar": {
///         "contacts": [
///             { "name": "left", "point": [-0.03, 0], "normal": [1, 0], "stiffness": 1e3, "friction": 0.5, "pressed_with": 8,
///               "surface": { "segment": [[-0.03, -0.02], [-0.03, 0.02]] } },
///             { "name": "right", "point": [0.03, 0.01], "normal": [-1, 0], "stiffness": 1e3, "friction": 0.5, "pressed_with": 8 }
///         ],
///         "questions": [{ "improve": { "load": { "force": [0, -1], "at": [0, 0] }, "at_most": 10 } }]
///     }
/// }"#)?;
/// let answers = serde_json::to_value(scene.answers()?)?;
/// let says = answers[0]["improve"]["says"].as_str().expect("a sentence");
/// assert!(says.starts_with("FIRST SLIP at 10 N instead of"), "{says}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ImproveAnswer<const C: usize> {
    /// The answer in a sentence.
    pub says: String,
    /// The better finger places. In the text the fields of `improved` are fields of this answer itself.
    #[serde(flatten)]
    pub improved: Improved<C>,
}

impl<const C: usize> ImproveAnswer<C> {
    pub(super) fn of(improved: Improved<C>, words: Words) -> Self {
        Self { says: text(&improved, words), improved }
    }
}

/// The identified parameters of the grasp with their standard errors; see [`Identified`].
///
/// ```
/// use grasp_lcp::scene::Scene;
///
/// let scene: Scene = serde_json::from_str(r#"{
///     "format": "grasp-lcp/1",
///     "planar": {
///         "contacts": [
///             { "name": "left", "point": [-0.03, 0], "normal": [1, 0], "series_stiffness": [1e4, 8e3], "friction": 0.5, "pressed_with": 10 },
///             { "name": "right", "point": [0.03, 0], "normal": [-1, 0], "series_stiffness": [1e4, 8e3], "friction": 0.5, "pressed_with": 10 }
///         ],
///         "questions": [{ "identify": {
///             "unknowns": [{ "quantity": "friction" }],
///             "slips": [{ "load": { "force": [0, -6.1] } }, { "load": { "force": [0, -5.8] } }, { "load": { "force": [0, -6.4] } }]
///         } }]
///     }
/// }"#)?;
/// let answers = serde_json::to_value(scene.answers()?)?;
/// let says = "friction 0.3048 ± 0.0087 (95 %: 0.2697 to 0.3444) from 3 slips, which scatter by 5.1 %";
/// assert_eq!(answers[0]["identify"]["says"], says);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct IdentifyAnswer {
    /// The answer in a sentence.
    pub says: String,
    /// The estimates of the parameters. In the text the fields of `identified` are fields of this answer itself.
    #[serde(flatten)]
    pub identified: Identified,
}

impl IdentifyAnswer {
    pub(super) fn of(identified: Identified, words: Words) -> Self {
        Self { says: text(&identified, words), identified }
    }
}

/// The response of the grasp to a repeated load; see [`Shaken`].
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
    /// Whether slip ceases, alternates or accumulates as the load repeats. In the text the fields of `shaken` are fields of this answer itself.
    #[serde(flatten)]
    pub shaken: Shaken<C>,
}

/// Whether slip ceases, whatever the order of the repeated loads; see [`Shakedown`].
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
    /// Whether slipping ceases under these loads. Left out if this depends on the order of the loads, or if it is unknown.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rests: Option<bool>,
    /// The shakedown factor, i.e. the multiple of the loads beyond which the grasp never comes to rest, and the slips with which no contact slides at
    /// this multiple. Left out if no factor could be computed.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub found: Option<Shakedown<C>>,
}

/// The sentence if no shakedown factor could be computed.
const NO_SHAKEDOWN: &str = "UNDECIDED: with all contacts closed no slips keep what is there at rest, or nothing resists one of the loads";

impl<const C: usize> ShakedownAnswer<C> {
    pub(super) fn of(found: Option<Shakedown<C>>, words: Words) -> Self {
        let says = found.as_ref().map_or_else(|| NO_SHAKEDOWN.to_owned(), |found| text(found, words));
        Self { says, rests: found.as_ref().and_then(|found| found.rests(1.0)), found }
    }
}

impl SceneNames<'_> {
    pub(super) fn shaken(&self, mut shaken: Shaken<3>, words: Words) -> ShakeAnswer<3> {
        let says = text(&shaken, words);
        if let Some(state) = shaken.state.as_mut() {
            **state = self.equilibrium(state.as_ref().clone());
        }
        ShakeAnswer { says, shaken }
    }
}

pub(super) fn text(answer: &impl fmt::Display, words: Words) -> String {
    let digits = words.precision();
    format!("{answer:.digits$}")
}
