//! Units of length: of scenes and of the sentences about them, of meshes (whose files name no unit) and of command lines.

use core::fmt;

/// The unit of lengths in a file or on a command line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Unit {
    /// Metres.
    #[default]
    #[cfg_attr(feature = "serde", serde(rename = "m"))]
    Metre,
    /// Centimetres.
    #[cfg_attr(feature = "serde", serde(rename = "cm"))]
    Centimetre,
    /// Millimetres, the unit of most CAD files.
    #[cfg_attr(feature = "serde", serde(rename = "mm"))]
    Millimetre,
    /// Inches of 25.4 mm.
    #[cfg_attr(feature = "serde", serde(rename = "in"))]
    Inch,
}

impl Unit {
    /// A length in this unit, converted to m. Division by 1000 yields the nearest double to the decimal fraction; multiplication by 0.001 would
    /// not.
    #[must_use]
    pub fn in_metres(self, length: f64) -> f64 {
        match self {
            Self::Metre => length,
            Self::Centimetre => length / 100.0,
            Self::Millimetre => length / 1000.0,
            Self::Inch => length * 0.0254,
        }
    }

    /// A length of this many metres, in this unit.
    pub(crate) fn of_metres(self, metres: f64) -> f64 {
        match self {
            Self::Metre => metres,
            Self::Centimetre => metres * 100.0,
            Self::Millimetre => metres * 1000.0,
            Self::Inch => metres / 0.0254,
        }
    }

    /// The unit of this abbreviation: m, cm, mm or in; `None` for any other text.
    #[must_use]
    pub fn of(abbreviation: &str) -> Option<Self> {
        match abbreviation {
            "m" => Some(Self::Metre),
            "cm" => Some(Self::Centimetre),
            "mm" => Some(Self::Millimetre),
            "in" => Some(Self::Inch),
            _ => None,
        }
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Metre => "m",
            Self::Centimetre => "cm",
            Self::Millimetre => "mm",
            Self::Inch => "in",
        })
    }
}
