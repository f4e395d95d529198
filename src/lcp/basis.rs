//! Complementary bases. A basis belongs to the problem 0 ≤ z ⟂ w = M z + q ≥ 0.

use crate::numerics::counted;
use crate::prelude::*;

/// A complementary basis: of every pair (w_i, z_i) one variable is basic, the other is nonbasic and zero.
///
/// Let α be the set of i with z_i basic. The basis is regular if the principal block M_αα is regular. The point of the basis is then z_α = −M_αα⁻¹
/// q_α, z = 0 elsewhere, w = M z + q (Cottle, Pang & Stone, *The Linear Complementarity Problem*, 1992).
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Basis {
    basic_z: Vec<bool>,
}

impl Basis {
    /// The slack basis of a problem with n rows, in which every slack w_i is basic: α = ∅.
    #[must_use]
    pub fn slack(n: usize) -> Self {
        Self { basic_z: vec![false; n] }
    }

    /// The basis of n pairs in which z_i is basic for the given indices i, counted from 0, and w_i for all others; indices ≥ n are ignored.
    pub fn from_indices(n: usize, alpha: impl IntoIterator<Item = usize>) -> Self {
        let mut basic_z = vec![false; n];
        for i in alpha {
            if let Some(entry) = basic_z.get_mut(i) {
                *entry = true;
            }
        }
        Self { basic_z }
    }

    /// Resets this basis to the slack basis of a problem with n rows, in which every z_i is nonbasic.
    pub(super) fn clear(&mut self, n: usize) {
        self.basic_z.clear();
        self.basic_z.resize(n, false);
    }

    pub(super) fn insert(&mut self, i: usize) {
        self.basic_z[i] = true;
    }

    pub(super) fn toggle(&mut self, i: usize) {
        self.basic_z[i] = !self.basic_z[i];
    }

    /// Whether z_i is basic, i counted from 0; false for i ≥ n.
    #[must_use]
    pub fn contains(&self, i: usize) -> bool {
        self.basic_z.get(i).copied().unwrap_or(false)
    }

    /// The elements of α, the indices of the basic z_i, in increasing order.
    pub fn iter(&self) -> impl Iterator<Item = usize> + Clone + '_ {
        self.basic_z.iter().enumerate().filter(|(_, basic)| **basic).map(|(i, _)| i)
    }

    /// Number of elements of α, the basic z_i.
    #[must_use]
    pub fn count(&self) -> usize {
        counted(&self.basic_z, &|basic| *basic)
    }

    /// Number n of pairs (w_i, z_i).
    #[must_use]
    pub fn len(&self) -> usize {
        self.basic_z.len()
    }

    /// Whether there are no pairs, n = 0.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.basic_z.is_empty()
    }
}

/// One of the 2n variables w_i and z_i of a problem with n rows; i is counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Variable {
    /// The slack w_i.
    W(usize),
    /// The unknown z_i.
    Z(usize),
}

impl Variable {
    /// The index i of the pair (w_i, z_i).
    #[must_use]
    pub fn index(self) -> usize {
        let (Self::W(i) | Self::Z(i)) = self;
        i
    }

    /// The other variable of the same pair.
    #[must_use]
    pub fn complement(self) -> Self {
        match self {
            Self::W(i) => Self::Z(i),
            Self::Z(i) => Self::W(i),
        }
    }
}
