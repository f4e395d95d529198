//! Closes a hand around a ball, and finds the links in contact.

use grasp_lcp::nalgebra::{Point3, Vector3};
use grasp_lcp::robot::Robot;

use crate::Failure;

/// A ball, m.
pub struct Ball {
    pub centre: Point3<f64>,
    pub radius: f64,
}

/// Half the thickness of a finger, m.
const FINGER: f64 = 0.009;
/// Step by which a joint closes, rad. Once a link touches, the step is halved until it is below 1e-12.
const STEP: f64 = 0.01;
/// A link whose gap to the ball is below this is in contact, m.
const TOUCHES: f64 = 1e-6;

/// The links of a finger that its four joints move, and its tip.
const LINKS: [&str; 5] = ["knuckle", "proximal", "middle_phalanx", "distal", "tip"];

/// The name of the link of a finger that this number of joints moves.
pub fn link_name(finger: &str, joints: usize) -> String {
    format!("{finger}_{}", LINKS[joints - 1])
}

/// A contact of a link with the ball.
pub struct Touch {
    /// Number of joints that move the link.
    pub link: usize,
    pub point: Point3<f64>,
    /// Unit normal into the ball.
    pub normal: Vector3<f64>,
}

/// The point on the axis of each link of a finger nearest to the centre of the ball.
fn nearest(robot: &Robot, finger: &str, centre: &Point3<f64>) -> Result<Vec<Point3<f64>>, Failure> {
    let ends: Vec<Point3<f64>> = (1..=LINKS.len())
        .map(|joints| Ok(robot.pose(&link_name(finger, joints))?.translation.vector.into()))
        .collect::<Result<_, Failure>>()?;
    let on_link = |pair: &[Point3<f64>]| {
        let along = pair[1] - pair[0];
        let part = (centre - pair[0]).dot(&along) / along.norm_squared().max(f64::MIN_POSITIVE);
        pair[0] + along * part.clamp(0.0, 1.0)
    };
    Ok(ends.windows(2).map(on_link).collect())
}

/// Closes joints of a finger, one after the other from the palm outwards. Each closes until a link outwards of it touches, or its range ends.
pub fn close(mut robot: Robot, finger: &str, joints: &[usize], ball: &Ball) -> Result<Robot, Failure> {
    for &joint in joints {
        let of_finger = robot.joints_of(&link_name(finger, LINKS.len()))?;
        let (name, upper) = (of_finger[joint].name().to_owned(), of_finger[joint].range()[1]);
        let (mut step, mut angle) = (STEP, of_finger[joint].position());
        while step > 1e-12 && angle < upper {
            let further = (angle + step).min(upper);
            let closed = robot.clone().posed(&name, further)?;
            let nearest = nearest(&closed, finger, &ball.centre)?;
            if nearest[joint..].iter().any(|point| (point - ball.centre).norm() < ball.radius + FINGER) {
                step *= 0.5;
            } else {
                (robot, angle) = (closed, further);
            }
        }
    }
    Ok(robot)
}

/// The contacts of all links, tips and phalanges, in a posture.
pub fn touches(robot: &Robot, finger: &str, ball: &Ball) -> Result<Vec<Touch>, Failure> {
    let touch = |(link, nearest): (usize, &Point3<f64>)| {
        let to = ball.centre - nearest;
        let normal = to.normalize();
        let touches = (to.norm() - ball.radius - FINGER).abs() < TOUCHES;
        touches.then(|| Touch { link: link + 1, point: ball.centre - normal * ball.radius, normal })
    };
    Ok(nearest(robot, finger, &ball.centre)?.iter().enumerate().filter_map(touch).collect())
}
