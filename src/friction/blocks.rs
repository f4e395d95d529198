//! W contact by contact: one block for each pair of contacts that move each other.
//!
//! Piles and stacks couple each contact with a few others, so that most of W vanishes.

use super::problem::{FrictionProblem, part};
use crate::prelude::*;
use nalgebra::{DVector, SMatrix, SVector};

/// A block of W: what the force of one contact moves at another.
pub(super) type ContactBlock<const C: usize> = SMatrix<f64, C, C>;

/// The blocks of W that do not vanish.
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
        // Down the columns, as W lies in memory.
        for j in 0..n {
            for (i, others) in others.iter_mut().enumerate().filter(|(i, _)| *i != j) {
                let block = block(i, j);
                if block.iter().any(|w| *w != 0.0) {
                    others.push((j, block));
                }
            }
        }
        Self { own: (0..n).map(|i| block(i, i)).collect(), others }
    }

    /// The number of contacts.
    pub(super) fn len(&self) -> usize {
        self.own.len()
    }

    /// How a contact moves itself.
    pub(super) fn own(&self, i: usize) -> &ContactBlock<C> {
        &self.own[i]
    }

    /// The other contacts that move this one, by index.
    pub(super) fn others(&self, i: usize) -> &[(usize, ContactBlock<C>)] {
        &self.others[i]
    }

    /// The size of what moves a contact: its largest own entry, or, where its own force does not move it, any.
    pub(super) fn size(&self, i: usize) -> f64 {
        let own = self.own[i].amax();
        let any = || self.others[i].iter().fold(0.0_f64, |size, (_, w)| size.max(w.amax()));
        if own > 0.0 { own } else { any() }
    }

    /// The inverse of that, which turns velocities into forces: ρ of each contact.
    pub(super) fn scales(&self) -> Vec<f64> {
        let scale = |i| if self.size(i) > 0.0 { 1.0 / self.size(i) } else { 1.0 };
        (0..self.len()).map(scale).collect()
    }

    /// W r at one contact, without what its own force does.
    pub(super) fn by_others(&self, i: usize, r: &DVector<f64>) -> SVector<f64, C> {
        self.others[i].iter().fold(SVector::zeros(), |sum, (j, w)| sum + w * part::<C>(r, *j))
    }

    /// u = W r + q.
    pub(super) fn velocities(&self, r: &DVector<f64>, q: &DVector<f64>) -> DVector<f64> {
        let mut u = q.clone();
        for i in 0..self.len() {
            let mut at = u.fixed_rows_mut::<C>(C * i);
            at += self.by_others(i, r) + self.own[i] * part::<C>(r, i);
        }
        u
    }

    /// The sizes of their terms, |W| |r| + |q|.
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
