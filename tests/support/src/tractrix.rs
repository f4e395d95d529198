//! A finger drags a body on springs round a corner: the friction force turns along the tractrix, the curve that Leibniz wrote down.

use grasp_lcp::spatial::{Contact, Grasp, Leg};
use nalgebra::Vector3;

/// Finger and support, N/m along and across the normal.
const FINGER: [f64; 2] = [2e4, 1e4];
const SUPPORT: f64 = 4e4;
const FRICTION: f64 = 0.5;
/// Commanded squeeze, m.
const SQUEEZE: f64 = 1e-3;
/// The way of the finger after the corner, in leashes.
pub const WAY: f64 = 4.0;

/// Springs in series.
fn series(finger: f64) -> f64 {
    finger * SUPPORT / (finger + SUPPORT)
}

/// Friction force once it slides, N.
pub fn limit() -> f64 {
    FRICTION * series(FINGER[0]) * SQUEEZE
}

/// How far the finger is ahead of what it drags, m.
pub fn leash() -> f64 {
    limit() / series(FINGER[1])
}

/// The finger first, then the support; its way up to the corner, as far as the leash goes, and off at a right angle.
pub fn scene() -> Result<(Grasp, [[f64; 2]; 2]), grasp_lcp::Error> {
    let finger = Contact::new([0.0; 3], [0.0, 0.0, 1.0])
        .name("finger")
        .tangent([1.0, 0.0, 0.0])
        .series_stiffness(FINGER[0], FINGER[1])
        .friction(FRICTION)
        .command([SQUEEZE, 0.0, 0.0]);
    let support = [(0.02, 0.0), (-0.02, 0.0), (0.0, 0.02), (0.0, -0.02)].map(|(x, y)| {
        Contact::new([x, y, 0.0], [0.0, 0.0, 1.0])
            .series_stiffness(SUPPORT / 4.0, SUPPORT / 4.0)
            .friction(1.0)
            .bonded()
    });
    let ways = [[0.0, leash()], [WAY * leash(), 0.0]];
    Ok((Grasp::new([finger].into_iter().chain(support))?, ways))
}

/// What the fingers are commanded to do more on a part of the way.
pub fn drag([x, y]: [f64; 2]) -> Vec<Vector3<f64>> {
    let mut commands = vec![Vector3::zeros(); 5];
    commands[0] = Vector3::new(0.0, x, y);
    commands
}

/// The legs of the way.
pub fn legs(ways: [[f64; 2]; 2]) -> [Leg; 2] {
    ways.map(|way| Leg::commands_by(drag(way)))
}

/// The angle of the friction force to the way after the corner: tan(θ/2) = exp(-x/L).
pub fn exact(leashes: f64) -> f64 {
    2.0 * (-leashes).exp().atan()
}

/// How far a force, in the frame of the finger, is off the tractrix, over its size.
pub fn off(force: &Vector3<f64>, leashes: f64) -> f64 {
    let (sin, cos) = exact(leashes).sin_cos();
    (force[1] / limit() - cos).hypot(force[2] / limit() - sin)
}
