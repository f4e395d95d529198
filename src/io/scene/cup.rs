//! Suction in the text of a scene: a force, or a suction cup.

use std::fmt;

use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, Deserializer, Error as _, MapAccess, Visitor};
use serde::ser::{Serialize, Serializer};

use crate::error::Error;
use crate::grasp::{Space, SuctionCup};

/// A suction cup of a scene, `"suction": {"radius": 0.02, "pressure": 60000}`; see [`SuctionCup`]. Only a contact in space may have a cup, in place
/// of a soft fingertip.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
#[must_use]
pub struct Cup {
    /// Radius of the lip, m.
    pub radius: f64,
    /// Number of contact points on the lip; 12 if left out.
    #[serde(default = "twelve")]
    pub points: usize,
    /// Pressure of the surrounding air minus the pressure in the cup, Pa.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pressure: Option<f64>,
    /// The force of the vacuum, N, instead of the pressure.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force: Option<f64>,
}

const fn twelve() -> usize {
    12
}

impl Cup {
    /// A cup with a lip of this radius, m, in which the pressure is lower than the pressure of the surrounding air by `pressure`, Pa.
    pub fn of_pressure(radius: f64, pressure: f64) -> Self {
        Self { radius, points: twelve(), pressure: Some(pressure), force: None }
    }

    /// A cup with a lip of this radius, m, that pulls with this force, N.
    pub fn of_force(radius: f64, force: f64) -> Self {
        Self { radius, points: twelve(), pressure: None, force: Some(force) }
    }

    /// This cup of a scene, converted to a [`SuctionCup`] of a grasp.
    ///
    /// # Errors
    /// [`Error::Fingertip`] for a number out of range, for a cup in the plane, and unless exactly one of pressure and force is given.
    pub(super) fn made(&self, space: Space) -> Result<SuctionCup, Error> {
        if space == Space::Planar {
            let (what, allowed) = ("number of axes of the cup", "2: a force, N, as a number");
            return Err(Error::Fingertip { what, value: 3.0, allowed });
        }
        match (self.pressure, self.force) {
            (Some(pressure), None) => SuctionCup::of_pressure(self.radius, self.points, pressure),
            (None, Some(force)) => SuctionCup::of_force(self.radius, self.points, force),
            (pressure, force) => Err(Error::Fingertip {
                what: "number of pressure and force of the cup",
                value: f64::from(u8::from(pressure.is_some()) + u8::from(force.is_some())),
                allowed: "1: give one of them",
            }),
        }
    }
}

/// The field `suction`: the force of a vacuum, or a suction cup.
pub(super) enum WrittenSuction {
    /// Force of the vacuum, N.
    Force(f64),
    Cup(Cup),
}

impl Serialize for WrittenSuction {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Force(force) => serializer.serialize_f64(*force),
            Self::Cup(cup) => cup.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for WrittenSuction {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NumberOrCup)
    }
}

struct NumberOrCup;

impl<'de> Visitor<'de> for NumberOrCup {
    type Value = WrittenSuction;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a force, N, or a cup such as {\"radius\": 0.02, \"pressure\": 60000}")
    }

    fn visit_f64<E: serde::de::Error>(self, force: f64) -> Result<WrittenSuction, E> {
        if force.is_finite() {
            Ok(WrittenSuction::Force(force))
        } else {
            Err(E::custom("a force must be finite"))
        }
    }

    fn visit_u64<E: serde::de::Error>(self, force: u64) -> Result<WrittenSuction, E> {
        self.visit_f64(force as f64)
    }

    fn visit_i64<E: serde::de::Error>(self, force: i64) -> Result<WrittenSuction, E> {
        self.visit_f64(force as f64)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<WrittenSuction, A::Error> {
        let cup = Cup::deserialize(MapAccessDeserializer::new(map))?;
        if cup.pressure.is_some() == cup.force.is_some() {
            return Err(A::Error::custom("a cup has a pressure or a force, give one of them"));
        }
        Ok(WrittenSuction::Cup(cup))
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for WrittenSuction {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Suction".into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let cup = generator.subschema_for::<Cup>();
        schemars::json_schema!({ "anyOf": [{ "type": "number", "minimum": 0 }, cup] })
    }
}
