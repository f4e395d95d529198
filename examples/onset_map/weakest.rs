//! The direction with the smallest onset.
//!
//! While everything rolls forces are affine in the load, and friction cones are convex: so is the set of loads under which nothing slides.
//! Its boundary seen from the base load has its nearest points where a small circle of directions around shows nothing nearer.

use std::f64::consts::{PI, TAU};

/// Directions this much farther than the nearest are as near.
const AS_NEAR: f64 = 1e-9;
/// Golden section, until the angle no longer matters.
const ROUNDS: usize = 60;

/// All angles at which a function of the angle is smallest, of those next to a local minimum of its values at `angles`, which go round; with its value.
pub(crate) fn in_the_plane(angles: &[f64], values: &[f64], f: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let count = angles.len();
    let step = TAU / count as f64;
    let local =
        |k: &usize| values[*k] <= values[(k + 1) % count] && values[*k] <= values[(k + count - 1) % count];
    let mut found: Vec<(f64, f64)> = Vec::new();
    for k in (0..count).filter(local) {
        let (angle, value) = golden_section(angles[k] - step, angles[k] + step, &f);
        let apart = |(other, _): &(f64, f64)| ((other - angle + PI).rem_euclid(TAU) - PI).abs() > 0.5 * step;
        if found.iter().all(apart) {
            found.push((angle.rem_euclid(TAU), value));
        }
    }
    let least = found.iter().map(|(_, value)| *value).fold(f64::INFINITY, f64::min);
    found.retain(|(_, value)| *value <= least * (1.0 + AS_NEAR));
    found
}

fn golden_section(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> (f64, f64) {
    let part = (5f64.sqrt() - 1.0) / 2.0;
    let mut inner = [high - part * (high - low), low + part * (high - low)].map(|x| (x, f(x)));
    for _ in 0..ROUNDS {
        if inner[0].1 <= inner[1].1 {
            high = inner[1].0;
            let x = high - part * (high - low);
            inner = [(x, f(x)), inner[0]];
        } else {
            low = inner[0].0;
            let x = low + part * (high - low);
            inner = [inner[1], (x, f(x))];
        }
    }
    if inner[0].1 <= inner[1].1 { inner[0] } else { inner[1] }
}

/// The nearest direction on the sphere, from one near it: the best of a circle of directions around, which shrinks where none is better.
pub(crate) fn in_space(start: [f64; 3], f: impl Fn([f64; 3]) -> f64) -> ([f64; 3], f64) {
    const AROUND: u32 = 16;
    let (mut best, mut radius) = ((start, f(start)), 0.05);
    while radius > 1e-9 {
        let [across, along] = perpendicular(best.0);
        let circle = (0..AROUND).map(|k| {
            let (sin, cos) = (TAU * f64::from(k) / f64::from(AROUND)).sin_cos();
            let d: [f64; 3] =
                std::array::from_fn(|a| best.0[a] + radius * (cos * across[a] + sin * along[a]));
            let d = unit(d);
            (d, f(d))
        });
        match circle.min_by(|a, b| a.1.total_cmp(&b.1)) {
            Some(nearer) if nearer.1 < best.1 => best = nearer,
            _ => radius /= 2.0,
        }
    }
    best
}

fn unit(d: [f64; 3]) -> [f64; 3] {
    let size = d.iter().fold(0.0, |size: f64, x| size.hypot(*x));
    d.map(|x| x / size)
}

/// Two unit vectors across a unit vector and across each other.
fn perpendicular(d: [f64; 3]) -> [[f64; 3]; 2] {
    let helper = if d[2].abs() < 0.9 { [0.0, 0.0, 1.0] } else { [1.0, 0.0, 0.0] };
    let across = unit(cross(helper, d));
    [across, cross(d, across)]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
