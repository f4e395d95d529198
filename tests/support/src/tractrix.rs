//! A finger drags a body on springs around a corner. The direction of friction follows the tractrix, a curve with a closed formula.

use grasp_lcp::spatial::{Contact, Grasp, Leg};
use nalgebra::Vector3;

/// Stiffness of the finger along the normal and along the tangents, N/m.
const FINGER: [f64; 2] = [2e4, 1e4];
const SUPPORT: f64 = 4e4;
const FRICTION: f64 = 0.5;
/// Commanded squeeze, m.
const SQUEEZE: f64 = 1e-3;
/// Length of the finger's path after the corner, in multiples of [`leash`].
pub const WAY: f64 = 4.0;

/// Stiffness of a finger spring in series with the support, N/m.
fn series(finger: f64) -> f64 {
    finger * SUPPORT / (finger + SUPPORT)
}

/// Friction force while the finger slides, N.
pub fn limit() -> f64 {
    FRICTION * series(FINGER[0]) * SQUEEZE
}

/// Distance by which the finger is ahead of its contact point while it slides, m: the friction force divided by the tangential stiffness.
pub fn leash() -> f64 {
    limit() / series(FINGER[1])
}

/// The grasp of finger and support, and the two straight legs along which the finger moves, m. The first leg has the length of the leash, so that
/// sliding begins at its end. The second leg is at a right angle to the first.
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

/// Change of all commands that moves the finger by x and y along its tangents, m.
pub fn drag([x, y]: [f64; 2]) -> Vec<Vector3<f64>> {
    let mut commands = vec![Vector3::zeros(); 5];
    commands[0] = Vector3::new(0.0, x, y);
    commands
}

/// The legs of the load program for these paths.
pub fn legs(ways: [[f64; 2]; 2]) -> [Leg; 2] {
    ways.map(|way| Leg::commands_by(drag(way)))
}

/// Angle between the friction force and the path after the corner, after x = `leashes` L: tan(θ/2) = exp(-x/L).
pub fn exact(leashes: f64) -> f64 {
    2.0 * (-leashes).exp().atan()
}

/// Distance of the friction force (in the contact frame of the finger) from the force of the tractrix, as a fraction of its size.
pub fn off(force: &Vector3<f64>, leashes: f64) -> f64 {
    let (sin, cos) = exact(leashes).sin_cos();
    (force[1] / limit() - cos).hypot(force[2] / limit() - sin)
}
