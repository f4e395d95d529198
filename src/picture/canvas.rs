//! A plane with coordinates to draw on, as plotters has it.

use plotters::chart::ChartContext;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::{Cartesian2d, SVGBackend};

pub(super) type Canvas<'a, 'b> =
    ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;
/// What plotters says of each stroke.
pub(super) type Plotted = Result<(), Box<dyn std::error::Error>>;
