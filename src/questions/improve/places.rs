//! The geometry of each curve or surface: the point at given coordinates, the coordinates nearest to a point, and uniformly random coordinates. A
//! "part" of a shape is one segment of a polyline or one triangle of a mesh; other shapes have a single part.

use nalgebra::SVector;

use super::surface::Shape;
use crate::numerics::{Each, largest, lowest, numbered};
use crate::prelude::*;

pub(super) fn unit_direction(to: &SVector<f64, 3>) -> [f64; 3] {
    to.normalize().into()
}

/// The local geometry of a curve or surface at one point of it.
pub(super) struct SurfacePoint {
    /// The point of the curve or surface, m.
    pub(super) point: SVector<f64, 3>,
    /// Unit normal at the point.
    pub(super) normal: SVector<f64, 3>,
    /// Unit tangent directions at the point: one of a curve, two of a surface.
    pub(super) along: Vec<SVector<f64, 3>>,
    /// Change of the unit normal along each direction of `along` per metre in that direction, 1/m; positive if the normal tilts towards the
    /// direction, as on a convex shape.
    pub(super) bends: Vec<f64>,
    /// Linear limits of a step from the point, one for each edge or end of its part of the shape (a segment, a triangle or the whole shape). A limit
    /// is a pair (a, b): a step with the components s, m, in the directions `along` stays on the part if `a·s <= b` for every pair.
    pub(super) rooms: Vec<([f64; 2], f64)>,
}

/// The vector a of the plane, turned clockwise by a right angle.
pub(super) fn clockwise(a: &SVector<f64, 3>) -> SVector<f64, 3> {
    [a[1], -a[0], 0.0].into()
}

/// A unit vector at a right angle to the given unit vectors. In the plane it is the only given vector, turned clockwise. In space it is the cross
/// product of the two given vectors, which are perpendicular.
fn perpendicular(along: &[SVector<f64, 3>]) -> SVector<f64, 3> {
    match along {
        [a, b, ..] => a.cross(b),
        [a] => clockwise(a),
        [] => SVector::zeros(),
    }
}

/// Two unit directions in space that are perpendicular to `axis` and to each other.
fn both_across(axis: &SVector<f64, 3>) -> [SVector<f64, 3>; 2] {
    let mut least = SVector::zeros();
    least[axis.iamin()] = 1.0;
    let first = (least - axis * axis.dot(&least)).normalize();
    [first, perpendicular(&[*axis, first])]
}

/// The point with the coordinates `a` and `b`, m, along the directions of [`frame`] in the plane of a triangle, with normal, tangents and distances
/// to the edges.
fn on_triangle(corners: &[SVector<f64, 3>; 3], [a, b]: [f64; 2]) -> SurfacePoint {
    let [x, y] = frame(corners);
    let point = corners[0] + x * a + y * b;
    let (along, normal) = (vec![x, y], perpendicular(&[x, y]));
    let room = |k: usize| {
        let (from, to) = (corners[k], corners[(k + 1) % 3]);
        // The corners are counterclockwise in this frame, so the outside is to the right of each edge, seen from its first to its second corner.
        let out = perpendicular(&[(to - from).normalize(), normal]);
        ([out.dot(&x), out.dot(&y)], -out.dot(&(point - from)))
    };
    SurfacePoint { point, normal, bends: vec![0.0; 2], rooms: numbered(3, &room), along }
}

impl Shape {
    pub(super) fn parts(&self) -> usize {
        match self {
            Shape::Segments(parts) => parts.len(),
            Shape::Triangles(parts) => parts.len(),
            _ => 1,
        }
    }

    /// The weight of a part in the random choice among parts of a shape: the length of a segment, m, or twice the area of a triangle, m². The weight
    /// is 1 for a shape with one part.
    pub(super) fn size(&self, part: usize) -> f64 {
        match self {
            Shape::Segments(parts) => (parts[part][1] - parts[part][0]).norm(),
            Shape::Triangles(parts) => {
                let [a, b, c] = &parts[part];
                perpendicular(&[b - a, c - a]).norm()
            }
            _ => 1.0,
        }
    }

