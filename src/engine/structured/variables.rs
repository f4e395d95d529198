//! The ratio test of one contact: its variables along a step, and the step length at which one of them can reach zero.

use nalgebra::SVector;

use super::basis::StateBasis;
use super::contact_form::{ContactForm, PairedContact};
use super::tolerances::TIE;
use crate::numerics::tolerances::FEW_ROUNDINGS;
use crate::object::{Facet, PRICING_MARGIN, Point, slack};

/// The complementary pair (w, z) with both variables outside the basis, and the variable that enters: z if `jump`, otherwise w.
#[derive(Debug, Clone, Copy)]
pub(super) struct Entering {
    pub(super) contact: u32,
    pub(super) pair: usize,
    pub(super) jump: bool,
}

/// A basic variable that decreases along a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Candidate {
    pub(super) contact: u32,
    pub(super) pair: usize,
    /// Whether the variable is z of its pair (a gap or slip), not w.
    pub(super) jump: bool,
    pub(super) vanishing: Vanishing,
}

/// The value of a variable that decreases along a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Vanishing {
    pub(super) value: f64,
    pub(super) rate: f64,
    /// Sum of the absolute values of the terms of `value`, which scales its rounding.
    pub(super) level: f64,
}

impl Vanishing {
    /// The step length at which the value is zero.
    pub(super) fn ratio(&self) -> f64 {
        self.value.max(0.0) / -self.rate
    }

    /// The step length at which the value is negative by its rounding error. The least of these lengths over all variables limits the step: variables
    /// that reach zero before it are tied.
    pub(super) fn longest(&self) -> f64 {
        let value = self.value.max(0.0);
        // The last term covers the rounding of the terms that add up to the value.
        (value + TIE * value + 64.0 * f64::EPSILON * self.level) / -self.rate
    }
}

/// The start of a step, and its direction for a unit change of the entering variable.
#[derive(Debug, Clone)]
pub(super) struct PivotStep {
    pub(super) here: Point,
    pub(super) along: Point,
    /// Upper estimate of the changes of all variables, with which small rates are compared.
    pub(super) largest: f64,
}

impl ContactForm {
    /// Calls `visit` with the basic variables of a contact that decrease along a step. A rate much smaller than the largest changes counts only if it
    /// is not small beside the terms that add up to it.
    pub(super) fn decreasing(
        &self,
        basis: &StateBasis,
        contact: u32,
        step: &PivotStep,
        entering: &Entering,
        mut visit: impl FnMut(Candidate),
    ) {
        let local = &self.locals[contact as usize];
        let (active, reaction) = (&basis.active[contact as usize], basis.reaction(contact as usize));
        let (z0, dz0, own) = (step.here.s, step.along.s, entering.contact == contact);
        let stretch = local.stretch(&step.here.y);
        let mut change = -(&local.contact.seen * &step.along.y);
        if own && entering.jump {
            change += self.column(local, entering.pair);
        }
        let level = local.level(&stretch, z0);
        let own_size = if own { 1.0 } else { 0.0 };
        // Below this fraction of the largest change, a rate is rounding of zero, whatever its terms.
        let zero = -FEW_ROUNDINGS * step.largest;
        let mut consider = |pair: usize, jump: bool, value: f64, rate: f64, size: f64| {
            if rate >= zero || (own && pair == entering.pair) {
                return;
            }
            let terms = || size * (local.contact.seen.norm() * step.along.y.norm() + dz0.abs() + own_size);
            // A rate below this fraction of its terms is rounding of zero. A step along which it reached zero would be far too long.
            let noise = 1e-11;
            if rate > -noise * step.largest && rate > -noise * terms() {
                return;
            }
            let vanishing = Vanishing { value, rate, level: level * size };
            visit(Candidate { contact, pair, jump, vanishing });
        };
        for (a, pair) in active.iter().enumerate() {
            let (z, zeta) = (&reaction.multipliers[a], reaction.cover.of_pairs[a]);
            let (value, rate) = (z.dot(&stretch) + zeta * z0, z.dot(&change) + zeta * dz0);
            consider(pair, true, -value, -rate, 1.0 + z.amax());
        }
        let x = reaction.hold * stretch - reaction.cover.of_x * z0;
        let dx = reaction.hold * change - reaction.cover.of_x * dz0;
        for (pair, Facet { row, unit }) in self.pairs_of(local).iter().enumerate() {
            let d = self.cover(local, pair, *unit);
            let rate = row.dot(&dx) + d * dz0;
            // The rate is tested first, since it excludes most pairs.
            if rate < zero && !active.has(pair) {
                consider(pair, false, row.dot(&x) + d * z0, rate, *unit);
            }
        }
    }

    /// The waiting time of a contact for `object/lazy_pricing`: before the path's clock has advanced by this time, no variable of the contact can
    /// reach zero. `e` is the reference direction of the path.
    pub(super) fn slack(&self, basis: &StateBasis, contact: u32, at: &Point, e: &Point) -> f64 {
        let local = &self.locals[contact as usize];
        let (active, reaction) = (&basis.active[contact as usize], basis.reaction(contact as usize));
        let (stretch, change) = (local.stretch(&at.y), -(&local.contact.seen * &e.y));
        let (margin, width) = (PRICING_MARGIN * local.level(&stretch, at.s), local.contact.seen.norm());
        let mut least = f64::INFINITY;
        // Each variable of the contact is `felt·u + d z₀`, with the contact's stretch u and the covering variable z₀.
        let mut consider = |felt: &SVector<f64, 3>, d: f64, size: f64| {
            let value = felt.dot(&stretch) + d * at.s - margin * size;
            let rate = felt.dot(&change) + d * e.s;
            least = least.min(slack(value, rate, felt.norm() * width + d.abs()));
        };
        for a in 0..active.len() {
            let z = &reaction.multipliers[a];
            consider(&-z, -reaction.cover.of_pairs[a], 1.0 + z.amax());
        }
        for (pair, Facet { row, unit }) in self.pairs_of(local).iter().enumerate() {
            if !active.has(pair) {
                let (felt, d) = reaction.feels(row, self.cover(local, pair, *unit));
                consider(&felt, d, *unit);
            }
        }
        least
    }
}

impl PairedContact {
    /// Size of the terms that add up to the variables of a contact, which scales their rounding.
    fn level(&self, stretch: &SVector<f64, 3>, z0: f64) -> f64 {
        self.trial.amax() + stretch.amax() + z0.abs()
    }
}
