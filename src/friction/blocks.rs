//! W in blocks: one for each pair of contacts of which one moves the other.
//!
//! In piles and stacks each contact is coupled with a few others, so most of W vanishes.

use super::problem::{FrictionProblem, part};
use crate::numerics::numbered;
use crate::prelude::*;
use nalgebra::{DVector, SMatrix, SVector};

/// A block of W: the velocity of one contact for a unit force at another.
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
        // Column by column, as W is stored.
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

    /// The number of contacts.
    pub(super) fn len(&self) -> usize {
        self.own.len()
    }

    /// The block of a contact's own force and velocity.
    pub(super) fn own(&self, i: usize) -> &ContactBlock<C> {
        &self.own[i]
    }

    /// The blocks of the other contacts that move this one, with their indices.
    pub(super) fn others(&self, i: usize) -> &[(usize, ContactBlock<C>)] {
        &self.others[i]
    }

    /// The size of a contact's block row: its largest own entry or, if its own force does not move it, the largest of all.
    pub(super) fn size(&self, i: usize) -> f64 {
        let own = self.own[i].amax();
        let any = || self.others[i].iter().fold(0.0_f64, |size, (_, w)| size.max(w.amax()));
        if own > 0.0 { own } else { any() }
    }

    /// ρ of each contact, the inverse of [`Self::size`], which converts velocities to forces.
    pub(super) fn scales(&self) -> Vec<f64> {
        let scale = |i| if self.size(i) > 0.0 { 1.0 / self.size(i) } else { 1.0 };
        numbered(self.len(), &scale)
    }

    /// The part of W r at one contact that other contacts cause.
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

    /// The sizes of the terms of u, |W| |r| + |q|.
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
