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
use crate::formulation::{FullPivot, Regular};
use crate::halves::{TOGETHER, both};
use crate::structured::Code;

/// What no motion reaches by more than this part of the sizes of the terms is out of balance.
const OUT_OF_REACH: f64 = 1e-12;

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
        if locals.len() > TOGETHER {
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
        match local.code {
            Code::Open => {
                self.base -= local.seen.tr_mul(&(local.trial * weight));
                self.rate -= local.seen.tr_mul(&(local.rate * weight));
            }
            Code::Rolling => {
                self.stiffness += local.seen.tr_mul(&(local.seen * weight));
                self.base -= local.seen.tr_mul(&(local.memory * weight));
            }
            Code::Facet(_) | Code::Corner(_) => {
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
        match Regular::new(&self.stiffness) {
            Some(regular) => Factors::Regular(regular),
            None => Factors::Singular(Box::new(FullPivot::new(self.stiffness, D, D))),
        }
    }
}

/// Factors of T.
#[derive(Debug, Clone)]
pub(super) enum Factors<const D: usize> {
    Regular(Regular<D>),
    /// Or nearly so: what there is of motions that nothing resists is told from what is only soft.
    Singular(Box<FullPivot<D>>),
}

impl<const D: usize> Factors<D> {
    /// A solution of `T y = b`, as far as there is one.
    pub(super) fn solve(&self, b: &SVector<f64, D>) -> SVector<f64, D> {
        match self {
            Self::Regular(regular) => regular.solve(b),
            Self::Singular(full) => full.solve(b).0,
        }
    }

    /// A solution of `T y = b`, if there is one.
    pub(super) fn solve_exactly(&self, b: &SVector<f64, D>, size: f64) -> Option<SVector<f64, D>> {
        match self {
            Self::Regular(regular) => Some(regular.solve(b)),
            Self::Singular(full) => {
                let (y, unreached) = full.solve(b);
                (unreached <= OUT_OF_REACH * size * full.growth()).then_some(y)
            }
        }
    }

    /// Motions that nothing resists.
    pub(super) fn kernel(&self) -> Vec<SVector<f64, D>> {
        match self {
            Self::Regular(_) => Vec::new(),
            Self::Singular(full) => full.kernel(),
        }
    }

    /// How much relative rounding errors grow, at least 1.
    pub(super) fn growth(&self) -> f64 {
        match self {
            Self::Regular(regular) => {
                let column =
                    |k: usize| regular.solve(&SVector::from_fn(|i, _| if i == k { 1.0 } else { 0.0 }));
                (0..D).map(|k| column(k).amax()).fold(1.0, f64::max)
            }
            Self::Singular(full) => full.growth(),
        }
    }
}
