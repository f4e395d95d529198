//! What the variables of one contact do along a step, and how soon one of them can reach zero.

use nalgebra::SVector;

use super::basis::Basis;
use super::form::{ContactForm, Point};
use super::pricing::ACROSS;

/// The pair that is out of the basis (both its variables are zero), and which of the two enters.
#[derive(Debug, Clone, Copy)]
pub(super) struct Entering {
    pub(super) contact: u32,
    pub(super) pair: usize,
    pub(super) jump: bool,
}

/// A basic variable that a step takes towards zero.
#[derive(Debug, Clone, Copy)]
pub(super) struct Candidate {
    pub(super) contact: u32,
    pub(super) pair: usize,
    /// Whether it is the z of the pair.
    pub(super) jump: bool,
    pub(super) value: f64,
    pub(super) rate: f64,
    /// Size of the terms that the value is made of.
    pub(super) level: f64,
}

/// Where a step starts and where it goes, for a unit change of the entering variable.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step<const D: usize> {
    pub(super) here: Point<D>,
    pub(super) along: Point<D>,
    /// Size of the largest changes of variables.
    pub(super) largest: f64,
}

/// A rate below this part of the terms it is made of is rounding of zero;
const NOISE: f64 = 1e-11;
/// so is in any case one below this part of the largest changes.
pub(super) const GREY: f64 = 4.0 * f64::EPSILON;
/// Times are taken a little shorter: rounding of the values, as a part of their terms.
const MARGIN: f64 = 1e-13;

impl<const D: usize, const C: usize> ContactForm<D, C> {
    /// Visits the basic variables of a contact that decrease along a step. A rate much smaller than the largest
    /// changes counts only if it is not small beside the terms it is made of.
    pub(super) fn decreasing(
        &self,
        basis: &Basis<C>,
        contact: u32,
        step: &Step<D>,
        entering: &Entering,
        mut visit: impl FnMut(Candidate),
    ) {
        let local = &self.locals[contact as usize];
        let (active, reaction) = (&basis.active[contact as usize], basis.reaction(contact as usize));
        let stretch = local.stretch(&step.here.y);
        let mut change = -(local.seen * step.along.y);
        let own = entering.contact == contact;
        if own && entering.jump {
            change += self.column(local, entering.pair);
        }
        let (z0, dz0) = (step.here.z0, step.along.z0);
        let x = reaction.hold * stretch - reaction.cover * z0;
        let dx = reaction.hold * change - reaction.cover * dz0;
        let level = local.trial.amax() + stretch.amax() + z0.abs();
        let own_size = if own { 1.0 } else { 0.0 };
        let mut consider = |pair: usize, jump: bool, value: f64, rate: f64, size: f64| {
            if rate >= -GREY * step.largest || (own && pair == entering.pair) {
                return;
            }
            let terms = || size * (local.seen.norm() * step.along.y.norm() + dz0.abs() + own_size);
            if rate > -NOISE * step.largest && rate > -NOISE * terms() {
                return;
            }
            visit(Candidate { contact, pair, jump, value, rate, level: level * size });
        };
        for (a, pair) in active.iter().enumerate() {
            let z = &reaction.multipliers[a];
            let value = -(z.dot(&stretch) + reaction.cover_jumps[a] * z0);
            let rate = -(z.dot(&change) + reaction.cover_jumps[a] * dz0);
            consider(pair, true, value, rate, 1.0 + z.amax());
        }
        let mut pair = 0;
        if local.gap {
            if active.position(0).is_none() {
                let d = self.cover(local, 0, 1.0);
                consider(0, false, x[0] + d * z0, dx[0] + d * dz0, 1.0);
            }
            pair = 1;
        }
        for facet in self.facets(local) {
            if active.len() == 0 || active.position(pair).is_none() {
                let d = self.cover(local, pair, facet.unit);
                let (value, rate) = (facet.row.dot(&x) + d * z0, facet.row.dot(&dx) + d * dz0);
                consider(pair, false, value, rate, facet.unit);
            }
            pair += 1;
        }
    }

    /// The time in which no variable of this contact can reach zero, see `pricing`.
    pub(super) fn slack(&self, basis: &Basis<C>, contact: u32, at: &Point<D>, e: &Point<D>) -> f64 {
        let local = &self.locals[contact as usize];
        let (active, reaction) = (&basis.active[contact as usize], basis.reaction(contact as usize));
        let stretch = local.stretch(&at.y);
        let change = -(local.seen * e.y);
        let x = reaction.hold * stretch - reaction.cover * at.z0;
        let dx = reaction.hold * change - reaction.cover * e.z0;
        let level = local.trial.amax() + stretch.amax() + at.z0.abs();
        let margin = MARGIN * level;
        let mut least = f64::INFINITY;
        let mut consider = |value: f64, rate: f64, gradient: f64, size: f64| {
            let value = (value - margin * size).max(0.0);
            let fastest = (-rate).max(ACROSS * gradient);
            if fastest > 0.0 {
                least = least.min(value / fastest);
            }
        };
        let width = local.seen.norm();
        for a in 0..active.len() {
            let (z, zeta) = (&reaction.multipliers[a], reaction.cover_jumps[a]);
            let value = -(z.dot(&stretch) + zeta * at.z0);
            let rate = -(z.dot(&change) + zeta * e.z0);
            consider(value, rate, z.norm() * width + zeta.abs(), 1.0 + z.amax());
        }
        let felt = |row: &SVector<f64, C>, d: f64| {
            reaction.hold.tr_mul(row).norm() * width + (d - row.dot(&reaction.cover)).abs()
        };
        let mut pair = 0;
        if local.gap {
            if active.position(0).is_none() {
                let d = self.cover(local, 0, 1.0);
                let steepest = width + (d - reaction.cover[0]).abs();
                consider(x[0] + d * at.z0, dx[0] + d * e.z0, steepest, 1.0);
            }
            pair = 1;
        }
        for facet in self.facets(local) {
            if active.len() == 0 || active.position(pair).is_none() {
                let d = self.cover(local, pair, facet.unit);
                let (value, rate) = (facet.row.dot(&x) + d * at.z0, facet.row.dot(&dx) + d * e.z0);
                consider(value, rate, felt(&facet.row, d), facet.unit);
            }
            pair += 1;
        }
        least
    }
}
