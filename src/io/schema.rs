//! JSON Schemas of scenes and of answers to them (feature `schema`).

use schemars::Schema as Parts;
use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use serde_json::Value;

use crate::scene::{Answers, Scene};
use crate::stream::Reply;

/// A kind of text that has a JSON Schema (draft 2020-12). The schema contains fields, lengths of rows and ranges of numbers. It cannot check the
/// length of a list against another list, such as commands against contacts; this length is checked when a [`Scene`] is read.
///
/// An editor completes and checks a scene that names the file of its schema: `"$schema": "scene.schema.json"`.
///
/// ```
/// use grasp_lcp::schema::Schema;
///
/// let schema = Schema::Scene.to_json();
/// let contact = &schema["$defs"]["Contact"];
/// assert_eq!(contact["required"], serde_json::json!(["point", "normal"]));
/// assert_eq!(contact["properties"]["point"]["maxItems"], 2);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Schema {
    /// The schema of a [`Scene`].
    Scene,
    /// The schema of the [`Answers`] to a scene, which form a list.
    Answers,
    /// The schema of one line of output of the [stream](crate::stream).
    Reply,
}

impl Schema {
    /// The schema as JSON.
    #[must_use]
    pub fn to_json(self) -> Value {
        let settings = SchemaSettings::draft2020_12().with_transform(RecursiveTransform(plain));
        match self {
            Self::Scene => settings.into_generator().into_root_schema_for::<Scene>(),
            Self::Answers => settings.for_serialize().into_generator().into_root_schema_for::<Answers>(),
            Self::Reply => settings.for_serialize().into_generator().into_root_schema_for::<Reply>(),
        }
        .into()
    }
}

/// Shortens a description, which schemars takes from the doc comment, to its first paragraph, and removes links.
fn plain(schema: &mut Parts) {
    if let Some(Value::String(text)) = schema.get_mut("description") {
        let first = text.split("\n\n").next().unwrap_or_default().replace('\n', " ");
        *text = without_links(&first);
    }
}

/// Removes the brackets and the address of links to names in backquotes; the name stays.
fn without_links(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, linked)) = rest.split_once("[`") {
        plain.push_str(before);
        let Some((name, behind)) = linked.split_once("`]") else {
            rest = &rest[before.len()..];
            break;
        };
        plain.push('`');
        plain.push_str(name);
        plain.push('`');
        rest = match behind.strip_prefix('(').and_then(|address| address.split_once(')')) {
            Some((_, behind)) => behind,
            None => behind,
        };
    }
    plain.push_str(rest);
    plain
}
