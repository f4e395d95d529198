//! A place on a curve or surface: its normal, tangent directions, curvature, and distances to the edges of its segment or triangle.

use nalgebra::SVector;

use super::places::unit_direction;
use super::surface::Shape;
use crate::numerics::tolerances::{NEGLIGIBLE, SOLVED_ROUNDING};
use crate::numerics::{Draw, chosen, mapped, numbered, picked};
use crate::prelude::*;

/// A place on a curve or surface. `part` is the index of its segment or triangle (0 on other shapes). `at` are its coordinates on this part: lengths,
/// m, or angles, rad; on a sphere a unit direction.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SurfaceLocation {
    part: usize,
    at: [f64; 3],
    /// 1 if the contact's normal is the normal of the surface, -1 if the two are opposite.
    side: f64,
    pub(super) point: SVector<f64, 3>,
    /// Unit normal of the contact, into the object.
    pub(super) normal: SVector<f64, 3>,
    /// Unit tangent directions, perpendicular to each other: the principal directions of curvature.
    pub(super) along: Vec<SVector<f64, 3>>,
    /// Change of `normal` along each direction of `along` per metre in that direction, 1/m; positive if the normal tilts towards the direction.
    pub(super) bends: Vec<f64>,
    /// Linear limits of a step, one for each edge or end of the part of the surface (a segment, a triangle or the whole surface). A limit is a pair
    /// (a, b): a step with the components s, m, in the directions `along` stays on the part if `a·s <= b` for every pair.
    pub(super) rooms: Vec<([f64; 2], f64)>,
}

impl SurfaceLocation {
    fn new(surface: &Shape, part: usize, at: [f64; 3], side: f64) -> Self {
        let there = surface.surface_point(part, at);
        let (normal, bends) = (there.normal * side, mapped(&there.bends, &|bend| bend * side));
        Self { part, at, side, point: there.point, normal, along: there.along, bends, rooms: there.rooms }
    }

    /// The place on the surface nearest to a point. The normal there points to the same side of the surface as `normal`.
    pub(super) fn nearest(surface: &Shape, point: &SVector<f64, 3>, normal: &SVector<f64, 3>) -> Self {
        let spots = (0..surface.parts()).map(|part| {
            let location = Self::new(surface, part, surface.nearest_of(part, point), 1.0);
            let side = if location.normal.dot(normal) < 0.0 { -1.0 } else { 1.0 };
            if side > 0.0 { location } else { Self::new(surface, part, location.at, side) }
        });
        // At a point where segments or triangles meet, several places are equally near. The place with the least angle between its normal and
        // `normal` is chosen.
        let distance = |location: &Self| (location.point - point).norm();
        let turned = |location: &Self| 1.0 - location.normal.dot(normal) / normal.norm();
        let edge = SOLVED_ROUNDING * surface.largest();
        let mut best: Option<Self> = None;
        for location in spots {
            let better = best.as_ref().is_none_or(|best| {
                distance(&location) < distance(best) - edge
                    || (distance(&location) <= distance(best) + edge && turned(&location) < turned(best))
            });
            if better {
                best = Some(location);
            }
        }
        best.unwrap_or_else(|| Self::new(surface, 0, [0.0; 3], 1.0))
    }

