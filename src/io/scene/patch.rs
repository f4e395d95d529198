//! Soft fingertips in the file: kind, size and resolution of their patch.

use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::grasp::{Pressure, SoftFingertip};

/// The patch of a [`SoftFingertip`]: rings, discs and rectangles in space, pairs and pads in the plane. It is written as
/// `{"disc": {"radius": 0.006, …}}`. The functions named below state the allowed numbers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Tip {
    /// [`SoftFingertip::ring`].
    Ring {
        /// Radius of the ring, m.
        radius: f64,
        /// Number of points on the ring.
        points: usize,
    },
    /// [`SoftFingertip::disc`].
    Disc {
        /// Radius of the disc, m.
        radius: f64,
        /// Number of annuli of equal width, two rings of points each.
        annuli: usize,
        /// Number of points on each ring.
        points: usize,
        /// The pressure profile; uniform if left out.
        #[serde(default)]
        pressure: Pressure,
    },
    /// [`SoftFingertip::rectangle`].
    Rectangle {
        /// Sides along the first and the second tangent, m.
        sides: [f64; 2],
        /// Number of strips in half of each side, two points each; one for each side if left out.
        #[serde(default = "one_each")]
        strips: [usize; 2],
    },
    /// [`SoftFingertip::pair`].
    Pair {
        /// Width of the pad, m; its two points are at the edges.
        width: f64,
    },
    /// [`SoftFingertip::pad`].
    Pad {
        /// Width of the pad from edge to edge, m.
        width: f64,
        /// Number of strips of equal width on either side of the middle, two points each.
        strips: usize,
        /// The pressure profile; uniform if left out.
        #[serde(default)]
        pressure: Pressure,
    },
}

const fn one_each() -> [usize; 2] {
    [1, 1]
}

impl Tip {
    /// The patch of points that takes the place of a contact.
    ///
    /// # Errors
    /// [`Error::Fingertip`] for a number out of range, and for a patch of the plane in space or the reverse.
    pub fn spread<const C: usize>(&self) -> Result<SoftFingertip<C>, Error> {
        let patch = match *self {
            Self::Ring { radius, points } => SoftFingertip::ring(radius, points)?.of_axes(),
            Self::Disc { radius, annuli, points, pressure } => {
                SoftFingertip::disc(radius, annuli, points, pressure)?.of_axes()
            }
            Self::Rectangle { sides, strips } => SoftFingertip::rectangle(sides, strips)?.of_axes(),
            Self::Pair { width } => SoftFingertip::pair(width)?.of_axes(),
            Self::Pad { width, strips, pressure } => SoftFingertip::pad(width, strips, pressure)?.of_axes(),
        };
        patch.ok_or(Error::Fingertip {
            what: "number of axes of the patch",
            value: if C == 2 { 3.0 } else { 2.0 },
            allowed: if C == 2 { "2: a pair or a pad" } else { "3: a ring, a disc or a rectangle" },
        })
    }
}
