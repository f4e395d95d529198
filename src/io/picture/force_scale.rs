//! The scale of forces in pictures.

use crate::numerics::{Reals, least};

use nalgebra::SVector;

/// A contact that carries a force: its point, m, its unit normal, and its normal force, N.
pub(super) type PushedContact = (SVector<f64, 3>, SVector<f64, 3>, f64);

/// Metres per newton in a picture of size `size` (m) whose largest force is `largest` (N). With this scale the arrow of the largest force is 0.12 to
/// 0.4 times `size` long. No arrow reaches the opposite side of the object, unless the object is so thin that the lower limit applies. The scale is 0
/// if there is no force.
pub(super) fn metres_per_newton(pushes: &[PushedContact], size: f64, largest: f64) -> f64 {
    let inwards = |(at, normal, force): &PushedContact| {
        let depth = pushes.iter().map(|(other, ..)| normal.dot(&(other - at))).most();
        // The depth is the largest distance of another contact from this contact along its normal. If no arrow is longer than 0.48 times the depth,
        // the arrows of two opposing normal forces do not meet. A depth below 1e-3 of the size is a rounding error: the contacts lie side by side.
        if depth > 1e-3 * size && *force > 0.0 { 0.48 * depth / force } else { f64::INFINITY }
    };
    let inside = least(pushes, &inwards);
    let part = |part: f64| part * size / largest;
    // The arrow of the largest force is 0.12 to 0.4 times the size of the picture.
    if largest > 0.0 { inside.min(part(0.4)).max(part(0.12)) } else { 0.0 }
}
