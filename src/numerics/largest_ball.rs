//! The largest ball about the origin in a convex set, with lower and upper bounds.
//!
//! A support point is the point of the set that lies farthest in a given direction; its distance in this direction is the extent of the set. A
//! polytope with support points as vertices grows where its surface is closest to the origin. The distance of its closest face is a lower bound on
//! the radius. The support point in the direction of that face's normal gives an upper bound: the extent of the set in this direction. This support
//! point is added to the polytope, and new faces replace the faces that are visible from it, i.e. have it on their outer side.
//!
//! In three dimensions: G. van den Bergen, *Proximity queries and penetration depth computation on 3D game objects*, 2001.
//!
//! If the set is smooth, faces become so thin that rounding corrupts their planes. If the polytope seems to come closer to the origin for this
//! reason, the search ends with the bounds known before.

use alloc::collections::BinaryHeap;
use core::cmp::Ordering;

use super::coordinates::{Size, Square, Vector, WHOLE};
use super::partial_pivoting::PartialPivoting;
use super::support::{SupportFunction, Vertex, middle};
use super::tolerances::{POLYTOPE_SHRINKS, SOLVED_ROUNDING};
use crate::numerics::{largest, mapped};
use crate::prelude::*;

/// Bounds of the radius of the largest ball about the origin in a convex set.
#[derive(Debug, Clone)]
pub(crate) struct BallBounds {
    /// Lower bound of the radius, the distance of the closest face of the polytope; negative if the origin lies outside the polytope.
    pub(crate) at_least: f64,
    pub(crate) at_most: f64,
    /// Unit direction in which the set extends no farther than `at_most`.
    pub(crate) direction: Vector,
}

/// Indices of the vertices of a face, as many as there are dimensions, in ascending order; unused entries at the end hold `usize::MAX`.
type Corners = [usize; WHOLE];

struct Face {
    vertices: Corners,
    /// Vector v for which the face's plane is `v·(x - middle) = 1`, with the mean `middle` of the vertices of the first simplex.
    normal: Vector,
    is_alive: bool,
}

/// An entry of the queue of faces, which is ordered such that the face closest to the origin comes first.
struct QueuedFace {
    distance: f64,
    face: usize,
}

impl PartialEq for QueuedFace {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for QueuedFace {}

impl PartialOrd for QueuedFace {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for QueuedFace {
    fn cmp(&self, other: &Self) -> Ordering {
        other.distance.total_cmp(&self.distance).then(other.face.cmp(&self.face))
    }
}

struct Polytope {
    size: Size,
    middle: Vector,
    points: Vec<Vector>,
    faces: Vec<Face>,
    alive: Vec<usize>,
    queue: BinaryHeap<QueuedFace>,
    /// The ridges (edges in three dimensions) of the faces that a new point removes, each joined with that point. One list is reused for all
    /// points.
    ridges: Vec<Corners>,
}

impl Polytope {
    /// The first polytope: the simplex with these vertices, one more than the number of dimensions.
    fn of(simplex: &[Vertex]) -> Self {
        let size = Size::of(simplex.len() - 1);
        let points: Vec<_> = mapped(simplex, &|vertex| vertex.at.clone());
        let (faces, alive, queue, ridges) = (Vec::new(), Vec::new(), BinaryHeap::new(), Vec::new());
        let mut polytope = Self { size, middle: middle(simplex), points, faces, alive, queue, ridges };
        for without in 0..simplex.len() {
            let mut vertices = [usize::MAX; WHOLE];
            for (k, vertex) in vertices[..size.count()].iter_mut().enumerate() {
                *vertex = if k < without { k } else { k + 1 };
            }
            polytope.add(vertices);
        }
        polytope
    }

    /// Adds the face through the points with these indices. A face too thin to have a plane is omitted: the neighbouring faces then meet up to
    /// rounding.
    fn add(&mut self, vertices: Corners) {
        let columns = Square::from_columns(self.size, |k| &self.points[vertices[k]] - &self.middle);
        let Some(solver) = PartialPivoting::new(&columns.transpose()) else { return };
        let normal = solver.solve(&Vector::from_fn(self.size, |_| 1.0));
        let distance = (1.0 + normal.dot(&self.middle)) / normal.norm();
        self.queue.push(QueuedFace { distance, face: self.faces.len() });
        self.alive.push(self.faces.len());
        self.faces.push(Face { vertices, normal, is_alive: true });
    }

