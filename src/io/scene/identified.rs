//! The answer about observed slips.

use serde::{Deserialize, Serialize};

use super::held::said;
use super::setup::Setup;
use crate::ask::check_contact;
use crate::error::Error;
use crate::identify::{Ending, Identified, Identify, LAYOUTS_OF_HANDS};
use crate::words::Words;

/// The unknowns with their errors; see [`Identified`].
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
    /// The answer.
    #[serde(flatten)]
    pub identified: Identified,
}

impl IdentifyAnswer {
    pub(super) fn of(identified: Identified, words: Words) -> Self {
        Self { says: said(&identified, words), identified }
    }
}

impl<const C: usize> Setup<C> {
    /// Refuses faults that show without building the layouts.
    pub(super) fn check_identify(&self, asked: &Identify<C>) -> Result<(), Error> {
        if !asked.layouts.is_empty() && (self.is_held_by_a_hand() || !self.bodies.is_empty()) {
            return Err(LAYOUTS_OF_HANDS);
        }
        let expected = self.entries().count();
        for points in &asked.layouts {
            let given = points.len();
            if given != expected {
                return Err(Error::Size { what: "points of a layout", given, expected });
            }
        }
        for contact in asked.unknowns.iter().flat_map(|unknown| &unknown.contacts).flatten() {
            check_contact(*contact, expected)?;
        }
        asked.check_numbers(1 + asked.layouts.len())
    }
}

/// The name of the search's end in the format.
pub(super) fn ended(ending: &Ending) -> &'static str {
    match ending {
        Ending::Converged => "converged",
        Ending::NotConverged { .. } => "not_converged",
        Ending::NotPredicted { .. } => "not_predicted",
    }
}
