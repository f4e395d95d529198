//! The interaction of errors of several data in their effect on a contact force. It is the change of the force if all data are in error at once, less
//! the sum of the changes due to each datum alone. It is computed at the point of failure of a facet: the smallest errors at which the margin of this
//! facet vanishes (see [`margin`](super::margin)).

use nalgebra::{SMatrix, SVector};

use super::contact_errors::factor;
use super::datum::{UncertainDatum, with_errors};
use super::failure::facets;
use super::margin::{FacetMargin, Interaction, UncertainForce};
use super::source_forces::forces_or_gaps;
use crate::contact::{Edges, State};
use crate::equilibrium::{Cone, StickingResponse};
use crate::grasp::{Engine, Wrench};
use crate::numerics::{Draw, IntoList, dot, numbered};
use crate::prelude::*;

/// Number of random sets of errors, each with plus or minus one standard deviation per datum, from which the size of interactions is estimated.
///
/// If larger, more equilibria are computed for each load with reserve. If smaller, the estimate is less certain.
const PROBES: u64 = 8;

/// The grasp whose data are uncertain, in fixed contact states (each contact sticks or is open): gives exact contact forces with several data in
/// error at once.
#[derive(Debug, Clone)]
pub(super) struct PerturbedGrasp {
    pub(super) grasp: Engine,
    pub(super) cone: Cone,
    pub(super) states: Vec<State>,
    pub(super) data: Vec<UncertainDatum>,
    /// Standard deviation σ of the logarithm of the factor on the load.
    pub(super) load_spread: f64,
}

impl PerturbedGrasp {
    /// The exact force on contact or joint drive `i` under `load`, N. The entries of `z` are errors in standard deviations: of the uncertain data,
    /// then of the load factor. A further entry, the error of friction, is not used. `None` if a datum leaves its allowed range.
    fn force(&self, i: usize, load: &Wrench<3>, z: &[f64]) -> Option<SVector<f64, 3>> {
        let grasp = with_errors(&self.grasp, &self.data, z).ok()?;
        let response = StickingResponse::in_states(&grasp, self.cone, &self.states);
        let load = *load * factor(self.load_spread * z[self.data.len()]);
        Some(forces_or_gaps(&response, &grasp.offsets(), &grasp.load_unchecked(&load))[i])
    }

    /// The interaction of the errors of all data for each facet of a contact, at the facet's point of failure under a load. Zero for facets whose
    /// failure probability is below `rare`; an empty list without uncertain data.
    pub(super) fn of_facets(
        &self,
        (i, edges): (usize, &Edges),
        load: &Wrench<3>,
        here: &UncertainForce<'_>,
        rare: f64,
    ) -> Vec<Interaction> {
        if self.data.is_empty() {
            return Vec::new();
        }
        let mut margin = FacetMargin::default();
        let of = |(row, facet): (usize, &SVector<f64, 3>)| {
            margin.start_over(here.changes.len());
            here.find(row, facet, &mut margin);
            if margin.fails() < rare {
                return Interaction::default();
            }
            let beyond =
                |z: &[f64]| self.force(i, load, z).map_or(SVector::zeros(), |force| force - here.at(z));
            let force = beyond(&margin.fails_at);
            // If the point of failure is nearer than one standard deviation, a division by its squared distance would only amplify rounding.
            let bend = force * (2.0 / dot(&margin.fails_at, &margin.fails_at).max(1.0));
            // C is the matrix of mixed second derivatives of a force component with respect to two different data; its diagonal is zero. For a vector
            // v of random signs the mean square of `vᵀCv` is twice the sum of the squared entries of C.
            let mut squares = SMatrix::zeros();
            for probe in 0..PROBES {
                let mut signs = Draw::new([probe, 0, 0]);
                let mut z = numbered(here.changes.len(), &|_| 1.0);
                for z in &mut z {
                    *z = signs.sign();
                }
                // The last error is that of friction, which does not change the force.
                z.push(0.0);
                let twice = beyond(&z) * 2.0;
                squares += twice * twice.transpose() * (0.5 / PROBES as f64);
            }
            Interaction { force, bend, squares }
        };
        facets(edges, here).iter().enumerate().map(of).list()
    }
}
