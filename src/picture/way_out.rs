//! Where a planar object would be next on its way out.

use nalgebra::{Point2, Vector2};

use super::painting::{Painting, flat};
use super::palette::VERMILION;
use super::sheet::Place;
use crate::grasp::Motion;

/// Part of the size of the scene by which the fastest point is moved.
const FAR: f64 = 0.13;
/// Arrows at most.
const ARROWS: usize = 6;

/// Points, and where they would be next.
pub(super) struct MovedOutline {
    from: Vec<Vector2<f64>>,
    to: Vec<Vector2<f64>>,
    /// The points are the corners of a closed line.
    is_closed: bool,
}

impl MovedOutline {
    /// Of an outline, or else of contact points, in a scene of this size; none without a motion.
    pub(super) fn new(
        motion: &Motion<2>,
        outline: &[Vector2<f64>],
        contacts: impl Iterator<Item = Vector2<f64>>,
        size: f64,
    ) -> Option<Self> {
        let is_closed = outline.len() > 2;
        let from: Vec<_> = if is_closed { outline.to_vec() } else { contacts.collect() };
        let speed = |p: &Vector2<f64>| Vector2::from(motion.object.displacement_at(*p)).norm();
        let fastest = from.iter().map(speed).fold(0.0, f64::max);
        let time = FAR * size / fastest;
        if !(time.is_finite() && time > 0.0) {
            return None;
        }
        let carried = (motion.object * time).exp();
        let next = |p: &Vector2<f64>| (carried * Point2::from(*p)).coords;
        let to = from.iter().map(next).collect();
        Some(Self { from, to, is_closed })
    }

    /// Places that have to be in the picture.
    pub(super) fn points(&self) -> &[Vector2<f64>] {
        &self.to
    }

    /// Paints it, and returns where its name goes.
    pub(super) fn paint(
        &self,
        painting: &mut Painting,
        place: impl Fn(Vector2<f64>) -> Place,
    ) -> Option<Place> {
        if self.is_closed {
            for (k, corner) in self.to.iter().enumerate() {
                let next = self.to[(k + 1) % self.to.len()];
                painting.dashed_line([place(*corner), place(next)], VERMILION, 1.5);
            }
        }
        let every = self.from.len().div_ceil(ARROWS).max(1);
        for (from, to) in self.from.iter().zip(&self.to).step_by(every) {
            painting.arrow([flat(place(*from)), flat(place(*to))], VERMILION, 1.5, 1);
        }
        let farthest = self.from.iter().zip(&self.to).max_by(|a, b| {
            let moved = |(from, to): &(&Vector2<f64>, &Vector2<f64>)| (*to - *from).norm();
            moved(a).total_cmp(&moved(b))
        });
        farthest.map(|(_, to)| place(*to))
    }
}
