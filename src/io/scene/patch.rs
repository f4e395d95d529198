//! Soft fingertips in the text of a scene: shape, size and number of points of their patch. A patch is an area of contact points that takes the place
//! of a single contact.

use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::grasp::{Face, Pressure, SoftFingertip, Space};

/// The patch of a [`SoftFingertip`]: rings, discs and rectangles in space, pairs and pads in the plane. A patch is written as
/// `{"disc": {"radius": 0.006, …}}`. The function that a variant names documents the allowed numbers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
#[non_exhaustive]
pub enum FingertipPatch {
    /// A ring of points; see [`SoftFingertip::ring`].
    Ring {
        /// Radius of the ring, m.
        radius: f64,
        /// Number of points on the ring.
        points: usize,
    },
    /// A disc; see [`SoftFingertip::disc`].
    Disc {
        /// Radius of the disc, m.
        radius: f64,
        /// Number of annuli of equal width, with two rings of points each.
        annuli: usize,
        /// Number of points on each ring.
        points: usize,
        /// The pressure profile; uniform if left out.
        #[serde(default)]
        pressure: Pressure,
    },
    /// A rectangle; see [`SoftFingertip::rectangle`].
    Rectangle {
        /// Sides along the first and the second tangent, m.
        sides: [f64; 2],
        /// Number of strips in half of each side, with two points on each strip; one strip for each side if left out.
        #[serde(default = "one_each")]
        strips: [usize; 2],
    },
    /// A pair of points; see [`SoftFingertip::pair`].
    Pair {
        /// Width of the pad, m; its two points are at the edges.
        width: f64,
    },
    /// A straight pad; see [`SoftFingertip::pad`].
    Pad {
        /// Width of the pad from edge to edge, m.
        width: f64,
        /// Number of strips of equal width on either side of the middle, with two points each.
        strips: usize,
        /// The pressure profile; uniform if left out.
        #[serde(default)]
        pressure: Pressure,
    },
}

const fn one_each() -> [usize; 2] {
    [1, 1]
}

impl FingertipPatch {
    /// The patch of points that takes the place of a contact.
    ///
    /// # Errors
    /// [`Error::Fingertip`] for a number out of range, for a pair or a pad in space, and for a ring, a disc or a rectangle in the plane.
    pub fn spread<const C: usize>(&self) -> Result<SoftFingertip<C>, Error> {
        self.spread_inside(if C == 2 { Space::Planar } else { Space::Spatial }).map(Face::from_inside)
    }

    /// The patch of points that takes the place of a contact; vectors have three components, also in the plane.
    pub(super) fn spread_inside(&self, space: Space) -> Result<SoftFingertip<3>, Error> {
        let (patch, of) = match *self {
            Self::Ring { radius, points } => (SoftFingertip::ring(radius, points)?, Space::Spatial),
            Self::Disc { radius, annuli, points, pressure } => {
                (SoftFingertip::disc(radius, annuli, points, pressure)?, Space::Spatial)
            }
            Self::Rectangle { sides, strips } => (SoftFingertip::rectangle(sides, strips)?, Space::Spatial),
            Self::Pair { width } => (SoftFingertip::pair_inside(width)?, Space::Planar),
            Self::Pad { width, strips, pressure } => {
                (SoftFingertip::pad_inside(width, strips, pressure)?, Space::Planar)
            }
        };
        if of == space {
            return Ok(patch);
        }
        let allowed = match space {
            Space::Planar => "2: a pair or a pad",
            Space::Spatial => "3: a ring, a disc or a rectangle",
        };
        Err(Error::Fingertip { what: "number of axes of the patch", value: of.axes() as f64, allowed })
    }
}