    /// The place after a step with these lengths, m, along the tangent directions. At an end of its segment, arc, spline, rectangle or cylinder the
    /// step stops.
    pub(super) fn stepped(&self, surface: &Shape, step: &[f64]) -> Self {
        let [a, b, c] = self.at;
        let (first, second) = (step[0], step.get(1).copied().unwrap_or(0.0));
        let at = match surface {
            Shape::Segments(parts) => {
                let [from, to] = &parts[self.part];
                [(a + first).clamp(0.0, (to - from).norm()), 0.0, 0.0]
            }
            Shape::Arc { radius, over, .. } => {
                let angle = a + first / radius;
                [over.map_or(angle, |over| angle.clamp(0.0, over)), 0.0, 0.0]
            }
            Shape::Spline(spline) => [spline.within(a + first / spline.at(a)[1].norm()), 0.0, 0.0],
            Shape::Rectangle { sides, .. } => {
                [(a + first).clamp(0.0, sides[0].norm()), (b + second).clamp(0.0, sides[1].norm()), 0.0]
            }
            Shape::Cylinder { ends, radius } => {
                [(a + first).clamp(0.0, (ends[1] - ends[0]).norm()), b + second / radius, 0.0]
            }
            Shape::Sphere { radius, .. } => {
                let step = self.along[0] * first + self.along[1] * second;
                let angle = step.norm() / radius;
                let from = SVector::<f64, 3>::from([a, b, c]);
                let to = if angle > 0.0 { from * angle.cos() + step.normalize() * angle.sin() } else { from };
                unit_direction(&to)
            }
            Shape::Triangles(_) => [a + first, b + second, 0.0],
        };
        let mut moved = Self::new(surface, self.part, at, self.side);
        if let Shape::Sphere { .. } = surface {
            // The two tangent directions on a sphere are arbitrary. They are carried along to the new place instead of chosen anew, because the
            // search has learnt second derivatives along them.
            let across = self.along[0] - moved.normal * self.along[0].dot(&moved.normal);
            if across.norm() > 0.5 {
                let first = across.normalize();
                let second = self.along[1] - moved.normal * self.along[1].dot(&moved.normal);
                moved.along = vec![first, (second - first * second.dot(&first)).normalize()];
            }
        }
        moved
    }

    /// The same point as a place on each adjacent segment or triangle. Empty unless the place is at the end or edge of its own segment or triangle.
    pub(super) fn adjacent(&self, surface: &Shape) -> Vec<Self> {
        let near = NEGLIGIBLE * surface.largest();
        if surface.parts() == 1 || self.rooms.iter().all(|(_, room)| *room > near) {
            return Vec::new();
        }
        let others = chosen(surface.parts(), &|part| *part != self.part);
        let there = |part| Self::new(surface, part, surface.nearest_of(part, &self.point), self.side);
        let is_near = |location: &Self| (location.point - self.point).norm() <= near;
        picked(&others, &|part| Some(there(*part)).filter(is_near))
    }

    /// A random place on the whole surface, with uniform density. Its normal is on the same side of the surface as the normal of this place.
    pub(super) fn random(&self, surface: &Shape, draw: &mut Draw) -> Self {
        let sizes: Vec<f64> = numbered(surface.parts(), &|part| surface.size(part));
        let mut left = draw.uniform() * sizes.iter().sum::<f64>();
        let mut part = 0;
        while part + 1 < sizes.len() && left > sizes[part] {
            left -= sizes[part];
            part += 1;
        }
        let [u, v] = [draw.uniform(), draw.uniform()];
        // The corners of all triangles have the same sense, and all segments run in one direction. So the normals of all parts point to the same
        // side, and the side of the object is the same on every part.
        Self::new(surface, part, surface.random(part, [u, v]), self.side)
    }
}

#[cfg(test)]
mod tests {
    use super::super::surface::Surface;
    use super::*;

    /// Two segments of one length meet in a corner. Lengths of 1e-10 m, 1 m and 1e16 m give the same answers.
    #[test]
    fn only_an_end_has_parts_beside_it_whatever_the_unit() {
        for unit in [1e-10, 1.0, 1e16] {
            let Surface(corner) = Surface::polyline([[0.0, 0.0], [unit, 0.0], [unit, unit]]);
            let on_the_first = |part: f64| SurfaceLocation::new(&corner, 0, [part * unit, 0.0, 0.0], 1.0);
            assert!(on_the_first(0.5).adjacent(&corner).is_empty(), "{unit:e}");
            assert!(on_the_first(0.0).adjacent(&corner).is_empty(), "{unit:e}");
            let beside = on_the_first(1.0).adjacent(&corner);
            assert_eq!(beside.iter().map(|location| location.part).collect::<Vec<_>>(), [1], "{unit:e}");
        }
    }
}
