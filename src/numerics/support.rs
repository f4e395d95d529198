//! Convex sets given by their support function: in each direction the farthest point.

use nalgebra::SVector;

use super::unit_vector::unit;
use crate::prelude::*;

/// A set thinner than this part of its size in some direction counts as flat.
const FLAT: f64 = 1e-10;

/// A support point of a set, with its direction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Vertex<const D: usize> {
    pub(crate) at: SVector<f64, D>,
    pub(crate) towards: SVector<f64, D>,
}

impl<const D: usize> Vertex<D> {
    /// The support point in a direction.
    pub(crate) fn of(
        support: &impl Fn(&SVector<f64, D>) -> SVector<f64, D>,
        towards: SVector<f64, D>,
    ) -> Self {
        Self { at: support(&towards), towards }
    }
}

/// `D + 1` points of the set that do not lie in one plane; or, as error, orthonormal directions in which the set is flat.
pub(crate) fn simplex<const D: usize>(
    support: &impl Fn(&SVector<f64, D>) -> SVector<f64, D>,
) -> Result<Vec<Vertex<D>>, Vec<SVector<f64, D>>> {
    let first = Vertex::of(support, unit(0));
    let (mut vertices, mut flat) = (vec![first], Vec::new());
    let mut taken: Vec<SVector<f64, D>> = Vec::new();
    let across = |taken: &[SVector<f64, D>], mut x: SVector<f64, D>| {
        // Twice, so that rounding leaves no part along the others.
        for v in taken.iter().chain(taken) {
            x -= v * v.dot(&x);
        }
        x
    };
    let mut size = first.at.norm();
    for _ in 0..D {
        let axes = (0..D).map(|axis| across(&taken, unit(axis)));
        let Some(axis) = axes.max_by(|a, b| a.norm().total_cmp(&b.norm())) else { break };
        let axis = axis.normalize();
        let ends = [axis, -axis].map(|towards| Vertex::of(support, towards));
        size = ends.iter().map(|end| end.at.norm()).fold(size, f64::max);
        let reach = |end: &Vertex<D>| axis.dot(&(end.at - first.at)).abs();
        let far = if reach(&ends[0]) >= reach(&ends[1]) { ends[0] } else { ends[1] };
        if reach(&far) <= FLAT * size {
            flat.push(axis);
            taken.push(axis);
        } else {
            taken.push(across(&taken, far.at - first.at).normalize());
            vertices.push(far);
        }
    }
    if flat.is_empty() { Ok(vertices) } else { Err(flat) }
}

/// The mean of some points: an interior point if they do not lie in one plane.
pub(crate) fn middle<const D: usize>(vertices: &[Vertex<D>]) -> SVector<f64, D> {
    vertices.iter().map(|vertex| vertex.at).sum::<SVector<f64, D>>() / vertices.len() as f64
}
