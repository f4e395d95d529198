//! Balance of the object, summed over contacts of which an event changes one or two.
//!
//! With every contact in a known state, forces balance the load where `Σ Qᵀ(x - x⁰) = 0`: d equations for the motion y on top of
//! the elastic trial motion,
//!
//! ```text
//! T y = b + τ b',   T = Σ QᵀP Q,   b = Σ Qᵀ((P - 1) x⁰ - P m),   b' = Σ Qᵀ(P - 1) x⁰'
//! ```
//!
//! T is the identity where everything sticks, whatever the stiffnesses.

use nalgebra::{SMatrix, SVector};

use super::local::Local;
use crate::contact::Mode;
use crate::numerics::{Factors, SUMMED_IN_TURN, both};

/// T, b and b'.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sums<const D: usize> {
    pub(super) stiffness: SMatrix<f64, D, D>,
    pub(super) base: SVector<f64, D>,
    pub(super) rate: SVector<f64, D>,
}

impl<const D: usize> Sums<D> {
    pub(super) fn zero() -> Self {
        Self { stiffness: SMatrix::zeros(), base: SVector::zeros(), rate: SVector::zeros() }
    }

    /// Afresh. Entries of y from `rank` on move nothing.
    pub(super) fn of<const C: usize>(
        locals: &[Local<D, C>],
        all: &[SVector<f64, C>],
        weight: f64,
        rank: usize,
    ) -> Self {
        let mut sums = Self::in_halves(locals, all, weight);
        for k in rank..D {
            sums.stiffness[(k, k)] = 1.0;
        }
        sums
    }

    /// Rounding grows with the logarithm of the number of contacts only, and is the same for any number of threads.
    fn in_halves<const C: usize>(locals: &[Local<D, C>], all: &[SVector<f64, C>], weight: f64) -> Self {
        if locals.len() > SUMMED_IN_TURN {
            let (near, far) = locals.split_at(locals.len() / 2);
            let (a, b) = both(
                locals.len(),
                || Self::in_halves(near, all, weight),
                || Self::in_halves(far, all, weight),
            );
            return Self {
                stiffness: a.stiffness + b.stiffness,
                base: a.base + b.base,
                rate: a.rate + b.rate,
            };
        }
        let mut sums = Self::zero();
        for local in locals {
            sums.add(local, all, weight);
        }
        sums
    }

    /// Adds the terms of a contact.
    pub(super) fn add<const C: usize>(&mut self, local: &Local<D, C>, all: &[SVector<f64, C>], weight: f64) {
        let code = local.code;
        match code {
            Mode::Open => {
                self.base -= local.seen.tr_mul(&(local.trial * weight));
                self.rate -= local.seen.tr_mul(&(local.rate * weight));
            }
            Mode::Rolling => {
                self.stiffness += local.seen.tr_mul(&(local.seen * weight));
                self.base -= local.seen.tr_mul(&(local.memory * weight));
            }
            Mode::Facet(_) | Mode::Corner(_) => {
                let hold = local.hold(all);
                self.stiffness += local.seen.tr_mul(&(hold * local.seen * weight));
                let pushed = hold * (local.trial - local.memory) - local.trial;
                self.base += local.seen.tr_mul(&(pushed * weight));
                self.rate += local.seen.tr_mul(&((hold * local.rate - local.rate) * weight));
            }
        }
    }

    pub(super) fn side(&self, tau: f64) -> SVector<f64, D> {
        self.base + self.rate * tau
    }

    pub(super) fn factors(&self) -> Factors<D> {
        Factors::new(&self.stiffness)
    }
}
