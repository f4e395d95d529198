//! The motion with which a planar object leaves the grasp: its outline displaced along this motion.

use std::ops::Range;

use nalgebra::{Point2, Vector2};

use super::painting::{Painting, flat};
use super::palette::VERMILION;
use super::sheet::PaperPoint;
use crate::grasp::{Face, Motion};
use crate::numerics::{IntoList, highest, largest, mapped, moved, paired};
use crate::planar::Twist;

/// Points of the object, or of several bodies, before and after the motion.
pub(super) struct MovedOutlines {
    from: Vec<Vector2<f64>>,
    to: Vec<Vector2<f64>>,
    /// Ranges of points that form closed lines.
    closed: Vec<Range<usize>>,
}

impl MovedOutlines {
    /// Displaces the outlines along the motion with which the object leaves the grasp; without outlines, displaces the contact points. `size` is the
    /// size of the grasp, m. `None` if nothing moves.
    pub(super) fn new(
        motion: &Motion<3>,
        outlines: &[Vec<Vector2<f64>>],
        contacts: impl Iterator<Item = Vector2<f64>>,
        size: f64,
    ) -> Option<Self> {
        let is_drawn = |outline: &&Vec<_>| outline.len() > 2;
        let (mut points, mut closed) = (Vec::new(), Vec::new());
        for (body, outline) in outlines.iter().enumerate().filter(|(_, outline)| is_drawn(outline)) {
            closed.push(points.len()..points.len() + outline.len());
            let twist = Twist::from_inside(*motion.of_body(body));
            outline.iter().map(|corner| (*corner, twist)).append_to(&mut points);
        }
        if closed.is_empty() && motion.bodies.is_empty() {
            let twist = Twist::from_inside(motion.object);
            contacts.map(|point| (point, twist)).append_to(&mut points);
        }
        let speed = |(p, twist): &(Vector2<f64>, Twist)| Vector2::from(twist.displacement_at(*p)).norm();
        let fastest = largest(&points, &speed);
        // The fastest point moves by 0.13 of the size of the grasp. The motion has no meaningful speed, and this displacement is visible.
        let time = 0.13 * size / fastest;
        if !(time.is_finite() && time > 0.0) {
            return None;
        }
        let next = |(p, twist): &(Vector2<f64>, Twist)| ((*twist * time).exp() * Point2::from(*p)).coords;
        let to = mapped(&points, &next);
        Some(Self { from: moved(points, &|(point, _)| point), to, closed })
    }

    /// The points of the object after the motion, which the picture must contain.
    pub(super) fn points(&self) -> &[Vector2<f64>] {
        &self.to
    }

    /// Paints the moved outlines, and arrows along the motion. Returns the position on paper of the point that has moved farthest: the caller writes
    /// a label beside this point. `None` without points.
    pub(super) fn paint(
        &self,
        painting: &mut Painting,
        place: &dyn Fn(Vector2<f64>) -> PaperPoint,
    ) -> Option<PaperPoint> {
        for corners in self.closed.iter().map(|range| &self.to[range.clone()]) {
            for (k, corner) in corners.iter().enumerate() {
                let next = corners[(k + 1) % corners.len()];
                painting.dashed_line([place(*corner), place(next)], VERMILION, 1.5);
            }
        }
        let every = self.from.len().div_ceil(6).max(1);
        for (from, to) in self.from.iter().zip(&self.to).step_by(every) {
            painting.arrow([flat(place(*from)), flat(place(*to))], VERMILION, 1.5, 1);
        }
        let ends = paired(&self.from, &self.to, &|(from, to)| (from, to));
        highest(&ends, &|(from, to)| (*to - *from).norm()).map(|(_, to)| place(**to))
    }
}
