//! The kinematic form contact by contact: the matrix M is never formed.
//!
//! In the elastic trial everything sticks, and contact i has the force x⁰_i in energy coordinates. Gaps and slips z_i with columns B_i change the
//! force to x_i, and each slack w is complementary to a gap or slip:
//!
//! ```text
//! x_i = u_i + B_i z_i,   u_i = x⁰_i - Q_i y,   Σ Q_iᵀ(x_i - x⁰_i) = 0,   0 <= z ⟂ w = L x + d z₀ >= 0
//! ```
//!
//! Here u_i is the stretch of contact i, and Q_i maps the motion y of the object to it. L are the rows of the slacks, and d is the covering vector.
//! Only y couples the contacts, with as many entries as the object has degrees of freedom. Rows and columns are those of `forms/kinematic`, scaled:
//! columns and the rows of gaps have length one. A facet has the row (κ, c), with a normal part κ and a tangential part c of length one, and the
//! column (0, c). The covering variable z₀ is the parameter of the path, stored as `Point::s`.

use nalgebra::SVector;

use crate::numerics::{Orthogonal, Size, Vector, generic};
use crate::object::{EnergyContact, EnergyCoordinates, Facet, Problem, normal};
use crate::prelude::*;

/// A contact with its complementary pairs (w, z).
#[derive(Debug, Clone)]
pub(super) struct PairedContact {
    pub(super) contact: EnergyContact,
    /// x⁰_i, the force of the contact in the elastic trial, in energy coordinates.
    pub(super) trial: SVector<f64, 3>,
    /// The index of the contact's first complementary pair in the whole problem. Pair 0 of a contact that may open is its gap.
    pub(super) first: usize,
}

impl PairedContact {
    /// The entry for a pair of the perturbation that breaks ties; `unit` converts it to the scale of the pair's row.
    pub(super) fn perturbation(&self, pair: usize, unit: f64) -> f64 {
        unit * generic(self.first + pair)
    }

    /// The stretch `u = x⁰ - Q y` of the contact in energy coordinates: its elastic trial state minus its map Q times the motion y of the object.
    pub(super) fn stretch(&self, y: &Vector) -> SVector<f64, 3> {
        self.trial - &self.contact.seen * y
    }
}

/// The kinematic form of the complementarity problem, stored contact by contact.
#[derive(Debug, Clone, Default)]
pub(crate) struct ContactForm {
    pub(super) locals: Vec<PairedContact>,
    pub(super) coordinates: EnergyCoordinates,
    pub(super) size: Size,
    /// The number of complementary pairs of all contacts.
    pub(super) pairs: usize,
    /// The largest norm of the maps Q_i, each from the motion of the object to the stretch of a contact.
    pub(super) widest: f64,
    /// The covering vector d; each entry has the scale of its pair's row. If the list is empty, all entries are one for rows of length one.
    covering: Vec<f64>,
}

impl ContactForm {
    /// Sets up the form from the elastic trial state, in which every contact sticks. `factor` is the orthogonal factor of the trial. `x` lists the
    /// trial forces x⁰ in energy coordinates, spring by spring.
    pub(crate) fn assign(&mut self, problem: &Problem, factor: &Orthogonal, x: &[f64]) {
        let Self { locals, coordinates, size, pairs, widest, covering } = self;
        *size = problem.size();
        locals.clear();
        covering.clear();
        covering.reserve(problem.len() * (problem.polygon.normals.len() + 1));
        (*pairs, *widest) = (0, 0.0);
        let mut x = x.iter();
        coordinates.lay_out(problem, factor, |law, contact| {
            let springs = if law.is_absent() { 0 } else { law.springs.axes() };
            let mut trial = SVector::<f64, 3>::zeros();
            for (trial, x) in trial.iter_mut().zip(x.by_ref().take(springs)) {
                *trial = *x;
            }
            let first = *pairs;
            *pairs += contact.pairs();
            *widest = widest.max(contact.seen.norm());
            locals.push(PairedContact { contact, trial, first });
        });
    }

    pub(super) fn len(&self) -> usize {
        self.locals.len()
    }

    /// The complementary pairs of a contact. Each has a row, and the factor that converts a number for the row scaled to length one to the scale of
    /// the row.
    #[inline]
    pub(super) fn pairs_of(&self, local: &PairedContact) -> &[Facet] {
        self.coordinates.pairs(&local.contact)
    }

    /// The column of a pair: the change of the contact force x in energy coordinates by a unit gap or slip.
    pub(super) fn column(&self, local: &PairedContact, pair: usize) -> SVector<f64, 3> {
        let is_gap = local.contact.gap && pair == 0;
        if is_gap { normal() } else { self.pairs_of(local)[pair].column() }
    }

    /// The entry of the covering vector for a pair; `unit` is the default entry one, in the scale of the pair's row.
    #[inline]
    pub(super) fn cover(&self, local: &PairedContact, pair: usize, unit: f64) -> f64 {
        self.covering.get(local.first + pair).copied().unwrap_or(unit)
    }

    /// Sets the covering vector to reproducible generic numbers between 1/8 and 8, different for every attempt. Attempt 0 has all ones.
    pub(super) fn scatter(&mut self, attempt: usize) {
        let mut covering = core::mem::take(&mut self.covering);
        covering.clear();
        if attempt > 0 {
            for local in &self.locals {
                covering.extend(self.pairs_of(local).iter().enumerate().map(|(pair, facet)| {
                    let number = attempt * 1_000_003 + local.first + pair;
                    facet.unit * (6.0 * (generic(number) - 1.0)).exp2()
                }));
            }
        }
        self.covering = covering;
    }
}
