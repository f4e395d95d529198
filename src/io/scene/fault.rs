//! Scenes in JSON: the error for a faulty scene names the field and the reason (feature `json`).

use std::fmt;

use serde::Deserialize;

use super::centre_of_mass::with_centre_of_mass;
use super::field_path::faulty_field;
use super::lengths::in_metres;
use super::load_by_mass::ALONE;
use super::plain_words::in_plain_words;
use super::written::{FORMAT, Id, Scene, SceneInTextUnit};
use crate::error::Error;
use crate::words::{Unit, printable};

/// The fault of a scene's text, or of its questions.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Fault {
    /// Whether the text is no JSON, the JSON no scene, or a question impossible.
    pub kind: FaultKind,
    /// The reason, and the allowed values.
    pub message: String,
    /// The path of the field, `planar.contacts[1].friction`; `None` for the scene as a whole.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub field: Option<String>,
    /// The position in the text at which the JSON parser noticed the fault.
    #[serde(flatten)]
    pub at: Option<TextPosition>,
}

/// The kind of a fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum FaultKind {
    /// The text is no JSON.
    Syntax,
    /// The JSON is no scene.
    Scene,
    /// The grasp of the scene does not allow the question.
    Question,
    /// The scene made this library fail: a fault of the library and not of the scene.
    Internal,
}

/// A position in the text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct TextPosition {
    /// The line, counted from 1. The line is not written, since a scene of a stream is on one line.
    #[serde(skip)]
    pub line: usize,
    /// The column, counted from 1.
    pub column: usize,
}

impl std::error::Error for Fault {}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(TextPosition { line, column }) = self.at {
            write!(f, "line {line}, column {column}: ")?;
        }
        if let Some(field) = &self.field {
            write!(f, "{}: ", printable(field))?;
        }
        // The message may repeat any text of the input, also control characters; `printable` escapes these.
        f.write_str(&printable(&self.message))
    }
}

/// The outermost fields of a text that is no valid scene. They are read nevertheless, because a wrong format version explains all other faults, and
/// because the reply repeats the id.
#[derive(Deserialize)]
struct OutermostFields {
    format: Option<String>,
    id: Option<Id>,
}

/// The message of the JSON parser without the position in the text at its end; [`Fault::at`] holds this position.
pub(super) fn message_of(error: &serde_json::Error) -> String {
    let message = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    message.strip_suffix(&place).unwrap_or(&message).to_owned()
}

impl Fault {
    /// The fault of a text that the JSON parser could not read as a scene; `error` is the parser's error.
    fn of_reader(text: &[u8], error: &serde_json::Error) -> Self {
        // Some editors begin a file with a byte order mark.
        let unreadable = if text.starts_with(b"\xef\xbb\xbf") {
            Some("begins with a byte-order mark, must begin with {: save it as UTF-8 without one")
        } else if text.trim_ascii().is_empty() {
            Some("the text is empty, must be a scene; `grasp-lcp new gripper` writes one to begin with")
        } else {
            None
        };
        if let Some(message) = unreadable {
            let at = Some(TextPosition { line: 1, column: 1 });
            return Self { kind: FaultKind::Syntax, message: message.to_owned(), field: None, at };
        }
        // A wrong version is reported before all other faults, since another version may have any fields.
        let format = serde_json::from_slice::<OutermostFields>(text).ok().and_then(|outside| outside.format);
        if let Some(format) = format.filter(|format| format != FORMAT) {
            let message = format!("\"{format}\" is not a format that is read here, must be \"{FORMAT}\"");
            return Self { kind: FaultKind::Scene, message, field: Some("format".to_owned()), at: None };
        }
        let (line, column) = (error.line(), error.column());
        let at = (line > 0).then_some(TextPosition { line, column });
        let message = &message_of(error);
        let lines = text.split_inclusive(|byte| *byte == b'\n').take(line.saturating_sub(1));
        let read = text.len().min(lines.map(<[u8]>::len).sum::<usize>() + column);
        let field = faulty_field(text, read, error, message);
        let message = in_plain_words(message, text.get(read.saturating_sub(1)).copied());
        let kind = if error.is_data() { FaultKind::Scene } else { FaultKind::Syntax };
        Self { kind, message, field, at }
    }

    /// The id of a faulty scene, if it can be read.
    pub(crate) fn id_of(text: &[u8]) -> Option<Id> {
        serde_json::from_slice::<OutermostFields>(text).ok().and_then(|outside| outside.id)
    }

    /// A fault that concerns the scene as a whole, and no field of it.
    pub(crate) fn of_scene(message: String) -> Self {
        Self { kind: FaultKind::Scene, message, field: None, at: None }
    }

    /// The fault for a scene that made this library fail, with the message of the failure.
    pub(crate) fn internal(fault: &str) -> Self {
        let message =
            format!("internal: this scene made the library fail, which is a fault of the library ({fault})");
        Self { kind: FaultKind::Internal, message, field: None, at: None }
    }

    /// The fault of a question that the grasp refuses, with the message of this error.
    pub(crate) fn of_question(error: &Error) -> Self {
        Self { kind: FaultKind::Question, message: error.to_string(), field: None, at: None }
    }
}

impl Scene {
    /// A scene from [JSON](crate::scene), feature `json`.
    ///
    /// ```
    /// use grasp_lcp::scene::Scene;
    ///
    /// let fault = Scene::from_json(br#"{"format": "grasp-lcp/1", "planar": {"contacts": [{"point": [0, 0], "normal": "up"}]}}"#).unwrap_err();
    /// assert_eq!(fault.field.as_deref(), Some("planar.contacts[0].normal"));
    /// ```
    ///
    /// # Errors
    /// A [`Fault`] with the field, its position in the text and the allowed values.
    pub fn from_json(text: &[u8]) -> Result<Self, Fault> {
        let read = |text: &[u8]| {
            let SceneInTextUnit(scene) =
                serde_json::from_slice(text).map_err(|error| Fault::of_reader(text, &error))?;
            if scene.unit == Unit::Metre { Ok(scene) } else { in_metres(text, scene.unit) }
        };
        let mut scene = read(text);
        let may_lack = match &scene {
            Ok(scene) => scene.setup.shared_by_mass || scene.setup.gravity.is_some(),
            Err(fault) => fault.message.contains(ALONE),
        };
        if let Some(completed) = may_lack.then(|| with_centre_of_mass(text)).flatten() {
            // The completed text has masses and points that the user's text lacks. A position in it means nothing to the user, so the fault is given
            // without a position.
            scene = read(&completed).map_err(|fault| Fault { at: None, ..fault });
        }
        let scene = scene?;
        scene.setup.refuse_in_scene(text)?;
        Ok(scene)
    }
}
