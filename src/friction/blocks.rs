//! The matrix W, which maps contact forces to velocities, stored as blocks of C × C entries. A block is the velocity of one contact per unit force at
//! another contact, or at itself (diagonal block).

use super::problem::{FrictionProblem, part};
use crate::numerics::numbered;
use crate::prelude::*;
use nalgebra::{DVector, SMatrix, SVector};

/// A block of the matrix W: the velocity of one contact per unit force at another.
pub(super) type ContactBlock<const C: usize> = SMatrix<f64, C, C>;

/// The nonzero blocks of the matrix W from contact forces to velocities.
#[derive(Debug, Clone)]
pub(super) struct Blocks<const C: usize> {
    own: Vec<ContactBlock<C>>,
    others: Vec<Vec<(usize, ContactBlock<C>)>>,
}

impl<const C: usize> Blocks<C> {
    pub(super) fn of(problem: &FrictionProblem<C>) -> Self {
        let n = problem.len();
        let block = |i: usize, j: usize| problem.w.fixed_view::<C, C>(C * i, C * j).into_owned();
        let mut others = vec![Vec::new(); n];
        // The blocks are visited column by column, in the order in which nalgebra stores the matrix W.
        for j in 0..n {
            for (i, others) in others.iter_mut().enumerate().filter(|(i, _)| *i != j) {
                let block = block(i, j);
                if block.iter().any(|w| *w != 0.0) {
                    others.push((j, block));
                }
            }
        }
        Self { own: numbered(n, &|i| block(i, i)), others }
    }

    pub(super) fn len(&self) -> usize {
        self.own.len()
    }

    pub(super) fn diagonal(&self, i: usize) -> &ContactBlock<C> {
        &self.own[i]
    }

    /// The nonzero blocks of a contact's block row of W except the diagonal block, each with the index of the contact whose force it multiplies.
    pub(super) fn off_diagonal(&self, i: usize) -> &[(usize, ContactBlock<C>)] {
        &self.others[i]
    }

    /// The magnitude of a contact's block row: the largest absolute value of an entry of its diagonal block. If that block is zero, the largest
    /// absolute value of an entry of all other blocks of the row.
    pub(super) fn size(&self, i: usize) -> f64 {
        let own = self.own[i].amax();
        let any = || self.others[i].iter().fold(0.0_f64, |size, (_, w)| size.max(w.amax()));
        if own > 0.0 { own } else { any() }
    }

    /// The factor ρ of each contact that converts velocities to forces: the inverse of the magnitude of its block row ([`Self::size`]), or 1 if that
    /// is zero.
    pub(super) fn scales(&self) -> Vec<f64> {
        let scale = |i| if self.size(i) > 0.0 { 1.0 / self.size(i) } else { 1.0 };
        numbered(self.len(), &scale)
    }

    /// The velocity of contact i due to the forces r of all other contacts; its own force does not contribute.
    pub(super) fn by_others(&self, i: usize, r: &DVector<f64>) -> SVector<f64, C> {
        self.others[i].iter().fold(SVector::zeros(), |sum, (j, w)| sum + w * part::<C>(r, *j))
    }

    /// The velocities u = W r + q for the forces r, with the matrix W and the velocities q without contact forces.
    pub(super) fn velocities(&self, r: &DVector<f64>, q: &DVector<f64>) -> DVector<f64> {
        let mut u = q.clone();
        for i in 0..self.len() {
            let mut at = u.fixed_rows_mut::<C>(C * i);
            at += self.by_others(i, r) + self.own[i] * part::<C>(r, i);
        }
        u
    }

    /// For each velocity, the sum of the magnitudes of its terms: |W| |r| + |q|, with the forces r and the velocities q without contact forces.
    pub(super) fn terms(&self, r: &DVector<f64>, q: &DVector<f64>) -> DVector<f64> {
        let mut terms = q.abs();
        for i in 0..self.len() {
            let others = self.others[i].iter().map(|(j, w)| w.abs() * part::<C>(r, *j).abs());
            let mut at = terms.fixed_rows_mut::<C>(C * i);
            at += others.fold(self.own[i].abs() * part::<C>(r, i).abs(), |sum, moved| sum + moved);
        }
        terms
    }
}
