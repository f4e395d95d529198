//! A picture of the motion with which a spatial object leaves the grasp: the outlines of the object, displaced along this motion. The span is the
//! largest extent of the grasp along an axis.

use nalgebra::{Point3, Vector3};

use super::content::MovingLine;
use super::drawing::Drawing;
use crate::grasp::Motion;
use crate::numerics::{IntoList, largest, mapped};
use crate::spatial::{Contact, Twist};

/// Lines on the object after the motion, and arrows from points before the motion to the same points after it.
pub(super) struct MovedLines {
    pub(super) lines: Vec<Vec<Vector3<f64>>>,
    pub(super) arrows: Vec<[Vector3<f64>; 2]>,
}

impl Drawing<'_> {
    /// The outlines after the motion, each moved with its body; without outlines arrows at the contacts. Empty if nothing moves.
    pub(super) fn way_out(&self, motion: &Motion<3>) -> MovedLines {
        let moving = |line: &MovingLine| {
            let twist = *motion.of_body(line.body);
            mapped(&line.corners, &|corner| (Vector3::from(*corner), twist))
        };
        let lines: Vec<Vec<_>> = mapped(&self.page.outlines, &moving);
        // With several bodies a page does not know to which body a contact belongs; arrows at contacts are therefore omitted.
        let of_object = motion.bodies.is_empty().then_some(motion.object);
        let contacts = self.page.grasp.contacts().iter().map(Contact::point);
        let contacts =
            || contacts.zip(std::iter::repeat(of_object)).filter_map(|(point, twist)| Some((point, twist?)));
        let points: Vec<(Vector3<f64>, Twist)> =
            if lines.is_empty() { contacts().list() } else { lines.concat() };
        let speed =
            |(point, twist): &(Vector3<f64>, Twist)| Vector3::from(twist.displacement_at(*point)).norm();
        let fastest = largest(&points, &speed);
        // The fastest point moves by 0.15 of the span. The motion has no meaningful speed, and this displacement is visible.
        let time = 0.15 * self.span / fastest;
        if !(time.is_finite() && time > 0.0) {
            return MovedLines { lines: Vec::new(), arrows: Vec::new() };
        }
        let next =
            |(point, twist): &(Vector3<f64>, Twist)| ((*twist * time).exp() * Point3::from(*point)).coords;
        let every = points.len().div_ceil(6).max(1);
        MovedLines {
            lines: mapped(&lines, &|line| mapped(line, &next)),
            arrows: points.iter().step_by(every).map(|at| [at.0, next(at)]).list(),
        }
    }
}
