//! The whole of a scene: its version, its id, and its plane or space.

use std::fmt;

use serde::de::{Deserialize, Deserializer, Error as _, Unexpected, Visitor};
use serde::ser::{Serialize, Serializer};

use super::answer::Answer;
use super::setup::Setup;
use crate::error::Error;
use crate::grasp::all_inside;
use crate::numerics;
use crate::serial::{in_text_of, object};
use crate::words::{Unit, Words};
use crate::{planar, spatial};

/// The version of the format that is written and read.
pub const FORMAT: &str = "grasp-lcp/1";

/// A grasp in the plane or in space, with its questions; see [the format](crate::scene). It is read from JSON or another self-describing
/// format, or made `from` a grasp or a [`Setup`].
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Scene {
    /// An identifier for the caller, which answers repeat; the crate does not interpret it.
    pub id: Option<Id>,
    /// A comment for the reader of the file.
    pub comment: Option<String>,
    /// The unit of lengths in the text that [`Scene::from_json`] has read. In this value, and where it is written, lengths are in m.
    pub unit: Unit,
    /// Contacts, questions and settings.
    pub space: Space,
}

/// A scene in the plane or in space.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Space {
    /// 3 degrees of freedom, 2 axes of a contact.
    Planar(Setup<2>),
    /// 6 degrees of freedom, 3 axes of a contact.
    Spatial(Setup<3>),
}

/// The caller's identifier of a scene; answers repeat it.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum Id {
    /// A whole number.
    Number(i64),
    /// A string.
    Text(String),
}

/// A text or a whole number (feature `serde`), see [`crate::scene`].
impl<'de> Deserialize<'de> for Id {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(IdVisitor)
    }
}

struct IdVisitor;

impl Visitor<'_> for IdVisitor {
    type Value = Id;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a text or a whole number")
    }

    fn visit_i64<E: serde::de::Error>(self, number: i64) -> Result<Id, E> {
        Ok(Id::Number(number))
    }

    fn visit_u64<E: serde::de::Error>(self, number: u64) -> Result<Id, E> {
        let small = i64::try_from(number).map(Id::Number);
        small.map_err(|_| E::invalid_value(Unexpected::Unsigned(number), &"a number below 2^63"))
    }

    fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Id, E> {
        Ok(Id::Text(text.to_owned()))
    }
}

/// The answers to the questions of a scene, in their order. They are written as a list.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(untagged))]
pub enum Answers {
    /// Answers of a scene in the plane.
    Planar(Vec<Answer<2>>),
    /// Answers of a scene in space.
    Spatial(Vec<Answer<3>>),
}

impl Answers {
    /// Number of answers.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::Planar(list) => list.len(),
            Self::Spatial(list) => list.len(),
        }
    }

    /// Whether the scene has no questions.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl Serialize for Answers {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Planar(list) => write_all(numerics::Space::Planar, &all_inside(list), serializer),
            Self::Spatial(list) => write_all(numerics::Space::Spatial, list, serializer),
        }
    }
}

/// Answers whose vectors have three components, even if they are planar. They are written like [`Answers`].
#[cfg(feature = "json")]
pub(crate) struct AnswersInside(pub(crate) numerics::Space, pub(crate) Vec<Answer<3>>);

#[cfg(feature = "json")]
impl Serialize for AnswersInside {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        write_all(self.0, &self.1, serializer)
    }
}

fn write_all<S: Serializer>(
    space: numerics::Space,
    list: &[Answer<3>],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    in_text_of(space, || list.serialize(serializer))
}

impl Scene {
    /// The answer to every question, in order. Sentences have lengths in the [unit](Self::unit) of the scene, all fields have them in m.
    ///
    /// # Errors
    /// As for [`Setup::answers`].
    pub fn answers(&self) -> Result<Answers, Error> {
        self.answers_in(Words::default().in_unit(self.unit))
    }

    /// The answer to every question, in order, with numbers in its sentences of this form.
    ///
    /// # Errors
    /// As for [`Setup::answers`].
    pub fn answers_in(&self, words: Words) -> Result<Answers, Error> {
        match &self.space {
            Space::Planar(setup) => setup.answers_in(words).map(Answers::Planar),
            Space::Spatial(setup) => setup.answers_in(words).map(Answers::Spatial),
        }
    }
}

