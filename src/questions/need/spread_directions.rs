//! Directions of a force that are tried one by one: a set of evenly spread directions, the part of this set that is tried first, and the neighbours
//! of each direction. The carried part of the load is the load factor up to which the object is held; in a weaker direction it is smaller. The
//! verdict says whether the object is held under the full load, or is undecided. In a jump the object moves suddenly under constant load, until
//! contacts catch it.

use core::f64::consts::{PI, TAU};

use crate::numerics::{Each, Space, chosen, dot, numbered};
use crate::prelude::*;

/// The result for one direction of a force: the carried part of the load (0 if the verdict is undecided), and the number of jumps while the load
/// grows.
#[derive(Debug, Clone, Copy)]
pub(super) struct DirectionTrial {
    pub(super) part: f64,
    pub(super) jumps: usize,
}

/// In space the directions that are tried first are at least this angle apart, rad; every other direction is within 0.432 rad of one of them. If
/// [`CLOSE`] times the load is carried in three neighbours, more than 0.998 of the load is carried in all directions between them, as `CLOSE cos
/// 0.432 > 0.998`. This holds if the carried forces form a convex set, which is not proved where contacts slide.
const APART: f64 = 0.4;

/// No weaker direction is sought near a direction in which more than this multiple of the load is carried. With a smaller multiple a weakest
/// direction between evenly spread directions is missed; with a larger one load paths are followed farther.
pub(super) const CLOSE: f64 = 1.1;

/// For each of the evenly spread directions the indices of its neighbours: two on a circle, four to six on the sphere.
pub(super) fn neighbours(all: &[[f64; 3]], space: Space) -> Vec<Vec<usize>> {
    let count = all.len();
    // On a sphere each of 200 directions has an area of (0.25 rad)². The nearest one is 0.22 to 0.25 rad away; four to six are within 0.32 rad.
    let is_near = |one: usize, other: usize| match space {
        Space::Planar => (one + 1) % count == other || (other + 1) % count == one,
        Space::Spatial => one != other && dot(&all[one], &all[other]) > 0.32_f64.cos(),
    };
    numbered(count, &|one| chosen(count, &|other| is_near(one, *other)))
}

/// Whether two unit vectors are less than this angle apart, rad.
pub(super) fn is_within(angle: f64, one: &[f64; 3], other: &[f64; 3]) -> bool {
    dot(one, other) > angle.cos()
}

/// The indices of evenly spread directions that are tried first: all of them in the plane, those at least [`APART`] from each other in space.
pub(super) fn spread_out(all: &[[f64; 3]], space: Space) -> Vec<usize> {
    let mut first: Vec<usize> = Vec::new();
    for k in 0..all.len() {
        if space == Space::Planar || !first.iter().any(|other| is_within(APART, &all[k], &all[*other])) {
            first.push(k);
        }
    }
    first
}

/// The indices of directions not yet tried that lie within 1.5 [`APART`], 0.6 rad, of a direction in which less than [`CLOSE`] times the load is
/// carried. If the object jumps in some direction, all directions not yet tried: the carried part of the load may then jump from direction to
/// direction.
pub(super) fn in_between(all: &[[f64; 3]], found: &[Option<DirectionTrial>]) -> Vec<usize> {
    let jumps = found.iter().flatten().any(|trial| trial.jumps > 0);
    let weak = |(k, trial): (usize, &Option<DirectionTrial>)| trial.filter(|t| t.part < CLOSE).map(|_| k);
    let weak: Vec<usize> = found.iter().enumerate().filter_map(weak).collect();
    let is_near = |k: usize| weak.iter().any(|other| is_within(1.5 * APART, &all[k], &all[*other]));
    chosen(all.len(), &|k| found[*k].is_none() && (jumps || is_near(*k)))
}

/// The results of all directions. A direction that was not tried has the result of the nearest tried direction.
pub(super) fn everywhere(all: &[[f64; 3]], found: &[Option<DirectionTrial>]) -> Vec<DirectionTrial> {
    let tried = || found.iter().enumerate().filter_map(|(k, trial)| Some((&all[k], (*trial)?)));
    let near = |k: usize| tried().max_by(|(a, _), (b, _)| dot(*a, &all[k]).total_cmp(&dot(*b, &all[k])));
    let of = |k: usize| found[k].or_else(|| Some(near(k)?.1));
    numbered(all.len(), &|k| of(k).unwrap_or(DirectionTrial { part: f64::INFINITY, jumps: 0 }))
}

/// The first step, rad, of the search for the weakest direction near an evenly spread one: half of the angle between neighbouring evenly spread
/// directions.
pub(super) fn first_step(space: Space) -> f64 {
    if space == Space::Planar { 0.5 * TAU / 72.0 } else { 0.125 }
}

pub(super) fn unit(vector: [f64; 3]) -> [f64; 3] {
    let length = dot(&vector, &vector).sqrt();
    vector.each(|x| x / length)
}

/// Unit vectors at right angles to a direction: one in the plane, two in space.
pub(super) fn tangents([x, y, z]: [f64; 3], space: Space) -> Vec<[f64; 3]> {
    if space == Space::Planar {
        return vec![[-y, x, 0.0]];
    }
    let first = unit(if x.abs() > y.abs() { [-z, 0.0, x] } else { [0.0, z, -y] });
    let [a, b, c] = first;
    vec![first, [y * c - z * b, z * a - x * c, x * b - y * a]]
}

/// Evenly spread unit vectors: on the unit circle in the plane, on a golden spiral over the unit sphere in space.
pub(super) fn directions(space: Space) -> Vec<[f64; 3]> {
    // No formula gives the load at the loss as a function of the direction, so directions are sampled. With fewer directions the weakest direction
    // could be missed.
    let count = if space == Space::Planar { 72 } else { 200 };
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    let direction = |k: usize| {
        let z = 1.0 - (2 * k + 1) as f64 / count as f64;
        let (radius, angle, z) = match space {
            Space::Planar => (1.0, TAU / count as f64, 0.0),
            Space::Spatial => ((1.0 - z * z).sqrt(), golden, z),
        };
        let (sin, cos) = (angle * k as f64).sin_cos();
        [radius * cos, radius * sin, z]
    };
    numbered(count, &direction)
}
