//! The equations of equilibrium in energy coordinates, as sums over contacts. A change of one contact's state changes only the terms of that contact.
//!
//! The map Q of a contact converts a motion of the object to the contact's stretch in energy coordinates. In these coordinates x is its force, and x⁰
//! its force in the elastic trial, in which everything sticks. Forces balance the load where `Σ Qᵀ(x - x⁰) = 0`. In a known contact state `x = P u`,
//! a projection P of the stretch u = x⁰ - Q y. These are d equations for the motion y on top of the elastic trial motion. Each further variable λ_r
//! on which x depends, such as a load parameter, adds a right-hand side (p_r is the derivative of x by λ_r):
//!
//! ```text
//! T y = Σ_r b_r λ_r,     T = Σ QᵀP Q,     b_r = Σ Qᵀp_r
//! ```
//!
//! T is the identity where everything sticks, whatever the stiffnesses. (With scaled maps each term is multiplied by the `weight` of
//! `EnergyCoordinates`.)

use crate::numerics::{ScaledMap, Size, Square, Vector};
use core::ops::Range;

use nalgebra::{SMatrix, SVector};

use crate::numerics::in_halves;

/// Whether so many changes of single terms were made to sums over contacts that, because of their rounding, the sums should be computed anew.
pub(crate) fn are_stale(changes: usize, contacts: usize) -> bool {
    // Each change leaves a rounding error in the sums, but computing them anew evaluates every contact. After this number of changes the sums are
    // computed anew.
    changes > 64 + contacts / 4
}

/// The matrix T and the R right-hand sides b_r of the equations of equilibrium `T y = Σ b_r λ_r` of this file.
#[derive(Debug, Clone)]
pub(crate) struct Sums<const R: usize> {
    pub(crate) stiffness: Square,
    pub(crate) sides: [Vector; R],
}

impl<const R: usize> Default for Sums<R> {
    /// The sums [`Self::sticking`] for zero coordinates.
    fn default() -> Self {
        Self::sticking(Size::default())
    }
}

impl<const R: usize> Sums<R> {
    /// The sums if all contacts stick, without a loop over contacts: T is the identity, since the maps Q of all contacts together have orthonormal
    /// columns, and the b_r are zero.
    pub(crate) fn sticking(size: Size) -> Self {
        let stiffness = Square::from_diagonal(size, |_| 1.0);
        Self { stiffness, sides: core::array::from_fn(|_| Vector::zeros()) }
    }

    /// Makes these sums equal to [`Self::sticking`], in the same memory.
    pub(crate) fn stick(&mut self, size: Size) {
        self.stiffness.clear(size);
        (0..size.count()).for_each(|k| self.stiffness[(k, k)] = 1.0);
        self.sides.iter_mut().for_each(|side| *side = Vector::zeros());
    }

    /// The matrix and right-hand sides, summed over all contacts; `add(sums, contact)` adds the terms of one contact. Components of the motion y from
    /// index `rank` on move no contact. Their diagonal entries of the matrix are set to one, so that it can be factorised.
    pub(crate) fn over(
        size: Size,
        contacts: usize,
        rank: usize,
        add: &(impl Fn(&mut Self, usize) + Sync),
    ) -> Self {
        let part = |contacts: Range<usize>| {
            let stiffness = Square::zeros(size);
            let mut sums = Self { stiffness, sides: core::array::from_fn(|_| Vector::zeros()) };
            contacts.for_each(|contact| add(&mut sums, contact));
            sums
        };
        let plus = |mut a: Self, b: Self| {
            a.stiffness += &b.stiffness;
            a.sides.iter_mut().zip(&b.sides).for_each(|(a, b)| *a += b);
            a
        };
        let mut sums = in_halves(0..contacts, &part, &plus);
        (rank..size.count()).for_each(|k| sums.stiffness[(k, k)] = 1.0);
        sums
    }

    /// Adds the terms of a contact, times `weight`. `seen` is the map Q from the motion y of the object to the contact's stretch. `hold` is the
    /// projection P of its state (`None`: identity), and `pushed` has the derivatives p_r of its force by the variables λ_r (`None`: zero).
    pub(crate) fn add(
        &mut self,
        seen: &ScaledMap,
        hold: Option<&SMatrix<f64, 3, 3>>,
        pushed: Option<[SVector<f64, 3>; R]>,
        weight: f64,
    ) {
        self.stiffness.add_congruent(seen, hold, weight);
        let Some(pushed) = pushed else { return };
        for (side, pushed) in self.sides.iter_mut().zip(pushed) {
            *side += seen.tr_mul(&(pushed * weight));
        }
    }
}
