//! One graphical mark of a spatial picture: its shape in the coordinates of the grasp, and its JSON for the JavaScript of an HTML page. A fingertip
//! is a contact with all its points.

use std::fmt::Write;

use super::json::{json_list, json_row, json_string};
use crate::picture::error::PictureError;
use crate::picture::palette::{Rgb, hex};
use nalgebra::Vector3;

/// Groups of marks that a reader of the page can show or hide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum MarkLayer {
    Forces,
    Cones,
    Load,
    Displacements,
    FreeMotions,
    WayOut,
    Names,
    /// Marks that are visible only while the mouse pointer is on their contact.
    Pointed,
}

impl MarkLayer {
    /// The name of the layer in the JSON of a mark, and at the checkbox of the page's legend that shows or hides the layer.
    fn word(self) -> &'static str {
        match self {
            Self::Forces => "forces",
            Self::Cones => "cones",
            Self::Load => "load",
            Self::Displacements => "displacements",
            Self::FreeMotions => "free",
            Self::WayOut => "leaves",
            Self::Names => "names",
            Self::Pointed => "pointed",
        }
    }
}

/// One graphical mark of a picture, such as a line, an arrow or a name.
pub(super) struct Mark {
    pub(super) shape: MarkShape,
    /// The layer by which the mark is shown or hidden; a mark without a layer is always shown.
    pub(super) layer: Option<MarkLayer>,
    /// The index of the fingertip to which the mark belongs; `None` for a mark of something else, such as the object or the load.
    pub(super) tip: Option<usize>,
}

/// The shape of a mark. Widths and dashes are in pixels, positions in metres.
pub(super) enum MarkShape {
    Line {
        corners: Vec<Vector3<f64>>,
        ink: Rgb,
        width: f64,
        dashes: Option<(f64, f64)>,
    },
    Arrow {
        from: Vector3<f64>,
        along: Vector3<f64>,
        ink: Rgb,
        width: f64,
        heads: usize,
    },
    /// A round cone: `radii` are two orthogonal vectors from the middle of its rim to the rim.
    Cone {
        apex: Vector3<f64>,
        middle: Vector3<f64>,
        radii: [Vector3<f64>; 2],
        ink: Rgb,
    },
    /// The arrow of a load. If it is too short to be visible, it is lengthened, and then not to scale.
    Load {
        from: Vector3<f64>,
        along: Vector3<f64>,
        width: f64,
        heads: usize,
        /// The label of the arrow if it is to scale: its name and magnitude. An empty label is not written.
        name: String,
        /// The label of the arrow if it is not to scale, which says so.
        otherwise: String,
    },
    /// An edge of the object, darker where it is nearer to the eye.
    Edge {
        corners: Vec<Vector3<f64>>,
    },
    /// A convex part of the object, drawn behind everything else.
    Body {
        corners: Vec<Vector3<f64>>,
    },
    Dot {
        at: Vector3<f64>,
        radius: f64,
        ink: Rgb,
        open: bool,
    },
    Name {
        at: Vector3<f64>,
        words: String,
    },
}

impl MarkShape {
    pub(super) fn always(self) -> Mark {
        Mark { shape: self, layer: None, tip: None }
    }

    pub(super) fn on(self, layer: MarkLayer) -> Mark {
        Mark { shape: self, layer: Some(layer), tip: None }
    }
}

impl Mark {
    pub(super) fn of(self, tip: usize) -> Self {
        Self { tip: Some(tip), ..self }
    }

    pub(super) fn points(&self) -> Vec<Vector3<f64>> {
        match &self.shape {
            MarkShape::Line { corners, .. } | MarkShape::Edge { corners } | MarkShape::Body { corners } => {
                corners.clone()
            }
            MarkShape::Arrow { from, along, .. } | MarkShape::Load { from, along, .. } => {
                vec![*from, from + along]
            }
            MarkShape::Cone { apex, middle, radii: [a, b], .. } => {
                vec![*apex, middle + a, middle - a, middle + b, middle - b]
            }
            MarkShape::Dot { at, .. } | MarkShape::Name { at, .. } => vec![*at],
        }
    }

    /// The mark as a JSON object. Its first key names the kind of mark, and has the position as value.
    pub(super) fn json(&self) -> Result<String, PictureError> {
        let line = |corners: &[Vector3<f64>]| json_list(corners, &row);
        let mut parts = match &self.shape {
            MarkShape::Line { corners, ink, width, dashes } => {
                let dashes = dashes.map_or(String::new(), |(on, off)| format!(",\"dashes\":[{on},{off}]"));
                format!("\"line\":{},{}{dashes}", line(corners)?, stroke(*ink, *width))
            }
            MarkShape::Arrow { from, along, ink, width, heads } => {
                let (from, along) = (row(from)?, row(along)?);
                format!("\"arrow\":{from},\"along\":{along},{},\"heads\":{heads}", stroke(*ink, *width))
            }
            MarkShape::Cone { apex, middle, radii, ink } => {
                let (apex, middle, radii) = (row(apex)?, row(middle)?, line(radii)?);
                format!("\"cone\":{apex},\"middle\":{middle},\"radii\":{radii},\"ink\":\"{}\"", hex(*ink))
            }
            MarkShape::Load { from, along, width, heads, name, otherwise } => {
                let (from, along, name, otherwise) =
                    (row(from)?, row(along)?, json_string(name), json_string(otherwise));
                format!(
                    "\"load\":{from},\"along\":{along},\"width\":{width},\"heads\":{heads},\"name\":{name},\"otherwise\":{otherwise}"
                )
            }
            MarkShape::Edge { corners } => format!("\"edge\":{}", line(corners)?),
            MarkShape::Body { corners } => format!("\"body\":{}", line(corners)?),
            MarkShape::Dot { at, radius, ink, open } => {
                format!("\"dot\":{},\"radius\":{radius},\"ink\":\"{}\",\"open\":{open}", row(at)?, hex(*ink))
            }
            MarkShape::Name { at, words } => {
                format!("\"name\":{},\"words\":{}", row(at)?, json_string(words))
            }
        };
        if let Some(layer) = self.layer {
            let _ = write!(parts, ",\"layer\":\"{}\"", layer.word());
        }
        if let Some(tip) = self.tip {
            let _ = write!(parts, ",\"tip\":{tip}");
        }
        Ok(format!("{{{parts}}}"))
    }
}

fn row(point: &Vector3<f64>) -> Result<String, PictureError> {
    json_row(point.as_slice())
}

fn stroke(ink: Rgb, width: f64) -> String {
    format!("\"ink\":\"{}\",\"width\":{width}", hex(ink))
}
