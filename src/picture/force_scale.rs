//! The scale of forces in pictures.

use nalgebra::SVector;

/// Largest length of the largest force, as a part of the size of the picture.
const LARGEST: f64 = 0.4;
/// Least length of the largest force, as a part of the size of the picture.
const LEAST: f64 = 0.12;
/// Largest length of a normal force, as a part of the distance to the contacts on the other side. Below one half, two opposing forces do not meet.
const WAY: f64 = 0.48;

/// Contacts less deep than this part of the size lie side by side, and the depth is rounding.
const FLAT: f64 = 1e-3;

/// A contact that carries a force: its place, its unit normal, and its normal force.
pub(super) type PushedContact<const C: usize> = (SVector<f64, C>, SVector<f64, C>, f64);

/// Metres per newton in a picture of size `size` (m) whose largest force is `largest` (N). The scale is as large as the picture allows. No force
/// passes through the object and out at its back, unless the object is thin.
pub(super) fn metres_per_newton<const C: usize>(pushes: &[PushedContact<C>], size: f64, largest: f64) -> f64 {
    let inwards = |(at, normal, force): &PushedContact<C>| {
        let depth = pushes.iter().map(|(other, ..)| normal.dot(&(other - at))).fold(0.0, f64::max);
        if depth > FLAT * size && *force > 0.0 { WAY * depth / force } else { f64::INFINITY }
    };
    let inside = pushes.iter().map(inwards).fold(f64::INFINITY, f64::min);
    let part = |part: f64| part * size / largest;
    if largest > 0.0 { inside.min(part(LARGEST)).max(part(LEAST)) } else { 0.0 }
}
