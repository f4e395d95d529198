//! The question about a repeated load.

use serde::{Deserialize, Serialize};

use super::held::said;
use super::labels::SceneNames;
use super::question::{LegAsked, no_load};
use super::setup::Setup;
use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::load_path::Leg;
use crate::shake::{Shakedown, Shaken};
use crate::words::Words;

/// Does the grasp survive a repeated load? The cycle is a list of loads that are put on and taken off in turn, or a list of legs.
/// See [`Grasp::shake`](crate::ask::Grasp::shake).
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
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct ShakeAsked<const C: usize> {
    /// The load at rest, where every cycle begins and ends; zero if left out.
    #[serde(default = "no_load::<C>")]
    pub base: Wrench<C>,
    /// The loads beside it, each put on and taken off in turn.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub loads: Vec<Wrench<C>>,
    /// The legs of a cycle, instead of loads; they must lead back to their beginning.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub legs: Vec<LegAsked<C>>,
}

/// The fate of a repeated load; see [`Shaken`].
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

/// Does the grasp survive loads that repeat in any order? See [`Statics::shakedown`](crate::ask::Statics::shakedown).
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
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct ShakedownAsked<const C: usize> {
    /// The load at rest; zero if left out.
    #[serde(default = "no_load::<C>")]
    pub base: Wrench<C>,
    /// The loads beside it. They come in any order, with any load between two of them.
    pub loads: Vec<Wrench<C>>,
}

/// Whether the grasp comes to rest in any order of the loads; see [`Shakedown`].
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

impl<const C: usize> ShakedownAsked<C> {
    /// These loads in any order beside the base load.
    #[must_use]
    pub fn in_any_order(base: Wrench<C>, loads: impl IntoIterator<Item = Wrench<C>>) -> Self {
        Self { base, loads: loads.into_iter().collect() }
    }

    /// Refuses a question without loads.
    pub(super) fn check(&self) -> Result<(), Error> {
        let (field, fault) = ("loads", "are missing, must be given");
        if self.loads.is_empty() {
            Err(Error::Question { question: "shakedown", field, fault })
        } else {
            Ok(())
        }
    }

    pub(super) fn found(&self, grasp: &Grasp<C>) -> Result<Option<Shakedown<C>>, Error> {
        grasp.statics().shakedown(&self.base, &self.loads)
    }
}

impl<const C: usize> ShakedownAnswer<C> {
    pub(super) fn of(found: Option<Shakedown<C>>, words: Words) -> Self {
        let says = found.as_ref().map_or_else(|| NO_SHAKEDOWN.to_owned(), |found| said(found, words));
        Self { says, rests: found.as_ref().and_then(|found| found.rests(1.0)), found }
    }
}

impl<const C: usize> ShakeAsked<C> {
    /// These loads beside the base load, each put on and taken off in turn.
    #[must_use]
    pub fn in_turn(base: Wrench<C>, loads: impl IntoIterator<Item = Wrench<C>>) -> Self {
        Self { base, loads: loads.into_iter().collect(), legs: Vec::new() }
    }
}

impl<const C: usize> Setup<C> {
    /// The legs of a cycle for the grasp.
    ///
    /// # Errors
    /// As for [`Self::legs`]; [`Error::Question`] unless there are loads or legs.
    pub fn cycle(&self, asked: &ShakeAsked<C>) -> Result<Vec<Leg<C>>, Error> {
        match (asked.loads.is_empty(), asked.legs.is_empty()) {
            (false, true) => {
                let mut legs = Vec::new();
                for load in &asked.loads {
                    legs.extend(Leg::there_and_back(*load));
                }
                Ok(legs)
            }
            (true, false) => self.legs(&asked.legs),
            (true, true) => Err(Error::Question {
                question: "shake",
                field: "loads",
                fault: "are missing, must be given, or legs in their place",
            }),
            (false, false) => Err(Error::Question {
                question: "shake",
                field: "legs",
                fault: "are given beside loads, must be one of them",
            }),
        }
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
