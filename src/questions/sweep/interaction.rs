//! The interaction of errors of several data in their effect on a contact force. It is the change of the force if all data are in error at once, less
//! the sum of the changes due to each datum alone. It is computed for each facet (plane side) of a friction cone, at the point of failure of the
//! facet. This point is the smallest set of errors with which the force reaches the facet, so that its margin (its distance from the facet) vanishes.
//! A drive is the spring of a joint or tendon of a hand, with its force limit.

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

/// Number of random sets of errors, each with plus or minus one standard deviation per datum, from which the magnitude of interactions is estimated.
///
/// If it were larger, more equilibria would be computed for each load whose failure probability is sought. If it were smaller, the estimate would be
/// less certain.
const PROBES: usize = 8;

/// The grasp whose data are uncertain, in fixed contact states (each contact sticks or is open). It gives exact contact forces with several data in
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

/// A random set of errors, in standard deviations, and the exact forces with these errors, N. The forces are `None` if a datum leaves its allowed
/// range, or the grasp cannot hold the tension of a link.
pub(super) struct Probe {
    z: Vec<f64>,
    forces: Option<Vec<SVector<f64, 3>>>,
}

impl PerturbedGrasp {
    /// The exact forces on contacts and drives under `load`, N. The entries of `z` are errors in standard deviations: of the uncertain data, then of
    /// the load factor. A further entry, the error of friction, is not used. `None` if a datum leaves its allowed range, or the grasp cannot hold the
    /// tension of a link.
    fn forces(&self, load: &Wrench<3>, z: &[f64]) -> Option<Vec<SVector<f64, 3>>> {
        let grasp = with_errors(&self.grasp, &self.data, z).ok()?;
        let response = StickingResponse::in_states(&grasp, self.cone, &self.states);
        let load = *load * factor(self.load_spread * z[self.data.len()]);
        Some(forces_or_gaps(&response, &grasp.offsets(), &grasp.load_unchecked(&load)))
    }

    /// `PROBES` random sets of errors of `count` data and of friction, each with the exact forces under `load`. The same sets serve all contacts.
    pub(super) fn probes(&self, load: &Wrench<3>, count: usize) -> Vec<Probe> {
        let probe = |probe: usize| {
            let mut signs = Draw::new([probe as u64, 0, 0]);
            let mut z = numbered(count, &|_| 1.0);
            for z in &mut z {
                *z = signs.sign();
            }
            // The last entry of z is the error of friction. It does not change the forces, since the contact states are fixed.
            z.push(0.0);
            Probe { forces: self.forces(load, &z), z }
        };
        numbered(PROBES, &probe)
    }

    /// For each facet of a contact's friction cone, the interaction of all data errors at the facet's point of failure under a load. It is the exact
    /// change of the contact force less the sum of the changes due to single errors. Zero for facets whose failure probability is below `rare`; an
    /// empty list if no data are uncertain. `probes` are the random sets of errors, with exact forces, under the same load.
    pub(super) fn of_facets<'p>(
        &self,
        (i, edges): (usize, &Edges),
        load: &Wrench<3>,
        (here, probes): (&UncertainForce<'_>, &dyn Fn() -> &'p [Probe]),
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
            let beyond = |z: &[f64], forces: Option<&[SVector<f64, 3>]>| {
                forces.map_or(SVector::zeros(), |forces| forces[i] - here.at(z))
            };
            let force = beyond(&margin.fails_at, self.forces(load, &margin.fails_at).as_deref());
            // The second derivative along the line to the point of failure is twice the interaction there, divided by the squared length of the line.
            // If this length is below one standard deviation, the division would only amplify rounding.
            let bend = force * (2.0 / dot(&margin.fails_at, &margin.fails_at).max(1.0));
            // C is the matrix of mixed second derivatives of a force component with respect to two different data; its diagonal is zero. The entries
            // of a probe `z` are random signs. For such a vector v the mean square of `vᵀCv` is twice the sum of the squared entries of C.
            let mut squares = SMatrix::zeros();
            for probe in probes() {
                let twice = beyond(&probe.z, probe.forces.as_deref()) * 2.0;
                squares += twice * twice.transpose() * (0.5 / PROBES as f64);
            }
            Interaction { force, bend, squares }
        };
        facets(edges, here).iter().enumerate().map(of).list()
    }
}