    /// The largest magnitude of a coordinate of a corner of a segment or triangle, m; zero for other shapes. Rounding errors of points are relative
    /// to it.
    pub(super) fn largest(&self) -> f64 {
        let of = |corners: &[SVector<f64, 3>]| largest(corners, &SVector::amax);
        match self {
            Shape::Segments(parts) => of(parts.as_flattened()),
            Shape::Triangles(parts) => of(parts.as_flattened()),
            _ => 0.0,
        }
    }

    pub(super) fn surface_point(&self, part: usize, at: [f64; 3]) -> SurfacePoint {
        let [a, b, c] = at;
        let between = |axis: usize, at: f64, length: f64| {
            let row = |sign: f64| [0, 1].each(|k| if k == axis { sign } else { 0.0 });
            [(row(1.0), length - at), (row(-1.0), at)]
        };
        match self {
            Shape::Segments(parts) => {
                let [from, to] = &parts[part];
                let (along, length) = ((to - from).normalize(), (to - from).norm());
                let along = vec![along];
                SurfacePoint {
                    point: from + along[0] * a,
                    normal: perpendicular(&along),
                    along,
                    bends: vec![0.0],
                    rooms: between(0, a, length).into(),
                }
            }
            Shape::Arc { centre, radius, from, over } => {
                let (sin, cos) = (from + a).sin_cos();
                let out = SVector::<f64, 3>::from([cos, sin, 0.0]);
                let along = SVector::<f64, 3>::from([-sin, cos, 0.0]);
                let rooms = over.map_or(Vec::new(), |over| between(0, a * radius, over * radius).into());
                let point = centre + out * *radius;
                SurfacePoint { point, normal: out, along: vec![along], bends: vec![1.0 / radius], rooms }
            }
            Shape::Spline(spline) => {
                let [point, first, second] = spline.at(a);
                let speed = first.norm();
                let along = vec![first / speed];
                let normal = perpendicular(&along);
                // Let n be the normal, p the point of the spline and p' its derivative with respect to the parameter of the spline. The derivative of
                // `n·p' = 0` along the curve gives the change of n along p' per metre, `-n·p'' / |p'|²`.
                let bends = vec![-normal.dot(&second) / (speed * speed)];
                let open = !spline.is_closed();
                let rooms =
                    if open { between(0, a * speed, spline.end() * speed).into() } else { Vec::new() };
                SurfacePoint { point, normal, along, bends, rooms }
            }
            Shape::Rectangle { corner, sides } => {
                let along = sides.each(|side| side.normalize());
                let mut rooms = Vec::from(between(0, a, sides[0].norm()));
                rooms.extend(between(1, b, sides[1].norm()));
                let point = corner + along[0] * a + along[1] * b;
                SurfacePoint {
                    point,
                    normal: perpendicular(&along),
                    along: along.to_vec(),
                    bends: vec![0.0; 2],
                    rooms,
                }
            }
            Shape::Cylinder { ends, radius } => {
                let axis = ends[1] - ends[0];
                let (length, axis) = (axis.norm(), axis.normalize());
                let [x, y] = both_across(&axis);
                let (sin, cos) = b.sin_cos();
                let (out, around) = (x * cos + y * sin, y * cos - x * sin);
                let point = ends[0] + axis * a + out * *radius;
                let rooms = between(0, a, length).into();
                SurfacePoint {
                    point,
                    normal: out,
                    along: vec![axis, around],
                    bends: vec![0.0, 1.0 / radius],
                    rooms,
                }
            }
            Shape::Sphere { centre, radius } => {
                let out = SVector::<f64, 3>::from([a, b, c]);
                let along = both_across(&out).to_vec();
                SurfacePoint {
                    point: centre + out * *radius,
                    normal: out,
                    along,
                    bends: vec![1.0 / radius; 2],
                    rooms: Vec::new(),
                }
            }
            Shape::Triangles(parts) => on_triangle(&parts[part], [a, b]),
        }
    }

