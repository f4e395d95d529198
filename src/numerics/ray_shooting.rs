//! The point where a ray leaves a convex set, by a simplex method on support points of the set.
//!
//! The ray starts at an interior point of the set, the middle of a simplex of support points, and leads to a target. In the formulas vectors start at
//! this middle, too. Let points p_k of the set span a cone that contains the vector r from the middle to the target, `r = Σ β_k p_k`. The plane
//! through these points is `v·x = 1`, and the ray crosses it at `r / s` with `s = Σ β_k`. If no point of the set lies beyond that plane, the ray
//! leaves the set at this crossing. Otherwise the point farthest beyond the plane replaces one of the p_k, and s decreases.

use super::coordinates::{Size, Square, Vector};
use super::partial_pivoting::PartialPivoting;
use super::support::{SupportFunction, Vertex, middle};
use super::tolerances::BEYOND_PLANE;
use crate::numerics::Reals;
use crate::prelude::*;

/// Bounds for the point where the ray from the middle of a simplex to a target leaves a convex set. As a fraction of the way from the middle to
/// the target, the point lies between 1 / `stretch` and `upper_bound` / `stretch`.
#[derive(Debug, Clone)]
pub(crate) struct RayExit {
    pub(crate) vertices: Vec<Vertex>,
    /// Coefficients `β_k >= 0` of the vertices p_k with `Σ β_k (p_k - middle) = target - middle`; their sum is `stretch`.
    pub(crate) coefficients: Vector,
    /// Normal v of the plane of `vertices`: all points x of the set satisfy `v·(x - middle) <= upper_bound`, with the middle of the simplex from
    /// which the ray starts.
    pub(crate) normal: Vector,
    /// The upper bound in `v·(x - middle) <= upper_bound`. It is at least one, and equals one up to rounding if the pivots have converged.
    pub(crate) upper_bound: f64,
    /// The sum s of `coefficients`. It is the distance from the middle of the simplex to the target, divided by the distance from this middle to the
    /// plane of `vertices`, both along the ray.
    pub(crate) stretch: f64,
}

/// The exit of the ray from the middle of a simplex to a target. `None` if rounding corrupts all faces of the simplex.
pub(crate) fn shoot(support: &SupportFunction<'_>, simplex: &[Vertex], target: &Vector) -> Option<RayExit> {
    let size = Size::of(simplex.len() - 1);
    let origin = middle(simplex);
    let ray = target - &origin;
    if ray.norm() <= BEYOND_PLANE * (target.norm() + origin.norm()) {
        let (vertices, normal) = (simplex[..size.count()].to_vec(), Vector::unit(size, 0));
        return Some(RayExit {
            vertices,
            coefficients: Vector::all_zero(size),
            normal,
            upper_bound: 1.0,
            stretch: 0.0,
        });
    }
    let (mut vertices, mut coefficients) = first_face(simplex, &origin, &ray)?;
    let mut found: Option<RayExit> = None;
    // The number of simplex pivots is limited, since rounding could cause cycling.
    for _ in 0..1000 {
        let points = matrix(&vertices, &origin);
        // If the set is smooth, the vertices come so close together that rounding corrupts the plane through them. The search then ends with the
        // result of the previous pivot.
        let solvers = [PartialPivoting::new(&points), PartialPivoting::new(&points.transpose())];
        let [Some(solver), Some(transposed)] = solvers else { break };
        let normal = transposed.solve(&Vector::from_fn(size, |_| 1.0));
        let next = Vertex::of(support, normal.clone());
        let beyond = &next.at - &origin;
        let upper_bound = normal.dot(&beyond).max(1.0);
        let stretch = normal.dot(&ray);
        found = Some(RayExit {
            vertices: vertices.clone(),
            coefficients: coefficients.clone(),
            normal,
            upper_bound,
            stretch,
        });
        if upper_bound <= 1.0 + BEYOND_PLANE {
            break;
        }
        let change = solver.solve(&beyond);
        let least = BEYOND_PLANE * change.amax();
        let leaving = (0..size.count()).filter(|&k| change[k] > least).min_by(|&a, &b| {
            let part = |k: usize| coefficients[k] / change[k];
            // `part` is the ratio of coefficient and pivot, and the vertex with the least ratio is replaced. Among equal ratios the largest pivot is
            // taken, for accuracy.
            part(a).total_cmp(&part(b)).then(change[b].total_cmp(&change[a]))
        });
        let Some(leaving) = leaving else { break };
        let coefficient = coefficients[leaving] / change[leaving];
        for k in 0..size.count() {
            coefficients[k] = (coefficients[k] - coefficient * change[k]).max(0.0);
        }
        (vertices[leaving], coefficients[leaving]) = (next, coefficient);
    }
    found
}

/// Positions of vertices relative to the middle of the simplex, where the ray starts, as columns.
fn matrix(vertices: &[Vertex], origin: &Vector) -> Square {
    Square::from_columns(Size::of(vertices.len()), |k| &vertices[k].at - origin)
}

/// The face of the simplex through which the ray from its middle passes, with the coefficients β. The ray passes through the face whose β are all
/// positive; against rounding, the face whose least β is largest is taken. `None` if rounding corrupts all faces.
fn first_face(simplex: &[Vertex], origin: &Vector, ray: &Vector) -> Option<(Vec<Vertex>, Vector)> {
    let mut best: Option<(Vec<Vertex>, Vector, f64)> = None;
    for without in 0..simplex.len() {
        let mut vertices = simplex.to_vec();
        vertices.remove(without);
        let Some(solver) = PartialPivoting::new(&matrix(&vertices, origin)) else { continue };
        let coefficients = solver.solve(ray);
        let least = coefficients.iter().copied().least();
        if best.as_ref().is_none_or(|(_, _, most)| least >= *most) {
            best = Some((vertices, coefficients, least));
        }
    }
    best.map(|(vertices, coefficients, _)| (vertices, coefficients.map(|coefficient| coefficient.max(0.0))))
}
