//! Draws grasps, load curves and maps over all directions as SVG (feature `plot`). Grasps are also drawn as HTML pages, on which a spatial grasp can
//! be turned.
//!
//! Every function returns the text of an SVG or HTML file; the caller writes it to a file.

mod actuators;
mod axes;
mod bands;
mod canvas;
mod chart;
mod chart_strokes;
mod contact_look;
mod cycle_chart;
mod error;
mod fingertip;
mod force_scale;
mod friction_chart;
mod grasp_picture;
mod labels;
mod layout;
mod legend_position;
mod page;
mod painting;
mod palette;
mod planar_link;
mod planar_load;
mod planar_picture;
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
mod way_out;
mod window;
mod words;

pub use chart::Chart;
pub use cycle_chart::charts_of_cycles;
pub use error::PictureError;
pub use page::{Page, View};
pub use planar_picture::{Outline, PlanarPicture, draw_grasp};
pub use polar::Polar;
pub use series::{ChartSeries, Stroke};
pub use sphere::SphereMap;
pub use sphere_grid::SphereGrid;
pub use turn_chart::{chart_of_load, chart_of_program, chart_of_turn};