    /// Adds a point to the polytope. The faces that are visible from it, or contain it in their plane, are removed. New faces join the point
    /// with the rim of the removed region.
    fn add_point(&mut self, point: Vector) {
        let number = self.points.len();
        let (d, from_middle) = (self.size.count(), &point - &self.middle);
        self.points.push(point);
        self.ridges.clear();
        let (faces, ridges) = (&mut self.faces, &mut self.ridges);
        self.alive.retain(|&k| {
            let face = &mut faces[k];
            face.is_alive = face.normal.dot(&from_middle) < 1.0 - SOLVED_ROUNDING;
            if !face.is_alive {
                for without in 0..d {
                    let mut ridge = face.vertices;
                    ridge[without..d].rotate_left(1);
                    ridge[d - 1] = number;
                    ridges.push(ridge);
                }
            }
            face.is_alive
        });
        // A ridge between two removed faces occurs twice; a ridge on the rim of the removed region occurs once. After sorting, equal ridges are
        // adjacent.
        let mut ridges = core::mem::take(&mut self.ridges);
        ridges.sort_unstable();
        for same in ridges.chunk_by(|a, b| a == b).filter(|same| same.len() == 1) {
            self.add(same[0]);
        }
        self.ridges = ridges;
    }

    /// Distance and unit normal of the face closest to the origin; `None` without a face.
    fn nearest(&mut self) -> Option<(f64, Vector)> {
        while let Some(first) = self.queue.peek() {
            let face = &self.faces[first.face];
            if face.is_alive {
                return Some((first.distance, face.normal.normalize()));
            }
            self.queue.pop();
        }
        None
    }
}

/// Bounds of the radius of the largest ball about the origin in the set with this support function. Let c be `closeness` times the distance of the
/// last support point from the origin. The search ends if the bounds differ by at most c, or if the upper bound is at most c. It ends early after
/// `most_points` points, with too many faces, or because of rounding. `None` if the polytope has no face.
pub(crate) fn largest_ball(
    support: &SupportFunction<'_>,
    simplex: &[Vertex],
    (closeness, most_points): (f64, usize),
) -> Option<BallBounds> {
    let mut polytope = Polytope::of(simplex);
    let mut bounds: Option<BallBounds> = None;
    let size = largest(simplex, &|vertex| vertex.at.norm());
    for _ in 0..most_points {
        let (distance, direction) = polytope.nearest()?;
        let shrinks = bounds
            .as_ref()
            .is_some_and(|known| known.at_least > 0.0 && distance < known.at_least - POLYTOPE_SHRINKS * size);
        // The number of faces is limited, since each new point of the polytope is compared with all of them.
        if shrinks || polytope.alive.len() > 20_000 {
            break;
        }
        let next = support(&direction);
        let reach = direction.dot(&next);
        let known = bounds.take().filter(|known| known.at_most <= reach);
        let mut now = known.unwrap_or(BallBounds { at_least: distance, at_most: reach, direction });
        now.at_least = distance.min(now.at_most);
        let (at_most, close) = (now.at_most, closeness * next.norm());
        bounds = Some(now);
        // The search ends if the bounds differ by at most `close`. It also ends if the upper bound is at most `close`. Up to this accuracy the set
        // contains no ball about the origin, and more points would not help.
        if at_most - distance <= close || at_most <= close {
            break;
        }
        polytope.add_point(next);
    }
    bounds
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::support::simplex;

    #[test]
    fn of_a_box_and_of_a_ball_that_are_not_in_the_middle() {
        let size = Size::of(4);
        let shift = Vector::from_fn(size, |k| [0.1, -0.3, 0.2, 0.0][k]);
        let cube = |v: &Vector| v.map(f64::signum) + &shift;
        let start = simplex(size, &cube).expect("thick");
        let bounds = largest_ball(&cube, &start, (1e-12, 1000)).expect("bounds");
        assert!((bounds.at_least - 0.7).abs() < 1e-12 && (bounds.at_most - 0.7).abs() < 1e-12, "{bounds:?}");
        assert!((bounds.direction[1] - 1.0).abs() < 1e-12);

        let ball = |v: &Vector| v.normalize() + &shift;
        let start = simplex(size, &ball).expect("thick");
        let bounds = largest_ball(&ball, &start, (1e-6, 3000)).expect("bounds");
        let known = 1.0 - shift.norm();
        assert!(bounds.at_least <= known && known <= bounds.at_most, "{bounds:?}");
        assert!(bounds.at_most - bounds.at_least < 1e-5, "{bounds:?}");
    }
}
