//! Jaws and fingers that press an object from two sides, and points around it.

use std::f64::consts::TAU;

use grasp_lcp::grasp::Contact;
use grasp_lcp::{Error, planar};

/// A contact at x on the first axis whose normal points at the origin, with stiffness along normal and tangents.
pub fn jaw<const C: usize>(x: f64, [normal, tangential]: [f64; 2], friction: f64) -> Contact<C> {
    let [mut point, mut inward] = [[0.0; C]; 2];
    (point[0], inward[0]) = (x, -x);
    Contact::new(point, inward).series_stiffness(normal, tangential).friction(friction)
}

/// A left and a right jaw, 60 mm apart, that press with 10 N each.
pub fn jaws(friction: [f64; 2]) -> Result<planar::Grasp, Error> {
    let jaw = |x: f64, mu: f64, name: &str| jaw(x, [1000.0, 800.0], mu).name(name).pressed_with(10.0);
    planar::Grasp::new([jaw(-0.03, friction[0], "left"), jaw(0.03, friction[1], "right")])
}

/// Contact i of `count` around a circle in the first two axes, whose normal points at the centre.
pub fn around<const C: usize>(
    i: usize,
    count: usize,
    radius: f64,
    stiffness: [f64; 2],
    friction: f64,
) -> Contact<C> {
    let (sin, cos) = (TAU * i as f64 / count as f64).sin_cos();
    let [mut point, mut inward] = [[0.0; C]; 2];
    (point[0], point[1], inward[0], inward[1]) = (radius * cos, radius * sin, -cos, -sin);
    Contact::new(point, inward).series_stiffness(stiffness[0], stiffness[1]).friction(friction)
}
