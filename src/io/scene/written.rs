//! The outermost object of a scene: its version, its id, and a setup in the plane or in space. A setup is a grasp with its questions.

use std::fmt;

use serde::de::{Deserialize, Deserializer, Error as _, Unexpected, Visitor};
use serde::ser::{Serialize, Serializer};

use super::answer::Answer;
use super::setup::{PlanarSetup, Setup};
use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::{Face, Space, outside};
use crate::serial::{in_text_of, object};
use crate::words::{Unit, Words};

/// The version of the format that is written and read.
pub const FORMAT: &str = "grasp-lcp/1";

/// A grasp in the plane or in space, with its questions; see [the format](crate::scene). A scene is read from JSON or another self-describing format,
/// or made `from` a grasp or a [`Setup`].
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Scene {
    /// An identifier for the caller, which answers repeat; the crate does not interpret it.
    pub id: Option<Id>,
    /// A comment for the reader of the file.
    pub comment: Option<String>,
    /// The unit of lengths in the text that [`Scene::from_json`] has read. All lengths in this value are in m, and all lengths are written in m.
    pub unit: Unit,
    /// Contacts, questions and settings. Vectors have three components, in the plane too, where the third is zero. [`Scene::planar`] returns the
    /// setup with vectors of two components.
    pub setup: Setup<3>,
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

/// Read from a text or a whole number (feature `serde`), see [`crate::scene`].
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
pub struct Answers {
    space: Space,
    list: Vec<Answer<3>>,
}

impl Answers {
    /// The answers with vectors of three components, also in the plane, where the third is zero.
    #[must_use]
    pub fn list(&self) -> &[Answer<3>] {
        &self.list
    }

    /// The answers of a scene in the plane, with vectors of two components; `None` for a scene in space.
    #[inline]
    #[must_use]
    pub fn planar(self) -> Option<Vec<Answer<2>>> {
        (self.space == Space::Planar).then(|| outside(self.list))
    }

    /// The answers of a scene in space; `None` for a scene in the plane.
    #[must_use]
    pub fn spatial(self) -> Option<Vec<Answer<3>>> {
        (self.space == Space::Spatial).then_some(self.list)
    }
}

impl Serialize for Answers {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        in_text_of(self.space, || self.list.serialize(serializer))
    }
}

/// The schema of [`Answers`].
#[cfg(feature = "schema")]
#[derive(schemars::JsonSchema)]
#[schemars(rename = "Answers", untagged)]
#[expect(dead_code, reason = "describes a text")]
enum WrittenAnswers {
    /// Answers of a scene in the plane.
    Planar(Vec<Answer<2>>),
    /// Answers of a scene in space.
    Spatial(Vec<Answer<3>>),
}

#[cfg(feature = "schema")]
crate::serial::schema_as_written!("Answers", Answers, WrittenAnswers);

impl Scene {
    /// The answer to every question, in order. Sentences give lengths in the [unit](Self::unit) of the scene, all fields give them in m.
    ///
    /// # Errors
    /// An [`Error`] for a malformed setup or question. That no equilibrium exists is an answer.
    pub fn answers(&self) -> Result<Answers, Error> {
        self.answers_in(Words::default().in_unit(self.unit))
    }

    /// The answer to every question, in order. `words` determines digits and units of the numbers in sentences.
    ///
    /// # Errors
    /// An [`Error`] for a malformed setup or question. That no equilibrium exists is an answer.
    pub fn answers_in(&self, words: Words) -> Result<Answers, Error> {
        let list = self.setup.answered(words)?;
        Ok(Answers { space: self.setup.space, list })
    }

    /// The setup of a scene in the plane, with vectors of two components; `None` for a scene in space.
    #[inline]
    #[must_use]
    pub fn planar(&self) -> Option<Setup<2>> {
        (self.setup.space == Space::Planar).then(|| outside(self.setup.clone()))
    }

    /// The setup of a scene in space; `None` for a scene in the plane.
    #[must_use]
    pub fn spatial(&self) -> Option<Setup<3>> {
        (self.setup.space == Space::Spatial).then(|| self.setup.clone())
    }
}

impl<const C: usize> From<Setup<C>> for Scene {
    fn from(setup: Setup<C>) -> Self {
        Self { id: None, comment: None, unit: Unit::Metre, setup: setup.into_inside() }
    }
}

impl<const C: usize> From<&Grasp<C>> for Scene {
    fn from(grasp: &Grasp<C>) -> Self {
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
struct SceneText<'a> {
    format: Format,
    #[serde(skip_serializing_if = "Option::is_none")]
    id: Option<&'a Id>,
    #[serde(skip_serializing_if = "Option::is_none")]
    comment: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    planar: Option<&'a Setup<3>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    spatial: Option<&'a Setup<3>>,
}

#[derive(serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(extend("oneOf" = [{ "required": ["planar"] }, { "required": ["spatial"] }])))]
#[serde(deny_unknown_fields)]
struct SceneFields {
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
    #[cfg_attr(feature = "schema", schemars(with = "Option<Setup<2>>"))]
    planar: Option<PlanarSetup>,
    /// The grasp in space.
    spatial: Option<Setup<3>>,
}

impl Serialize for Scene {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { id, comment, setup, .. } = self;
        let only = |space: Space| Some(setup).filter(|setup| setup.space == space);
        let (planar, spatial) = (only(Space::Planar), only(Space::Spatial));
        let (id, comment) = (id.as_ref(), comment.as_deref());
        SceneText { format: Format, id, comment, planar, spatial }.serialize(serializer)
    }
}

/// A scene whose lengths are not yet converted to m: they are in the unit of its text.
pub(super) struct SceneInTextUnit(pub(super) Scene);

impl<'de> Deserialize<'de> for SceneInTextUnit {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        object::read(
            deserializer,
            "a scene",
            |SceneFields { format, id, comment, unit, planar, spatial, .. }| {
                if format.is_none() {
                    return Err(format!("missing field `format`: write \"format\": \"{FORMAT}\""));
                }
                let setup = match (planar, spatial) {
                    (Some(PlanarSetup(setup)), None) | (None, Some(setup)) => setup,
                    (None, None) => return Err("missing field `planar` or `spatial`".to_owned()),
                    (Some(_), Some(_)) => {
                        return Err("planar and spatial: a scene has one of them".to_owned());
                    }
                };
                Ok(Self(Scene { id, comment, unit: unit.unwrap_or_default(), setup }))
            },
        )
    }
}

/// Refuses lengths in another unit than m, which only [`Scene::from_json`] converts.
impl<'de> Deserialize<'de> for Scene {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let SceneInTextUnit(scene) = SceneInTextUnit::deserialize(deserializer)?;
        match scene.unit {
            Unit::Metre => Ok(scene),
            unit => Err(D::Error::custom(format_args!(
                "unit: {unit} is read by Scene::from_json, must be m here"
            ))),
        }
    }
}

#[cfg(feature = "schema")]
crate::serial::schema_as_written!("Scene", Scene, SceneFields);
