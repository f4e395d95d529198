//! Nearly repeated pushes: no model of the load alone can predict the differences between them.

use support::measured_pushes::{Limit, Push, SURFACES};

use crate::{LENGTH, quantile};

/// Largest angle between two loads that count as equal, degrees, with moments divided by [`LENGTH`]. No push was repeated exactly.
const ALIKE: f64 = 8.0;
/// Median of the absolute value of a standard normal variable.
const MEDIAN_SIZE: f64 = 0.674_49;

/// Scatter of pushes under nearly equal loads, relative to the force.
pub(crate) struct Repeats {
    pub(crate) scatter: f64,
    pushes: usize,
}

/// Compares each push of a surface with the push of the same layout whose load is nearest.
pub(crate) fn scatter(pushes: &[Push], limits: &[Limit], surface: &str) -> Repeats {
    let load =
        |push: &Push| grasp_lcp::nalgebra::Vector3::new(push.load.x, push.load.y, push.load.z / LENGTH);
    let own: Vec<_> = pushes.iter().zip(limits).filter(|(push, _)| push.surface == surface).collect();
    let apart = own.iter().enumerate().filter_map(|(k, (push, limit))| {
        let others = own.iter().enumerate().filter(|(j, (other, _))| *j != k && other.layout == push.layout);
        let angles = others.map(|(_, (other, that))| (load(push).angle(&load(other)), that));
        let (angle, nearest) = angles.min_by(|a, b| a.0.total_cmp(&b.0))?;
        (angle.to_degrees() <= ALIKE).then(|| (limit.factor / nearest.factor).ln().abs())
    });
    let apart: Vec<f64> = apart.collect();
    let pushes = apart.len();
    // The difference of two pushes scatters √2 times as much as one push.
    Repeats { scatter: quantile(apart, 50) / (2.0_f64.sqrt() * MEDIAN_SIZE), pushes }
}

/// Prints a sentence about the scatter for each surface.
pub(crate) fn told(floors: &[Repeats; 2]) {
    println!();
    for (surface, floor) in SURFACES.iter().zip(floors) {
        println!(
            "On {surface} {} of 200 pushes have another one whose load is within {ALIKE:.0}° of their own: the forces of such pushes scatter by {:.1} %.",
            floor.pushes,
            100.0 * floor.scatter
        );
    }
}
