//! How long forces are drawn.

use nalgebra::SVector;

/// Parts of the size of a picture that the largest force takes at most and at least.
const LARGEST: f64 = 0.4;
const LEAST: f64 = 0.12;
/// Part of the way to the contacts on the other side that a normal force goes at most: two that
/// oppose each other do not meet.
const WAY: f64 = 0.48;

/// Contacts less deep than this part of the size lie side by side: nothing is behind them but
/// rounding.
const FLAT: f64 = 1e-3;

/// A contact on which a force acts: its place, its unit normal, and its normal force.
pub(super) type PushedContact<const C: usize> = (SVector<f64, C>, SVector<f64, C>, f64);

/// Metres for a newton, in a picture of a size (m) with a largest force (N): as large as the picture
/// allows, but no force goes through the object and out at its back, unless the object is thin.
pub(super) fn metres_per_newton<const C: usize>(pushes: &[PushedContact<C>], size: f64, largest: f64) -> f64 {
    let inwards = |(at, normal, force): &PushedContact<C>| {
        let depth = pushes.iter().map(|(other, ..)| normal.dot(&(other - at))).fold(0.0, f64::max);
        if depth > FLAT * size && *force > 0.0 { WAY * depth / force } else { f64::INFINITY }
    };
    let inside = pushes.iter().map(inwards).fold(f64::INFINITY, f64::min);
    let part = |part: f64| part * size / largest;
    if largest > 0.0 { inside.min(part(LARGEST)).max(part(LEAST)) } else { 0.0 }
}
