//! Reads scenes in JSON, and says of bad ones where and why.
#![allow(dead_code, reason = "each user needs a part of it")]

use std::fmt;
use std::path::Path;

use grasp_lcp::scene::{FORMAT, Id, Scene};
use serde::Deserialize;
use serde_path_to_error::Track;

/// What is wrong with the text of a scene.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub(crate) struct Fault {
    /// No JSON at all, JSON that is no scene, or a scene that asks what cannot be asked.
    pub(crate) kind: Kind,
    /// Why, and what is allowed.
    pub(crate) message: String,
    /// The field, `planar.contacts[1].friction`; of the whole scene if there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) field: Option<String>,
    /// Where reading had come to when it was noticed.
    #[serde(flatten)]
    pub(crate) at: Option<At>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Kind {
    Syntax,
    Scene,
    Question,
}

/// Line and column, from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub(crate) struct At {
    /// A scene on one line of many does not say it.
    #[serde(skip)]
    pub(crate) line: usize,
    pub(crate) column: usize,
}

impl std::error::Error for Fault {}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(At { line, column }) = self.at {
            write!(f, "line {line}, column {column}: ")?;
        }
        if let Some(field) = &self.field {
            write!(f, "{field}: ")?;
        }
        f.write_str(&self.message)
    }
}

/// What can be read of a scene that cannot be read as a whole.
#[derive(Deserialize)]
struct Outside {
    format: Option<String>,
    id: Option<Id>,
}

impl Fault {
    fn new(text: &[u8], error: &serde_path_to_error::Error<serde_json::Error>) -> Self {
        let inner = error.inner();
        let (line, column) = (inner.line(), inner.column());
        let at = (line > 0).then_some(At { line, column });
        // Whatever a scene of another version has in it, the version comes first.
        let format = serde_json::from_slice::<Outside>(text).ok().and_then(|outside| outside.format);
        if let Some(format) = format.filter(|format| format != FORMAT) {
            let message = format!("\"{format}\" is not a format that is read here, must be \"{FORMAT}\"");
            return Self { kind: Kind::Scene, message, field: Some("format".to_owned()), at: None };
        }
        let message = inner.to_string();
        let position = format!(" at line {line} column {column}");
        let message = message.strip_suffix(&position).unwrap_or(&message).to_owned();
        let field = Some(error.path().to_string()).filter(|path| path != ".");
        let kind = if inner.is_data() { Kind::Scene } else { Kind::Syntax };
        Self { kind, message, field, at }
    }

    /// Of a line that is not even looked at.
    pub(crate) fn of_line(message: String) -> Self {
        Self { kind: Kind::Scene, message, field: None, at: None }
    }

    /// A question that the grasp refuses.
    pub(crate) fn of_question(error: &grasp_lcp::Error) -> Self {
        Self { kind: Kind::Question, message: error.to_string(), field: None, at: None }
    }
}

/// A scene from JSON.
pub(crate) fn parse(text: &[u8]) -> Result<Scene, Fault> {
    // Which field is read is kept track of only where it matters.
    serde_json::from_slice(text).or_else(|_| parse_on_track(text))
}

fn parse_on_track(text: &[u8]) -> Result<Scene, Fault> {
    let mut json = serde_json::Deserializer::from_slice(text);
    let mut track = Track::new();
    let scene = Scene::deserialize(serde_path_to_error::Deserializer::new(&mut json, &mut track));
    scene
        .and_then(|scene| json.end().map(|()| scene))
        .map_err(|error| Fault::new(text, &serde_path_to_error::Error::new(track.path(), error)))
}

/// The id of a scene that cannot be read as a whole, if that much can be read.
pub(crate) fn id_of(text: &[u8]) -> Option<Id> {
    serde_json::from_slice::<Outside>(text).ok().and_then(|outside| outside.id)
}

/// A scene from a file; a message about it begins with its name.
pub(crate) fn read(path: &Path) -> Result<Scene, String> {
    let name = path.display();
    let text = std::fs::read(path).map_err(|error| format!("{name}: {error}"))?;
    parse(&text).map_err(|fault| format!("{name}: {fault}"))
}
