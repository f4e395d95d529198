//! One body of a scene with several bodies.

use crate::numerics::{IntoList, mapped};
use std::sync::Arc;

use nalgebra::SVector;
use serde::de::{Deserialize, Deserializer};
use serde::ser::{Serialize, Serializer};

use crate::grasp::{Body, Wrench};
use crate::serial::{AsGiven, AxisRow, Given, object};

/// A body of a scene: its name, its mass and constant load, and its outline for pictures; see [`Bodies`](crate::grasp::Bodies).
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct BodySetup<const C: usize> {
    /// The name of the body for contacts and answers.
    pub name: Arc<str>,
    /// A comment for the reader of the file.
    pub comment: Option<String>,
    /// The mass of the body, kg.
    pub mass: f64,
    /// The centre of mass, m.
    pub centre_of_mass: SVector<f64, C>,
    /// A constant load on the body, in addition to its weight and the loads of questions.
    pub load: Wrench<C>,
    /// The corners of the body in order, m; only drawn.
    pub outline: Vec<SVector<f64, C>>,
}

/// A body in the file.
#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
struct Written<const C: usize> {
    /// The name of the body for contacts and answers.
    name: Arc<str>,
    /// A comment for the reader of the file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    comment: Option<String>,
    /// The mass of the body, kg; 0 if left out.
    #[serde(default, with = "AsGiven::<Option<f64>>", skip_serializing_if = "Option::is_none")]
    mass: Option<f64>,
    /// The centre of mass, m; the origin if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    centre_of_mass: Option<AxisRow<Given, C>>,
    /// A constant load on the body, in addition to its weight and the loads of questions; zero if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    load: Option<Wrench<C>>,
    /// The corners of the body in order, m; only drawn.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    outline: Vec<AxisRow<Given, C>>,
}

impl<const C: usize> Serialize for BodySetup<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let at_origin = self.centre_of_mass.iter().all(|x| *x == 0.0);
        Written {
            name: self.name.clone(),
            comment: self.comment.clone(),
            mass: (self.mass != 0.0).then_some(self.mass),
            centre_of_mass: (!at_origin).then(|| AxisRow::new(self.centre_of_mass)),
            load: (self.load != Wrench::ZERO).then_some(self.load),
            outline: self.outline.iter().copied().map(AxisRow::new).list(),
        }
        .serialize(serializer)
    }
}

impl<'de, const C: usize> Deserialize<'de> for BodySetup<C> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        object::read(deserializer, "a body", |written: Written<C>| {
            Ok(Self {
                name: written.name,
                comment: written.comment,
                mass: written.mass.unwrap_or(0.0),
                centre_of_mass: written.centre_of_mass.map_or_else(SVector::zeros, |row| row.0),
                load: written.load.unwrap_or(Wrench::ZERO),
                outline: mapped(&written.outline, &|row| row.0),
            })
        })
    }
}

impl<const C: usize> BodySetup<C> {
    /// A body with this name, without mass, load and outline.
    pub fn new(name: impl Into<String>) -> Self {
        Self {
            name: name.into().into(),
            comment: None,
            mass: 0.0,
            centre_of_mass: SVector::zeros(),
            load: Wrench::ZERO,
            outline: Vec::new(),
        }
    }

    /// Converts this entry of the file to a [`Body`] for a grasp.
    pub(super) fn body(&self) -> Body<C> {
        Body::new(&*self.name).mass(self.mass, self.centre_of_mass).load(self.load)
    }
}

#[cfg(feature = "schema")]
crate::serial::schema_as_written!("Body", BodySetup<C>, Written<C>, C);
