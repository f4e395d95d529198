//! Where the object would be next on its way out.

use nalgebra::{Point3, Vector3};

use super::drawing::Drawing;
use crate::grasp::Motion;
use crate::spatial::Contact;

/// Part of the span by which the fastest point is moved.
const LEAVES: f64 = 0.15;
/// Arrows at most.
const ARROWS: usize = 6;

/// Lines on the object, where they are and where they would be next.
pub(super) struct MovedLines {
    pub(super) lines: Vec<Vec<Vector3<f64>>>,
    pub(super) arrows: Vec<[Vector3<f64>; 2]>,
}

impl Drawing<'_> {
    /// Of the outlines, or else of contacts.
    pub(super) fn way_out(&self, motion: &Motion<3>) -> MovedLines {
        let corners =
            self.page.outlines.iter().map(|line| line.iter().map(|corner| Vector3::from(*corner)).collect());
        let lines: Vec<Vec<_>> = corners.collect();
        let contacts = || self.page.grasp.contacts().iter().map(Contact::point).collect();
        let points: Vec<Vector3<f64>> = if lines.is_empty() { contacts() } else { lines.concat() };
        let speed = |point: &Vector3<f64>| Vector3::from(motion.object.displacement_at(*point)).norm();
        let fastest = points.iter().map(speed).fold(0.0, f64::max);
        let time = LEAVES * self.span / fastest;
        if !(time.is_finite() && time > 0.0) {
            return MovedLines { lines: Vec::new(), arrows: Vec::new() };
        }
        let carried = (motion.object * time).exp();
        let next = |point: &Vector3<f64>| (carried * Point3::from(*point)).coords;
        let every = points.len().div_ceil(ARROWS).max(1);
        MovedLines {
            lines: lines.iter().map(|line| line.iter().map(next).collect()).collect(),
            arrows: points.iter().step_by(every).map(|point| [*point, next(point)]).collect(),
        }
    }
}
