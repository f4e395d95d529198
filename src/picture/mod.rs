//! Grasps, load curves and maps over all directions as SVG, spatial grasps also as pages to turn (feature `plot`).
//!
//! Every function returns the text of an SVG or HTML file; writing it somewhere is the caller's business.

mod bands;
mod chart;
mod grasp_picture;
mod page;
mod polar;
mod polar_curve;
mod regions;
mod sheet;
mod sphere;
mod sphere_grid;

pub use chart::{Chart, Series, Stroke};
pub use grasp_picture::{Outline, draw_grasp};
pub use page::{SpatialPage, View};
pub use polar::Polar;
pub use sphere::SphereMap;
pub use sphere_grid::SphereGrid;

use plotters::style::RGBColor;

use crate::equilibrium::{ContactAnswer, ContactState};

/// A picture could not be drawn; the message says what stood in the way.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("the picture could not be drawn: {0}")]
pub struct PictureError(String);

impl PictureError {
    fn from_backend(error: impl std::fmt::Display) -> Self {
        Self(error.to_string())
    }
}

/// Eight colours that remain distinct for colour-blind readers (Okabe & Ito 2008), black last.
const PALETTE: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(160, 140, 20),
    RGBColor(0, 0, 0),
];
const BLUE: RGBColor = PALETTE[0];
const VERMILION: RGBColor = PALETTE[1];
const GREEN: RGBColor = PALETTE[2];
const GREY: RGBColor = RGBColor(110, 110, 110);
const FONT: &str = "sans-serif";

/// The colour of what a contact does.
fn ink<const C: usize>(answer: &ContactAnswer<C>) -> RGBColor {
    match word(answer) {
        "separated" => GREY,
        "sliding" => VERMILION,
        "frictionless" => GREEN,
        "about to slide" => PALETTE[4],
        _ => BLUE,
    }
}

/// What a contact does, for a picture: a contact on the edge of its cone that has not slipped yet is told apart.
fn word<const C: usize>(answer: &ContactAnswer<C>) -> &'static str {
    match answer.state {
        ContactState::Separated => "separated",
        ContactState::Sliding { .. } => "sliding",
        ContactState::Frictionless => "frictionless",
        ContactState::Rolling if answer.margin <= 1e-12 * answer.normal_force() => "about to slide",
        ContactState::Rolling => "rolling",
    }
}
