//! Balance of the object in energy coordinates: sums over contacts of which an event changes a few
//! terms.
//!
//! With every contact in a known state, forces balance the load where `Σ Qᵀ(x - x⁰) = 0`. With `x =
//! P u` these are d equations for the motion y on top of the elastic trial motion. They have a side
//! for everything else that x depends on:
//!
//! ```text
//! T y = Σ_r b_r λ_r,     T = Σ QᵀP Q,     b_r = Σ Qᵀp_r
//! ```
//!
//! T is the identity where everything sticks, whatever the stiffnesses.

use std::ops::Range;

use nalgebra::{SMatrix, SVector};

use crate::numerics::in_halves;

/// Sums are made afresh after this many changes and a quarter of the number of contacts. A change
/// leaves a rounding, fresh sums cost a look at each contact.
const FRESH: usize = 64;

/// How often a motion from such sums is corrected by what its forces, summed afresh, leave out of
/// balance: the second time removes the rounding of the first.
pub(crate) const CORRECTIONS: usize = 2;

/// Whether sums over so many contacts have changed too often to be trusted.
pub(crate) fn are_stale(changes: usize, contacts: usize) -> bool {
    changes > FRESH + contacts / 4
}

/// T and R sides.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sums<const D: usize, const R: usize> {
    pub(crate) stiffness: SMatrix<f64, D, D>,
    pub(crate) sides: [SVector<f64, D>; R],
}

impl<const D: usize, const R: usize> Default for Sums<D, R> {
    /// Those of contacts that all stick, without memory: Q has orthonormal columns.
    fn default() -> Self {
        Self { stiffness: SMatrix::identity(), sides: [SVector::zeros(); R] }
    }
}

impl<const D: usize, const R: usize> Sums<D, R> {
    /// The sums over so many contacts, whose terms `add` adds. Entries of y from `rank` on move
    /// nothing.
    pub(crate) fn over(contacts: usize, rank: usize, add: &(impl Fn(&mut Self, usize) + Sync)) -> Self {
        let zero = Self { stiffness: SMatrix::zeros(), sides: [SVector::zeros(); R] };
        let part = |contacts: Range<usize>| {
            let mut sums = zero;
            contacts.for_each(|contact| add(&mut sums, contact));
            sums
        };
        let plus = |a: Self, b: Self| Self {
            stiffness: a.stiffness + b.stiffness,
            sides: std::array::from_fn(|r| a.sides[r] + b.sides[r]),
        };
        let mut sums = in_halves(0..contacts, &part, &plus);
        (rank..D).for_each(|k| sums.stiffness[(k, k)] = 1.0);
        sums
    }

    /// Adds the terms of a contact, `weight` times: what it sees of y, what its state holds of its
    /// stretch (`None`: everything), and p for each side.
    pub(crate) fn add<const C: usize>(
        &mut self,
        seen: &SMatrix<f64, C, D>,
        hold: Option<&SMatrix<f64, C, C>>,
        pushed: Option<[SVector<f64, C>; R]>,
        weight: f64,
    ) {
        let held = hold.map_or(*seen, |hold| hold * seen);
        self.stiffness += seen.tr_mul(&(held * weight));
        for (side, pushed) in self.sides.iter_mut().zip(pushed.into_iter().flatten()) {
            *side += seen.tr_mul(&(pushed * weight));
        }
    }
}
