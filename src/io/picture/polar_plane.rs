//! The map from angles and radii of a polar chart to pixels.

use std::f64::consts::{PI, TAU};

use super::layout::POLAR;
use super::sheet::PaperPoint;

/// The position on paper, pixels, at an angle (rad, counterclockwise from the right) and a distance from the middle of the chart (pixels).
pub(super) fn at(angle: f64, radius: f64) -> PaperPoint {
    (POLAR.middle.0 + radius * angle.cos(), POLAR.middle.1 - radius * angle.sin())
}

/// The angle from one direction to another, rad, from -π to π; positive counterclockwise.
pub(super) fn turn(from: f64, to: f64) -> f64 {
    (to - from + PI).rem_euclid(TAU) - PI
}

/// Line width of a curve, pixels. A curve of larger index lies below curves of smaller index; it is wider, so that it remains visible beside them.
pub(super) fn width_of(index: usize) -> f64 {
    2.0 + 3.0 * index.min(2) as f64
}
