//! Where angles and radii of a polar chart lie on paper.

use std::f64::consts::{PI, TAU};

use super::sheet::Place;

pub(super) const MIDDLE: Place = (330.0, 340.0);
/// Of the rim, pixels.
pub(super) const RADIUS: f64 = 225.0;

/// A place so many pixels from the middle.
pub(super) fn at(angle: f64, radius: f64) -> Place {
    (MIDDLE.0 + radius * angle.cos(), MIDDLE.1 - radius * angle.sin())
}

/// The turn from one direction to another, from -π to π.
pub(super) fn turn(from: f64, to: f64) -> f64 {
    (to - from + PI).rem_euclid(TAU) - PI
}

/// Curves farther down are wider, so that they show beside those on top of them.
pub(super) fn width_of(index: usize) -> f64 {
    2.0 + 3.0 * index.min(2) as f64
}
