//! Closing a hand about a ball, and the places where its links touch.

use grasp_lcp::nalgebra::{Point3, Vector3};

use crate::description::Chain;

/// A ball, m.
pub struct Ball {
    pub centre: Point3<f64>,
    pub radius: f64,
}

/// Half the thickness of a finger, m.
const FINGER: f64 = 0.009;
/// First step by which a joint closes until something touches, rad; then steps are halved.
const STEP: f64 = 0.01;
/// Distance below which a link touches, m.
const TOUCHES: f64 = 1e-6;

/// A link on the ball.
pub struct Touch {
    /// Number of joints that move it, from the palm.
    pub link: usize,
    pub point: Point3<f64>,
    /// Into the ball.
    pub normal: Vector3<f64>,
}

/// The point of a link nearest to the ball's centre.
fn nearest(ends: [Point3<f64>; 2], centre: &Point3<f64>) -> Point3<f64> {
    let along = ends[1] - ends[0];
    let part = (centre - ends[0]).dot(&along) / along.norm_squared().max(f64::MIN_POSITIVE);
    ends[0] + along * part.clamp(0.0, 1.0)
}

/// The gap between the ball and the nearest of the links from `first` on.
fn gap(chain: &Chain, angles: &[f64], first: usize, ball: &Ball) -> f64 {
    let placed = chain.at(angles);
    let of =
        |link: usize| (nearest(placed.link(link), &ball.centre) - ball.centre).norm() - ball.radius - FINGER;
    (first..angles.len()).map(of).fold(f64::INFINITY, f64::min)
}

/// Closes joints of a finger, one after the other from the palm outwards, each until a link behind it touches or its range ends.
pub fn close(chain: &Chain, angles: &mut [f64], joints: &[usize], ball: &Ball) {
    for &joint in joints {
        let upper = chain.joints[joint].upper;
        let mut step = STEP;
        while step > 1e-12 && angles[joint] < upper {
            let before = angles[joint];
            angles[joint] = (before + step).min(upper);
            if gap(chain, angles, joint, ball) < 0.0 {
                angles[joint] = before;
                step *= 0.5;
            }
        }
    }
}

/// The links that touch in a posture, tips and phalanges.
pub fn touches(chain: &Chain, angles: &[f64], ball: &Ball) -> Vec<Touch> {
    let placed = chain.at(angles);
    let touch = |link: usize| {
        let to = ball.centre - nearest(placed.link(link), &ball.centre);
        let normal = to.normalize();
        let touches = (to.norm() - ball.radius - FINGER).abs() < TOUCHES;
        touches.then(|| Touch { link: link + 1, point: ball.centre - normal * ball.radius, normal })
    };
    (0..angles.len()).filter_map(touch).collect()
}
