//! The exit of a ray from a convex set, by a simplex method on the set's support points.
//!
//! Let points p_k of the set span a cone that contains the ray r, `r = Σ β_k p_k`. The plane through them is `v·x = 1`, and r leaves their simplex at
//! `r / s` with `s = Σ β_k`. If no point of the set lies beyond that plane, the ray leaves the set there. Otherwise the farthest point beyond it
//! replaces one of them, and s decreases.

use nalgebra::{SMatrix, SVector};

use super::coordinates::Square;
use super::partial_pivoting::PartialPivoting;
use super::support::{Vertex, middle};
use super::unit_vector::unit;
use crate::prelude::*;

/// Relative distance beyond a plane, or relative size of a pivot, that counts as rounding.
const BEYOND: f64 = 1e-13;
/// A target this near the middle, relative to the distances of both from the origin, equals it.
const NOWHERE: f64 = 1e-14;
/// Largest number of pivots, against cycles by rounding.
const MOST_PIVOTS: usize = 1000;

/// A place where a ray leaves a set, between two bounds.
#[derive(Debug, Clone)]
pub(crate) struct RayExit<const D: usize> {
    pub(crate) vertices: Vec<Vertex<D>>,
    /// β, not negative.
    pub(crate) shares: Vec<f64>,
    /// v: all of the set has `v·(x - middle) <= reach`.
    pub(crate) normal: SVector<f64, D>,
    /// At least one, and one up to rounding if the pivots have converged.
    pub(crate) reach: f64,
    /// s: the distance of the target in units of that at which the ray leaves the simplex.
    pub(crate) stretch: f64,
}

/// The exit of the ray from the middle of a simplex to a target. `None` if rounding leaves no simplex.
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
        // Where the set is smooth, points come so close that rounding corrupts the plane through them: the result so far is kept.
        let solvers = [points, points.transpose()].map(|matrix| PartialPivoting::new(&Square::from(matrix)));
        let [Some(solver), Some(transposed)] = solvers else { break };
        let normal = transposed.solve(&SVector::<f64, D>::repeat(1.0).into()).to_svector::<D>();
        let next = Vertex::of(support, normal);
        let reach = normal.dot(&(next.at - origin)).max(1.0);
        let stretch = normal.dot(&ray);
        found = Some(RayExit { vertices: vertices.clone(), shares: shares.clone(), normal, reach, stretch });
        if reach <= 1.0 + BEYOND {
            break;
        }
        let change = solver.solve(&(next.at - origin).into()).to_svector::<D>();
        let leaving = (0..D).filter(|&k| change[k] > BEYOND * change.amax()).min_by(|&a, &b| {
            let part = |k: usize| shares[k] / change[k];
            // Among ties the largest pivot.
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

/// The face of the simplex that the ray from its middle passes: the one with the largest least share.
fn first_face<const D: usize>(
    simplex: &[Vertex<D>],
    origin: &SVector<f64, D>,
    ray: &SVector<f64, D>,
) -> Option<(Vec<Vertex<D>>, Vec<f64>)> {
    let face = |without: usize| {
        let vertices: Vec<_> = (0..=D).filter(|&k| k != without).map(|k| simplex[k]).collect();
        let shares = PartialPivoting::new(&Square::from(matrix(&vertices, origin)))?
            .solve(&(*ray).into())
            .to_svector::<D>();
        Some((vertices, shares))
    };
    let best = (0..=D).filter_map(face).max_by(|(_, a), (_, b)| a.min().total_cmp(&b.min()));
    best.map(|(vertices, shares)| (vertices, shares.iter().map(|share| share.max(0.0)).collect()))
}
