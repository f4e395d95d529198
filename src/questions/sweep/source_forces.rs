//! Contact forces as a sum over sources (commands with constant loads, each component of the load), and their changes if data are in error. The
//! forces due to one source, together with these changes, are its [`SourceForces`]. The contact states are those under the base load: sticking or
//! open. A drive is the spring of a joint or tendon of a hand, with its force limit.

use core::slice::from_ref;

use nalgebra::{Matrix, SVector};

use super::datum::{UncertainDatum, with_errors};
use super::margin::{Effect, LOOKED_AT, effect};
use crate::equilibrium::{Cone, StickingResponse};
use crate::error::Error;
use crate::grasp::{Space, Wrench};
use crate::numerics::{Each, IntoList, Size, Vector, add_times, largest, numbered};
use crate::object::ForcesAndTwist;
use crate::prelude::*;

/// The forces of all contacts and drives that one source causes: the commands, or a component of the load. It has the forces for the data as given,
/// and their changes due to an error of each uncertain datum. For an open contact the gap, m, is stored in place of the force.
#[derive(Debug, Clone)]
pub(super) struct SourceForces {
    /// The forces, N, for the data as given; for an open contact its gap, m.
    pub(super) known: Vec<SVector<f64, 3>>,
    /// For each uncertain datum and each contact or drive, the change of the force (or gap) as a polynomial in the error of this datum ([`Effect`]).
    pub(super) off: Vec<Vec<Effect>>,
}

impl SourceForces {
    /// Adds `times` times the forces, and their changes, of another source.
    pub(super) fn add(&mut self, times: f64, other: &Self) {
        add_times(&mut self.known, &other.known, times);
        for (sum, more) in self.off.iter_mut().flatten().zip(other.off.iter().flatten()) {
            add_times(sum, more, times);
        }
    }

    /// The [`SourceForces`] of a load: the sum of the [`SourceForces`] of its components, each multiplied by the component.
    pub(super) fn of(by_component: &[Self], space: Space, load: &Wrench<3>) -> Self {
        let none = by_component[0].off.iter().map(|sites| vec![Effect::default(); sites.len()]);
        let mut sum = Self { known: vec![SVector::zeros(); by_component[0].known.len()], off: none.list() };
        for (by, x) in by_component.iter().zip(load.coordinates(space).iter()).filter(|(_, x)| **x != 0.0) {
            sum.add(*x, by);
        }
        sum
    }

    /// The largest force of a contact or drive, N, for the data as given.
    pub(super) fn largest(&self) -> f64 {
        largest(&self.known, &Matrix::norm)
    }
}

/// The [`SourceForces`] of each source, i.e. the forces due to this source and their changes due to errors of the data, while no contact slides. The
/// first source is commands together with constant loads; then comes 1 N or 1 N m of each component of the load.
pub(super) fn source_forces(
    response: &StickingResponse<'_>,
    cone: Cone,
    data: &[UncertainDatum],
    sigmas: f64,
) -> Result<Vec<SourceForces>, Error> {
    let mut source_forces = Vec::new();
    for known in by_source(response) {
        source_forces.push(SourceForces { known, off: Vec::with_capacity(data.len()) });
    }
    for datum in data {
        let mut seen = Vec::with_capacity(LOOKED_AT.len());
        for part in LOOKED_AT {
            let engine = with_errors(response.grasp, from_ref(datum), &[part * sigmas])?;
            seen.push(by_source(&StickingResponse::in_states(&engine, cone, &response.states)));
        }
        for (source, SourceForces { known, off }) in source_forces.iter_mut().enumerate() {
            let change = |k: usize, i: usize| seen[k][source][i] - known[i];
            off.push(numbered(known.len(), &|i| effect([0, 1, 2, 3].each(|k| change(k, i)))));
        }
    }
    Ok(source_forces)
}

/// The forces of all contacts and drives (gaps of open contacts), source by source. The first source is commands together with constant loads; then
/// comes 1 N or 1 N m of each component of the load.
fn by_source(response: &StickingResponse<'_>) -> Vec<Vec<SVector<f64, 3>>> {
    let grasp = response.grasp;
    let mut sources = vec![forces_or_gaps(response, &grasp.offsets(), &grasp.load_unchecked(&Wrench::ZERO))];
    for component in 0..grasp.space().of_the_object() {
        let load = grasp.inside_unchecked(&unit(grasp.space(), component));
        sources.push(forces_or_gaps(response, &response.at_rest(), &load));
    }
    sources
}

/// The forces of all contacts and drives under the spring offsets `offsets` and the load `load` (a vector in the engine's coordinates of the object).
/// For an open contact its gap, m, is returned in place of the force.
pub(super) fn forces_or_gaps(
    response: &StickingResponse<'_>,
    offsets: &[SVector<f64, 3>],
    load: &Vector,
) -> Vec<SVector<f64, 3>> {
    let ForcesAndTwist { mut forces, twist } = response.linear_problem.solve_roughly(offsets, load);
    let sites = response.grasp.sites();
    for (i, site) in sites.iter().enumerate().filter(|(i, _)| response.states[*i].is_open()) {
        forces[i] = SVector::zeros();
        forces[i][0] = -site.stretch(&offsets[i], &twist)[0];
    }
    forces
}

/// The load of 1 N or 1 N m along component number `component`.
pub(super) fn unit(space: Space, component: usize) -> Wrench<3> {
    Wrench::among(space, &Vector::unit(Size::of(space.of_the_object()), component))
}
