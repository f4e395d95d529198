//! The answer to the question for better places and forces of the fingers.

use super::held::said;
use super::setup::Setup;
use crate::error::Error;
use crate::improve::{Improve, Improved};
use crate::words::Words;

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
    /// The answer.
    #[serde(flatten)]
    pub improved: Improved<C>,
}

impl<const C: usize> ImproveAnswer<C> {
    pub(super) fn of(improved: Improved<C>, words: Words) -> Self {
        Self { says: said(&improved, words), improved }
    }
}

impl<const C: usize> Setup<C> {
    /// The question for the grasp, with the surfaces of the scene's contacts.
    ///
    /// # Errors
    /// [`Error::Fingertip`] for a patch that cannot be built.
    pub fn improve(&self, asked: &Improve<C>) -> Result<Improve<C>, Error> {
        let (mut question, mut first) = (asked.clone(), 0);
        for entry in self.entries() {
            if let Some(surface) = &entry.surface {
                question = question.along(first, surface.clone());
            }
            first += entry.count()?;
        }
        Ok(question)
    }
}
