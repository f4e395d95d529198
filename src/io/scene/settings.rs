//! Settings in the text of a scene; settings that the scene does not give have the crate's defaults. A leg is a section of a load program. The load
//! factor is the multiple of a growing load. A polygonal cone approximates the round friction cone by plane facets.

use serde::de::{Deserialize, Deserializer};
use serde::ser::{Serialize, Serializer};

use crate::contact::{PolygonCone, PolygonFit};
use crate::equilibrium::{Settings, SmallMotions};
use crate::error::is_moderate;
use crate::serial::object;

/// Written as `{"facets": 8, "fit": "inscribed"}` (feature `serde`), see [`crate::scene`].
impl Serialize for PolygonCone {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        WrittenPolygon { facets: self.facets(), fit: self.fit() }.serialize(serializer)
    }
}

/// Read from `{"facets": 8, "fit": "inscribed"}`, both optional (feature `serde`), see [`crate::scene`]. Refuses numbers of facets that
/// [`PolygonCone::new`] refuses.
impl<'de> Deserialize<'de> for PolygonCone {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        object::read(deserializer, "a polygon", |WrittenPolygon { facets, fit }| {
            Self::new(facets, fit).map_err(|error| error.to_string())
        })
    }
}

#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
struct WrittenPolygon {
    /// Number of facets of the polygonal friction cone.
    facets: usize,
    /// Whether the polygonal cone is inscribed in the round cone, circumscribed about it, or balanced between both.
    fit: PolygonFit,
}

impl Default for WrittenPolygon {
    fn default() -> Self {
        let cone = PolygonCone::default();
        Self { facets: cone.facets(), fit: cone.fit() }
    }
}

/// The friction cone of answers in space: round, or the polygonal cone itself.
#[derive(Clone, Copy, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
enum Cone {
    Round,
    Polygon,
}

#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
struct WrittenSettings {
    /// The friction cone of answers, round or polygonal; in space only.
    cone: Cone,
    /// The polygonal cone that replaces the round cone where a solver needs facets.
    polygon: PolygonCone,
    /// Largest number of pivots of Lemke's method; set by the size of the problem if left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    max_pivots: Option<usize>,
    /// Largest number of combinations of contact states to try.
    most_states: usize,
    /// Relative error of one step along a sliding arc, a piece of a load path on which slip directions turn.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 1)))]
    step_error: f64,
    /// Largest number of integration steps within a leg of a load path, on sliding arcs (pieces on which slip directions turn). Also the largest
    /// number of jumps from static to kinetic friction within a leg.
    most_steps: usize,
    /// The largest load factor up to which `hold` searches for the loss of equilibrium.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    most_load: f64,
    /// Largest number of cycles of a repeated load that are computed.
    most_cycles: usize,
    /// The rotation and the slip up to which motions count as small.
    small_motions: SmallMotions,
}

impl Default for WrittenSettings {
    fn default() -> Self {
        Self::from(&Settings::default())
    }
}

impl From<&Settings> for WrittenSettings {
    fn from(settings: &Settings) -> Self {
        Self {
            cone: if settings.round { Cone::Round } else { Cone::Polygon },
            polygon: settings.cone,
            max_pivots: settings.max_pivots,
            most_states: settings.most_states,
            step_error: settings.step_error,
            most_steps: settings.most_steps,
            most_load: settings.most_load,
            most_cycles: settings.most_cycles,
            small_motions: settings.small_motions,
        }
    }
}

/// Written as
/// `{"cone": "round", "polygon": …, "max_pivots": …, "most_states": …, "step_error": …, "most_steps": …, "most_load": …, "most_cycles": …, "small_motions": …}`
/// (feature `serde`), see [`crate::scene`].
impl Serialize for Settings {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        WrittenSettings::from(self).serialize(serializer)
    }
}

/// Read from an object whose fields are all optional (feature `serde`), see [`crate::scene`].
impl<'de> Deserialize<'de> for Settings {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        object::read(deserializer, "settings", |written: WrittenSettings| {
            let WrittenSettings { cone, polygon, max_pivots, most_states, step_error, most_steps, .. } =
                written;
            let WrittenSettings { most_load, most_cycles, small_motions, .. } = written;
            if !(step_error > 0.0 && step_error < 1.0) {
                return Err(format!("step_error is {step_error}, must be between 0 and 1"));
            }
            if !(most_load > 0.0 && is_moderate(most_load)) {
                return Err(format!("most_load is {most_load}, must be more than 0 and at most 1e50"));
            }
            small_motions.check().map_err(|error| error.to_string())?;
            let round = matches!(cone, Cone::Round);
            let polygonal = Self { cone: polygon, round, max_pivots, most_states, ..Self::default() };
            Ok(Self { step_error, most_steps, most_load, most_cycles, small_motions, ..polygonal })
        })
    }
}

#[cfg(feature = "schema")]
crate::serial::schema_as_written!("PolygonCone", PolygonCone, WrittenPolygon);
#[cfg(feature = "schema")]
crate::serial::schema_as_written!("Settings", Settings, WrittenSettings);
