//! The joint effect of several data on a force: the force with all of them off at once, less the sum of their changes one by one.

use nalgebra::SVector;

use super::courses::forces_or_gaps;
use super::datum::{UncertainDatum, with_errors};
use super::failure::facets;
use super::margin::{FacetMargin, JointEffect, UncertainForce};
use super::off::factor;
use crate::contact::{Edges, State};
use crate::equilibrium::{Cone, StickingResponse};
use crate::grasp::{Engine, Wrench};
use crate::numerics::{IntoList, dot};
use crate::prelude::*;

/// The grasp whose data are uncertain, for its exact forces with several data off at once.
#[derive(Debug, Clone)]
pub(super) struct OffTogether {
    pub(super) grasp: Engine,
    pub(super) cone: Cone,
    pub(super) states: Vec<State>,
    pub(super) data: Vec<UncertainDatum>,
    /// Standard deviation of the logarithm of the load.
    pub(super) load_spread: f64,
}

impl OffTogether {
    /// The force of a site with these errors of the data, in standard deviations. `None` where errors leave the range of a datum.
    fn force(&self, i: usize, load: &Wrench<3>, z: &[f64]) -> Option<SVector<f64, 3>> {
        let grasp = with_errors(&self.grasp, &self.data, z).ok()?;
        let response = StickingResponse::in_states(&grasp, self.cone, &self.states);
        let load = *load * factor(self.load_spread * z[self.data.len()]);
        Some(forces_or_gaps(&response, &grasp.offsets(), &grasp.load_unchecked(&load))[i])
    }

    /// The joint effects at the points of failure of all facets of a site under a load, zero of facets that fail more rarely than `rare`.
    pub(super) fn of_facets(
        &self,
        (i, edges): (usize, &Edges),
        load: &Wrench<3>,
        here: &UncertainForce<'_>,
        rare: f64,
    ) -> Vec<JointEffect> {
        if self.data.is_empty() {
            return Vec::new();
        }
        let mut margin = FacetMargin::default();
        let of = |(row, facet): (usize, &SVector<f64, 3>)| {
            margin.start_over(here.changes.len());
            here.find(row, facet, &mut margin);
            if margin.fails() < rare {
                return JointEffect::default();
            }
            let z = &margin.fails_at;
            let force = self.force(i, load, z).map_or(SVector::zeros(), |force| force - here.at(z));
            JointEffect { force, bend: force * (2.0 / dot(z, z).max(f64::MIN_POSITIVE)) }
        };
        facets(edges, here).iter().enumerate().map(of).list()
    }
}
