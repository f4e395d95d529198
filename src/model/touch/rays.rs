//! Parallel rays onto a part (the mesh of an object to be held): the positions at which the points of a pad meet the part as the pad closes.
//!
//! All rays have the same direction. Each triangle is therefore tested once, in coordinates along and across the rays, and most triangles lie outside
//! the pad. A tree of boxes is not built, since that takes longer.

use crate::numerics::mapped;

use nalgebra::{Matrix3, Vector3};

use super::pad::Pad;
use super::part::Part;

/// A ray that passes outside a triangle by less than this fraction of the bounding box's diagonal still meets the triangle: pads may be flush with an
/// edge of the part. The number is also the largest cosine of the angle between a triangle's normal and the rays at which the triangle counts as
/// parallel to the rays.
///
/// If this number is smaller, rounding decides whether a flush pad meets the part; if it is larger, rays meet the part beside its edges.
pub(super) const FLUSH: f64 = 1e-9;

/// The point where a ray from the pad first meets the part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RayHit {
    /// Distance along the ray, m, from the plane normal to the closing direction that contains the pad's centre.
    pub(super) depth: f64,
    /// Unit normal of the triangle that the ray meets, pointing into the part.
    pub(super) normal: Vector3<f64>,
    /// Whether the ray leaves the part at this triangle, which means that the ray started inside the part.
    pub(super) leaves: bool,
}

/// The points where a pad meets the part.
pub(super) struct PadHits {
    /// The hit of the ray from each point of the pad; `None` for a ray that misses the part.
    pub(super) hits: Vec<Option<RayHit>>,
    /// Least travel of the pad along the closing direction, m, at which it touches the part. Touch is detected at the sample points and the centre of
    /// the pad, and at the vertices of the mesh.
    pub(super) foremost: f64,
}

impl Part {
    /// The positions at which a pad meets the part: the first hit of the ray from each of its points, and from its centre. The columns of
    /// `frame` are the closing direction and two tangents; `from` is the centre of the pad.
    pub(super) fn hits_of_pad(&self, pad: &Pad, frame: &Matrix3<f64>, from: &Vector3<f64>) -> PadHits {
        let near = FLUSH * self.size;
        let mut rays: Vec<Vector3<f64>> = mapped(&pad.points, &|point| point.offset);
        rays.extend(pad.middle());
        let mut hits: Vec<Option<RayHit>> = vec![None; rays.len()];
        let mut foremost = f64::INFINITY;
        let (mut least, mut most) = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
        for ray in &rays {
            (least, most) = (least.inf(ray), most.sup(ray));
        }
        let (least, most) = (least.add_scalar(-near), most.add_scalar(near));
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|corner| frame.tr_mul(&(corner - from)));
            let (low, high) = (a.inf(&b).inf(&c), a.sup(&b).sup(&c));
            let beside = |axis: usize| high[axis] < least[axis] || low[axis] > most[axis];
            if beside(1) || beside(2) || high[0] < least[0] {
                continue;
            }
            let normal = (b - a).cross(&(c - a));
            let length = normal.norm();
            // A triangle that has no area, or is parallel to the rays, is skipped.
            if normal[0].abs() <= FLUSH * length {
                continue;
            }
            let orientation = normal[0].signum();
            // Returns whether `ray` lies on the triangle's side of the edge from p to q, seen along the rays. A ray on the other side counts if its
            // distance from the edge is at most `near`, m.
            let inside = |p: &Vector3<f64>, q: &Vector3<f64>, ray: &Vector3<f64>| {
                let (along, to) = ((q[1] - p[1], q[2] - p[2]), (ray[1] - p[1], ray[2] - p[2]));
                orientation * (along.0 * to.1 - along.1 * to.0) >= -near * along.0.hypot(along.1)
            };
            for corner in [&a, &b, &c] {
                let travel = pad.height_at(corner[1], corner[2]).map(|height| corner[0] - height);
                foremost =
                    travel.filter(|travel| *travel >= -near).map_or(foremost, |travel| foremost.min(travel));
            }
            for (ray, hit) in rays.iter().zip(&mut hits) {
                if !(inside(&a, &b, ray) && inside(&b, &c, ray) && inside(&c, &a, ray)) {
                    continue;
                }
                let across = normal[1] * (ray[1] - a[1]) + normal[2] * (ray[2] - a[2]);
                let depth = a[0] - across / normal[0];
                let leaves = normal[0] > 0.0;
                if depth < ray[0] - near {
                    continue;
                }
                let sooner = hit.is_none_or(|before| {
                    depth < before.depth - near || (depth < before.depth + near && before.leaves && !leaves)
                });
                if sooner {
                    *hit = Some(RayHit { depth, normal: frame * normal / -length, leaves });
                }
            }
        }
        for (ray, hit) in rays.iter().zip(&hits) {
            foremost = hit.map_or(foremost, |hit| foremost.min(hit.depth - ray[0]));
        }
        hits.truncate(pad.points.len());
        PadHits { hits, foremost }
    }
}
