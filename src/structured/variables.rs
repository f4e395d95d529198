//! What the variables of one contact do along a step, and how soon one of them can reach zero.

use nalgebra::SVector;

use super::basis::{Basis, Reaction};
use super::contact_form::{ContactForm, Local};
use crate::object::{MARGIN, Point, normal, slack};

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
    pub(super) vanishing: Vanishing,
}

/// A value that a step takes towards zero.
#[derive(Debug, Clone, Copy)]
pub(super) struct Vanishing {
    pub(super) value: f64,
    pub(super) rate: f64,
    /// Size of the terms that the value is made of.
    pub(super) level: f64,
}

impl Vanishing {
    /// The step after which the value is zero.
    pub(super) fn ratio(&self) -> f64 {
        self.value.max(0.0) / -self.rate
    }

    /// The step after which the value is below zero by as much as its rounding: variables that
    /// reach zero before the least of these cannot be told apart.
    pub(super) fn longest(&self) -> f64 {
        let value = self.value.max(0.0);
        (value + TIE * value + ROUNDING * self.level) / -self.rate
    }
}

/// A value may be wrong by this part of itself: variables tie that reach zero within such errors of
/// each other. Smaller, and a symmetric scene leaves a tie to its rounding; larger, and a variable
/// goes below zero.
pub(super) const TIE: f64 = 1e-12;
/// A value may be wrong by this part of the terms it is made of, for the same reason.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Where a step starts and where it goes, for a unit change of the entering variable.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step<const D: usize> {
    pub(super) here: Point<D>,
    pub(super) along: Point<D>,
    /// Size of the largest changes of variables.
    pub(super) largest: f64,
}

/// A rate below this part of its terms is rounding of zero: a path that took it for a rate would
/// end far away.
const NOISE: f64 = 1e-11;
/// A rate below this part of the largest changes is rounding of zero, whatever its terms.
pub(super) const GREY: f64 = 4.0 * f64::EPSILON;

/// What a basic variable of a contact is a linear function of.
#[derive(Debug, Clone, Copy)]
enum Felt<'r, const C: usize> {
    /// A jump, `-(Z u + ζ z₀)`.
    Jump(&'r SVector<f64, C>, f64),
    /// A w, `row·x + d z₀`.
    Row(SVector<f64, C>, f64),
}

/// Where a contact is, or how it changes: u, x and z₀.
#[derive(Debug, Clone, Copy)]
struct Seen<const C: usize> {
    u: SVector<f64, C>,
    x: SVector<f64, C>,
    z0: f64,
}

impl<const C: usize> Seen<C> {
    fn new(reaction: &Reaction<C>, u: SVector<f64, C>, z0: f64) -> Self {
        Self { u, x: reaction.hold * u - reaction.cover.of_x * z0, z0 }
    }
}

impl<const C: usize> Felt<'_, C> {
    #[inline]
    fn of(&self, seen: &Seen<C>) -> f64 {
        match self {
            Self::Jump(z, zeta) => -(z.dot(&seen.u) + zeta * seen.z0),
            Self::Row(row, d) => row.dot(&seen.x) + d * seen.z0,
        }
    }

    /// Size of the gradient in y and z₀, for a contact that sees so much of y.
    fn steepest(&self, reaction: &Reaction<C>, width: f64) -> f64 {
        match self {
            Self::Jump(z, zeta) => z.norm() * width + zeta.abs(),
            Self::Row(row, d) => {
                reaction.hold.tr_mul(row).norm() * width + (d - row.dot(&reaction.cover.of_x)).abs()
            }
        }
    }
}

impl<const D: usize, const C: usize> ContactForm<D, C> {
    /// Visits the basic variables of a contact. Each has the number of its pair, whether it is the
    /// z of the pair, what it feels, and the size of its terms beside those of u.
    #[inline]
    fn for_each_basic(
        &self,
        basis: &Basis<C>,
        contact: u32,
        mut visit: impl FnMut(usize, bool, Felt<'_, C>, f64),
    ) {
        let (local, active) = (&self.locals[contact as usize], &basis.active[contact as usize]);
        let reaction = basis.reaction(contact as usize);
        for (a, pair) in active.iter().enumerate() {
            let z = &reaction.multipliers[a];
            visit(pair, true, Felt::Jump(z, reaction.cover.of_pairs[a]), 1.0 + z.amax());
        }
        let is_slack = |pair: usize| active.len() == 0 || active.position(pair).is_none();
        let first = usize::from(local.contact.gap);
        if local.contact.gap && is_slack(0) {
            visit(0, false, Felt::Row(normal(), self.cover(local, 0)), 1.0);
        }
        for (pair, facet) in (first..).zip(self.facets(local)) {
            if is_slack(pair) {
                visit(pair, false, Felt::Row(facet.row, self.cover(local, pair)), facet.unit);
            }
        }
    }

    /// Visits the basic variables of a contact that decrease along a step. A rate much smaller than
    /// the largest changes counts only if it is not small beside the terms it is made of.
    pub(super) fn decreasing(
        &self,
        basis: &Basis<C>,
        contact: u32,
        step: &Step<D>,
        entering: &Entering,
        mut visit: impl FnMut(Candidate),
    ) {
        let local = &self.locals[contact as usize];
        let reaction = basis.reaction(contact as usize);
        let mut change = -(local.contact.seen * step.along.y);
        let own = entering.contact == contact;
        if own && entering.jump {
            change += self.column(local, entering.pair);
        }
        let here = Seen::new(reaction, local.stretch(&step.here.y), step.here.s);
        let along = Seen::new(reaction, change, step.along.s);
        let level = local.level(&here);
        let own_size = if own { 1.0 } else { 0.0 };
        self.for_each_basic(basis, contact, |pair, jump, felt, size| {
            let rate = felt.of(&along);
            if rate >= -GREY * step.largest || (own && pair == entering.pair) {
                return;
            }
            let width = || local.contact.seen.norm() * step.along.y.norm();
            let terms = || size * (width() + along.z0.abs() + own_size);
            if rate > -NOISE * step.largest && rate > -NOISE * terms() {
                return;
            }
            let vanishing = Vanishing { value: felt.of(&here), rate, level: level * size };
            visit(Candidate { contact, pair, jump, vanishing });
        });
    }

    /// The time in which no variable of this contact can reach zero on the clock of the direction
    /// e.
    pub(super) fn slack(&self, basis: &Basis<C>, contact: u32, at: &Point<D>, e: &Point<D>) -> f64 {
        let local = &self.locals[contact as usize];
        let reaction = basis.reaction(contact as usize);
        let here = Seen::new(reaction, local.stretch(&at.y), at.s);
        let along = Seen::new(reaction, -(local.contact.seen * e.y), e.s);
        let (margin, width) = (MARGIN * local.level(&here), local.contact.seen.norm());
        let mut least = f64::INFINITY;
        self.for_each_basic(basis, contact, |_, _, felt, size| {
            let value = felt.of(&here) - margin * size;
            least = least.min(slack(value, felt.of(&along), felt.steepest(reaction, width)));
        });
        least
    }
}

impl<const D: usize, const C: usize> Local<D, C> {
    /// Size of the terms that the variables of the contact are made of.
    fn level(&self, here: &Seen<C>) -> f64 {
        self.trial.amax() + here.u.amax() + here.z0.abs()
    }
}
