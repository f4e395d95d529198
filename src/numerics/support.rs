//! Convex sets described by their support function, which returns the farthest point in each direction.

use super::coordinates::{Size, Vector};
use super::orthonormal_set::orthogonal_part;
use super::tolerances::FLAT_SET;
use crate::numerics::Each;
use crate::prelude::*;

/// The support function of a convex set: returns the farthest point of the set in a given direction.
pub(crate) type SupportFunction<'s> = dyn Fn(&Vector) -> Vector + 's;

/// A support point of a set, and the direction in which no point of the set lies farther.
#[derive(Debug, Clone)]
pub(crate) struct Vertex {
    pub(crate) at: Vector,
    pub(crate) towards: Vector,
}

impl Vertex {
    /// The support point in a direction.
    pub(crate) fn of(support: &SupportFunction<'_>, towards: Vector) -> Self {
        Self { at: support(&towards), towards }
    }
}

/// The corners of a simplex with volume: support points, one more than the number of dimensions. If the set is flat, the error holds orthonormal
/// directions in which the set has no extent.
pub(crate) fn simplex(size: Size, support: &SupportFunction<'_>) -> Result<Vec<Vertex>, Vec<Vector>> {
    let first = Vertex::of(support, Vector::unit(size, 0));
    let origin = first.at.clone();
    let (mut extent, mut vertices, mut flat) = (origin.norm(), vec![first], Vec::new());
    let mut taken: Vec<Vector> = Vec::new();
    for _ in 0..size.count() {
        let axes = (0..size.count()).map(|axis| orthogonal_part(Vector::unit(size, axis), &taken));
        let Some(axis) = axes.max_by(|a, b| a.norm().total_cmp(&b.norm())) else { break };
        let axis = axis.normalize();
        let ends = [axis.clone(), -&axis].each(|towards| Vertex::of(support, towards));
        extent = ends.iter().map(|end| end.at.norm()).fold(extent, f64::max);
        let reach = |end: &Vertex| axis.dot(&(&end.at - &origin)).abs();
        let [ahead, behind] = &ends;
        let far = if reach(ahead) >= reach(behind) { ahead } else { behind };
        if reach(far) <= FLAT_SET * extent {
            flat.push(axis.clone());
            taken.push(axis);
        } else {
            taken.push(orthogonal_part(&far.at - &origin, &taken).normalize());
            vertices.push(far.clone());
        }
    }
    if flat.is_empty() { Ok(vertices) } else { Err(flat) }
}

/// The mean of some points; it is an interior point of the set if they do not lie in one hyperplane.
pub(crate) fn middle(vertices: &[Vertex]) -> Vector {
    let mut sum = Vector::zeros();
    for vertex in vertices {
        sum += &vertex.at;
    }
    sum / vertices.len() as f64
}