impl From<Space> for Scene {
    fn from(space: Space) -> Self {
        Self { id: None, comment: None, unit: Unit::Metre, space }
    }
}

impl From<Setup<2>> for Scene {
    fn from(setup: Setup<2>) -> Self {
        Space::Planar(setup).into()
    }
}

impl From<Setup<3>> for Scene {
    fn from(setup: Setup<3>) -> Self {
        Space::Spatial(setup).into()
    }
}

impl From<&planar::Grasp> for Scene {
    fn from(grasp: &planar::Grasp) -> Self {
        Setup::from(grasp).into()
    }
}

impl From<&spatial::Grasp> for Scene {
    fn from(grasp: &spatial::Grasp) -> Self {
        Setup::from(grasp).into()
    }
}

/// The version of the format.
pub(super) struct Format;

impl Serialize for Format {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(FORMAT)
    }
}

impl<'de> Deserialize<'de> for Format {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let given = String::deserialize(deserializer)?;
        if given == FORMAT {
            return Ok(Self);
        }
        Err(D::Error::custom(format_args!(
            "\"{given}\" is not a format that is read here, must be \"{FORMAT}\""
        )))
    }
}

#[derive(serde::Serialize)]
struct Out<'a> {
    format: Format,
    #[serde(skip_serializing_if = "Option::is_none")]
    id: Option<&'a Id>,
    #[serde(skip_serializing_if = "Option::is_none")]
    comment: Option<&'a str>,
    #[serde(flatten)]
    space: &'a Space,
}

#[derive(serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(extend("oneOf" = [{ "required": ["planar"] }, { "required": ["spatial"] }])))]
#[serde(deny_unknown_fields)]
struct In {
    /// The place where an editor finds the schema; the crate ignores it.
    #[serde(default, rename = "$schema")]
    _schema: Option<String>,
    /// The version of the format.
    #[cfg_attr(feature = "schema", schemars(required))]
    format: Option<Format>,
    /// An identifier that the answer repeats.
    id: Option<Id>,
    /// A comment for the reader of the file.
    comment: Option<String>,
    /// The unit of lengths, m if left out; all other quantities stay in SI units.
    unit: Option<Unit>,
    /// The grasp in the plane.
    planar: Option<Setup<2>>,
    /// The grasp in space.
    spatial: Option<Setup<3>>,
}

impl Serialize for Scene {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { id, comment, space, .. } = self;
        Out { format: Format, id: id.as_ref(), comment: comment.as_deref(), space }.serialize(serializer)
    }
}

/// A scene whose lengths are not yet converted to m: they are in the unit of its text.
pub(super) struct InItsUnit(pub(super) Scene);

impl<'de> Deserialize<'de> for InItsUnit {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        object::read(deserializer, "a scene", |In { format, id, comment, unit, planar, spatial, .. }| {
            if format.is_none() {
                return Err(format!("missing field `format`: write \"format\": \"{FORMAT}\""));
            }
            let space = match (planar, spatial) {
                (Some(setup), None) => Space::Planar(setup),
                (None, Some(setup)) => Space::Spatial(setup),
                (None, None) => return Err("missing field `planar` or `spatial`".to_owned()),
                (Some(_), Some(_)) => return Err("planar and spatial: a scene has one of them".to_owned()),
            };
            Ok(Self(Scene { id, comment, unit: unit.unwrap_or_default(), space }))
        })
    }
}

/// Refuses lengths in another unit than m, which only [`Scene::from_json`] converts.
impl<'de> Deserialize<'de> for Scene {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let InItsUnit(scene) = InItsUnit::deserialize(deserializer)?;
        match scene.unit {
            Unit::Metre => Ok(scene),
            unit => Err(D::Error::custom(format_args!(
                "unit: {unit} is read by Scene::from_json, must be m here"
            ))),
        }
    }
}

#[cfg(feature = "schema")]
crate::serial::schema_as_written!("Scene", Scene, In);
