//! The rows of the friction cones in the coordinates x = K^{-1/2} F, each of unit length.

use nalgebra::SVector;

use crate::contact::{Polygon, PolygonCone};
use crate::grasp::{Hold, Site};

/// A friction row in the coordinates x: `normal·x_i >= 0`, `length` times which is `μ F_n - h·F_t`.
#[derive(Debug, Clone)]
pub(super) struct FrictionRow<const C: usize> {
    pub(super) contact: usize,
    pub(super) facet: Option<usize>,
    pub(super) normal: SVector<f64, C>,
    pub(super) length: f64,
    /// What the rounding of [`Self::value`] is measured against, with forces of size one.
    pub(super) weight: f64,
}

impl<const C: usize> FrictionRow<C> {
    fn new<const D: usize>(
        site: &Site<D, C>,
        contact: usize,
        facet: Option<usize>,
        law: SVector<f64, C>,
    ) -> Self {
        let normal = law.component_mul(&site.springs.root());
        let length = normal.norm();
        let weight = site.friction.round_weight();
        Self { contact, facet, normal: normal / length, length, weight }
    }

    /// K^{1/2} times the row: the change of force that the row's multiplier stands for.
    pub(super) fn in_springs<const D: usize>(&self, site: &Site<D, C>) -> SVector<f64, C> {
        self.normal.component_mul(&site.springs.root())
    }

    /// `μ F_n - h·F_t` of a force.
    pub(super) fn value<const D: usize>(&self, site: &Site<D, C>, force: &SVector<f64, C>) -> f64 {
        let part = |a: usize| self.length * self.normal[a] / site.springs.root_along(a) * force[a];
        (0..site.springs.axes()).map(part).sum()
    }
}

/// The rows of the cones: the facets of the polygon, and F_n >= 0 where there is no facet to say it.
pub(super) fn cone_rows<const D: usize, const C: usize>(
    sites: &[Site<D, C>],
    cone: &PolygonCone,
    pushes: impl Fn(&Site<D, C>) -> bool,
) -> Vec<FrictionRow<C>> {
    let polygon = Polygon::<C>::new(cone);
    let push = SVector::<f64, C>::from_fn(|a, _| if a == 0 { 1.0 } else { 0.0 });
    let mut rows = Vec::new();
    for (i, site) in sites.iter().enumerate() {
        if site.hold == Hold::Bonded {
            continue;
        }
        if site.friction.has_edges() {
            let facets = polygon.normals.iter().enumerate();
            let row = |(j, h): (usize, &SVector<f64, C>)| {
                FrictionRow::new(site, i, Some(j), site.friction.facet_row(h))
            };
            rows.extend(facets.map(row));
        } else if site.hold == Hold::Unilateral && pushes(site) {
            rows.push(FrictionRow::new(site, i, None, push));
        }
    }
    rows
}
