//! How far from a point inside a convex set a ray stays in it, as a simplex method on its support points.
//!
//! With points p_k of the set that the ray r crosses between, `r = Σ β_k p_k`, the plane through them is `v·x = 1`, and r leaves their simplex at `r / s` with
//! `s = Σ β_k`. If no point of the set lies beyond that plane, it is where the ray leaves the set. Else the farthest one takes the place of one of them,
//! and s becomes smaller.

use nalgebra::{SMatrix, SVector};

use super::coordinates::Square;
use super::partial_pivoting::PartialPivoting;
use super::support::{Vertex, middle};
use super::unit_vector::unit;
use crate::prelude::*;

/// A point that lies beyond the plane by this part of its distance from the middle is rounding.
const BEYOND: f64 = 1e-13;
/// A target this near the middle, as a part of the distance of both, is there.
const NOWHERE: f64 = 1e-14;
/// Pivots, unless rounding makes them go round.
const MOST_PIVOTS: usize = 1000;

/// A place where a ray leaves a set, up to the bounds.
#[derive(Debug, Clone)]
pub(crate) struct RayExit<const D: usize> {
    pub(crate) vertices: Vec<Vertex<D>>,
    /// β, not negative.
    pub(crate) shares: Vec<f64>,
    /// v: all of the set has `v·(x - middle) <= reach`.
    pub(crate) normal: SVector<f64, D>,
    /// One at least, and one but for rounding where the pivots came to their end.
    pub(crate) reach: f64,
    /// s: the target is this many times as far as where the ray leaves the simplex.
    pub(crate) stretch: f64,
}

/// Where the ray from the middle of a simplex to a target leaves the set. `None` where rounding allows no simplex.
pub(crate) fn shoot<const D: usize>(
    support: &impl Fn(&SVector<f64, D>) -> SVector<f64, D>,
    simplex: &[Vertex<D>],
    target: &SVector<f64, D>,
) -> Option<RayExit<D>> {
    let origin = middle(simplex);
    let ray = target - origin;
    if ray.norm() <= NOWHERE * (target.norm() + origin.norm()) {
        let vertices = simplex[..D].to_vec();
        return Some(RayExit { vertices, shares: vec![0.0; D], normal: unit(0), reach: 1.0, stretch: 0.0 });
    }
    let (mut vertices, mut shares) = first_face(simplex, &origin, &ray)?;
    let mut found: Option<RayExit<D>> = None;
    for _ in 0..MOST_PIVOTS {
        let points = matrix(&vertices, &origin);
        // Where the set is smooth, points come so close that rounding hides the plane through them: the last one is as good.
        let solvers = [points, points.transpose()].map(|matrix| PartialPivoting::new(&Square::from(matrix)));
        let [Some(solver), Some(transposed)] = solvers else { break };
        let normal = transposed.solve(&SVector::<f64, D>::repeat(1.0).into()).to_svector();
        let next = Vertex::of(support, normal);
        let reach = normal.dot(&(next.at - origin)).max(1.0);
        let stretch = normal.dot(&ray);
        found = Some(RayExit { vertices: vertices.clone(), shares: shares.clone(), normal, reach, stretch });
        if reach <= 1.0 + BEYOND {
            break;
        }
        let change = solver.solve(&(next.at - origin).into()).to_svector();
        let leaving = (0..D).filter(|&k| change[k] > BEYOND * change.amax()).min_by(|&a, &b| {
            let part = |k: usize| shares[k] / change[k];
            // Of ties the largest pivot.
            part(a).total_cmp(&part(b)).then(change[b].total_cmp(&change[a]))
        });
        let Some(leaving) = leaving else { break };
        let share = shares[leaving] / change[leaving];
        for k in 0..D {
            shares[k] = (shares[k] - share * change[k]).max(0.0);
        }
        (vertices[leaving], shares[leaving]) = (next, share);
    }
    found
}

fn matrix<const D: usize>(vertices: &[Vertex<D>], origin: &SVector<f64, D>) -> SMatrix<f64, D, D> {
    SMatrix::from_fn(|row, k| vertices[k].at[row] - origin[row])
}

/// The face of the simplex that the ray from its middle goes through: the one whose shares are least negative.
fn first_face<const D: usize>(
    simplex: &[Vertex<D>],
    origin: &SVector<f64, D>,
    ray: &SVector<f64, D>,
) -> Option<(Vec<Vertex<D>>, Vec<f64>)> {
    let face = |without: usize| {
        let vertices: Vec<_> = (0..=D).filter(|&k| k != without).map(|k| simplex[k]).collect();
        let shares = PartialPivoting::new(&Square::from(matrix(&vertices, origin)))?
            .solve(&(*ray).into())
            .to_svector();
        Some((vertices, shares))
    };
    let best = (0..=D).filter_map(face).max_by(|(_, a), (_, b)| a.min().total_cmp(&b.min()));
    best.map(|(vertices, shares)| (vertices, shares.iter().map(|share| share.max(0.0)).collect()))
}
