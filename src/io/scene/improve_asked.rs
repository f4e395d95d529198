//! The question for better places and forces of the fingers.

use nalgebra::SVector;

use super::held::said;
use super::need_asked::loads_given;
use super::setup::Setup;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::improve::{Improve, ImproveGoal, Improved};
use crate::serial::AsGiven;
use crate::words::Words;

/// Where should the fingers be, and how hard should they press? Contacts with a `surface` may move. See [`Improve`].
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
#[serde(deny_unknown_fields)]
pub struct ImproveAsked<const C: usize> {
    /// The load that acts before the other loads and stays.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub base: Option<Wrench<C>>,
    /// A load that grows.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load: Option<Wrench<C>>,
    /// Loads that grow, one at a time.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub loads: Vec<Wrench<C>>,
    /// A force of any direction beside the load, N, that acts at `at`; this size counts as load factor 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub any_force: Option<f64>,
    /// The point where the force of any direction acts, m; the origin if left out.
    #[serde(default, with = "AsGiven::<Option<SVector<f64, C>>>", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub at: Option<SVector<f64, C>>,
    /// The largest force with which a contact may press, N; if left out, commands stay.
    #[serde(default, with = "AsGiven::<Option<f64>>", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub at_most: Option<f64>,
    /// The quantity to maximise; the load at first slip if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub goal: Option<ImproveGoal>,
    /// Number of random starts beside the grasp of the scene; 8 if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub starts: Option<usize>,
    /// Largest number of steps from each start; 200 if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub steps: Option<usize>,
    /// The seed of the random starts; 0 if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
}

/// The improved places of the fingers; see [`Improved`].
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ImproveAnswer<const C: usize> {
    /// The answer in a sentence.
    pub says: String,
    /// The answer.
    #[serde(flatten)]
    pub improved: Improved<C>,
}

impl<const C: usize> ImproveAnswer<C> {
    pub(super) fn of(improved: Improved<C>, words: Words) -> Self {
        Self { says: said(&improved, words), improved }
    }
}

impl<const C: usize> ImproveAsked<C> {
    /// A question with these loads and default values.
    #[must_use]
    pub fn of(base: Option<Wrench<C>>, load: Option<Wrench<C>>) -> Self {
        let (any_force, at, at_most, goal) = (None, None, None, None);
        let (starts, steps, seed) = (None, None, None);
        Self { base, load, loads: Vec::new(), any_force, at, at_most, goal, starts, steps, seed }
    }
}

impl<const C: usize> Setup<C> {
    /// The question for the grasp.
    ///
    /// # Errors
    /// [`Error::Question`] unless loads are given in one way.
    pub fn improve(&self, asked: &ImproveAsked<C>) -> Result<Improve<C>, Error> {
        let loads = loads_given("improve", (asked.load, &asked.loads), (asked.any_force, asked.at))?;
        let mut question = Improve::new(loads).on_top_of(asked.base.unwrap_or(Wrench::ZERO));
        let mut first = 0;
        for entry in self.entries() {
            if let Some(surface) = &entry.surface {
                question = question.along(first, surface.clone());
            }
            first += entry.count()?;
        }
        if let Some(most) = asked.at_most {
            question = question.pressing_at_most(most);
        }
        question = question.with_goal(asked.goal.unwrap_or_default());
        if let Some(starts) = asked.starts {
            question = question.with_starts(starts);
        }
        if let Some(steps) = asked.steps {
            question = question.with_steps(steps);
        }
        Ok(question.with_seed(asked.seed.unwrap_or(0)))
    }
}