    /// The coordinates of the place on this part that is nearest to a point.
    pub(super) fn nearest_of(&self, part: usize, point: &SVector<f64, 3>) -> [f64; 3] {
        match self {
            Shape::Segments(parts) => {
                let [from, to] = &parts[part];
                let along = (to - from).normalize();
                [along.dot(&(point - from)).clamp(0.0, (to - from).norm()), 0.0, 0.0]
            }
            Shape::Arc { centre, from, over, .. } => {
                let away = point - centre;
                let angle = (away[1].atan2(away[0]) - from).rem_euclid(core::f64::consts::TAU);
                let beyond = |over: f64| {
                    let nearer_to_begin = core::f64::consts::TAU - angle < angle - over;
                    if nearer_to_begin { 0.0 } else { over }
                };
                [over.map_or(angle, |over| if angle <= over { angle } else { beyond(over) }), 0.0, 0.0]
            }
            Shape::Spline(spline) => [spline.nearest(point), 0.0, 0.0],
            Shape::Rectangle { corner, sides } => {
                let at = |k: usize| {
                    let side = &sides[k];
                    (side.normalize().dot(&(point - corner))).clamp(0.0, side.norm())
                };
                [at(0), at(1), 0.0]
            }
            Shape::Cylinder { ends, .. } => {
                let axis = ends[1] - ends[0];
                let (length, axis) = (axis.norm(), axis.normalize());
                let [x, y] = both_across(&axis);
                let away = point - ends[0];
                [axis.dot(&away).clamp(0.0, length), y.dot(&away).atan2(x.dot(&away)), 0.0]
            }
            Shape::Sphere { centre, .. } => {
                let away = point - centre;
                unit_direction(&if away.norm() > 0.0 { away } else { SVector::repeat(1.0) })
            }
            Shape::Triangles(parts) => {
                let corners = &parts[part];
                let [x, y] = frame(corners);
                let flat = |p: &SVector<f64, 3>| [x.dot(&(p - corners[0])), y.dot(&(p - corners[0]))];
                let ([u, v], there) =
                    (flat(point), |at: [f64; 2]| self.surface_point(part, [at[0], at[1], 0.0]));
                if there([u, v]).rooms.iter().all(|(_, room)| *room >= 0.0) {
                    return [u, v, 0.0];
                }
                let on_side = |k: usize| {
                    let (from, to) = (corners[k], corners[(k + 1) % 3]);
                    let side = to - from;
                    from + side * (side.dot(&(point - from)) / side.norm_squared()).clamp(0.0, 1.0)
                };
                let on_sides = [0, 1, 2].each(on_side);
                let nearest = lowest(&on_sides, &|p| (p - point).norm());
                let [u, v] = flat(nearest.unwrap_or(&corners[0]));
                [u, v, 0.0]
            }
        }
    }

    /// The coordinates of a random place on this part, from two numbers u and v that are uniformly distributed between 0 and 1. The place then has
    /// uniform density, on a spline with respect to its parameter.
    pub(super) fn random(&self, part: usize, [u, v]: [f64; 2]) -> [f64; 3] {
        let turn = core::f64::consts::TAU;
        match self {
            Shape::Segments(parts) => [u * (parts[part][1] - parts[part][0]).norm(), 0.0, 0.0],
            Shape::Arc { over, .. } => [u * over.unwrap_or(turn), 0.0, 0.0],
            Shape::Spline(spline) => [u * spline.end(), 0.0, 0.0],
            Shape::Rectangle { sides, .. } => [u * sides[0].norm(), v * sides[1].norm(), 0.0],
            Shape::Cylinder { ends, .. } => [u * (ends[1] - ends[0]).norm(), v * turn, 0.0],
            Shape::Sphere { .. } => {
                let (z, (sin, cos)) = (2.0 * u - 1.0, (turn * v).sin_cos());
                let radius = (1.0 - z * z).sqrt();
                [radius * cos, radius * sin, z]
            }
            Shape::Triangles(parts) => {
                let corners = &parts[part];
                let [x, y] = frame(corners);
                let [u, v] = if u + v > 1.0 { [1.0 - u, 1.0 - v] } else { [u, v] };
                let away = (corners[1] - corners[0]) * u + (corners[2] - corners[0]) * v;
                [x.dot(&away), y.dot(&away), 0.0]
            }
        }
    }
}

/// Two perpendicular unit directions in the plane of a triangle, the first from its first to its second corner.
fn frame(corners: &[SVector<f64, 3>; 3]) -> [SVector<f64, 3>; 2] {
    let x = (corners[1] - corners[0]).normalize();
    let other = corners[2] - corners[0];
    [x, (other - x * x.dot(&other)).normalize()]
}
