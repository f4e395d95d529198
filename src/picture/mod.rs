//! Grasps, load curves and maps over all directions as SVG, spatial grasps also as pages to turn
//! (feature `plot`).
//!
//! Every function returns the text of an SVG or HTML file; writing it somewhere is the caller's
//! business.

mod actuators;
mod bands;
mod canvas;
mod chart;
mod contact_look;
mod error;
mod grasp_picture;
mod legend_corner;
mod page;
mod palette;
mod polar;
mod polar_curve;
mod polar_plane;
mod regions;
mod round_numbers;
mod series;
mod sheet;
mod sphere;
mod sphere_grid;
mod turn_chart;

pub use chart::Chart;
pub use error::PictureError;
pub use grasp_picture::{Outline, draw_grasp};
pub use page::{SpatialPage, View};
pub use polar::Polar;
pub use series::{Series, Stroke};
pub use sphere::SphereMap;
pub use sphere_grid::SphereGrid;
pub use turn_chart::chart_of_turn;
