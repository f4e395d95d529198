//! Piecewise smooth equations, one a component of each contact, and damped steps of Newton's method towards their solution.
//!
//! Two families are of this kind: those of [`alart_curnier`](super::alart_curnier) and of the [`central_path`](super::central_path). In each, what a contact
//! misses depends on its own force and velocity alone, so that the equations are in blocks where W is.

use super::blocks::{Blocks, ContactBlock};
use super::elimination;
use crate::prelude::*;
use nalgebra::{DVector, SVector};

/// A step must take away this part of the share of the error that its length promises.
const GAIN: f64 = 0.1;

/// What the forces of a place miss, and how that changes.
#[derive(Debug, Clone)]
pub(super) struct Linearisation<const C: usize> {
    pub(super) r: DVector<f64>,
    /// What each contact misses.
    pub(super) missed: DVector<f64>,
    /// How that changes with the force of the contact, its velocity held.
    pub(super) by_force: Vec<ContactBlock<C>>,
    /// How that changes with its velocity.
    pub(super) by_velocity: Vec<ContactBlock<C>>,
    /// How large what is missed is, and the terms that it consists of.
    pub(super) size: f64,
    pub(super) terms: f64,
}

impl<const C: usize> Linearisation<C> {
    pub(super) fn new(r: DVector<f64>) -> Self {
        let (missed, n) = (DVector::zeros(r.len()), r.len() / C);
        Self {
            r,
            missed,
            by_force: Vec::with_capacity(n),
            by_velocity: Vec::with_capacity(n),
            size: 0.0,
            terms: 0.0,
        }
    }

    /// Adds what the next contact misses.
    pub(super) fn push(
        &mut self,
        missed: SVector<f64, C>,
        by_force: ContactBlock<C>,
        by_velocity: ContactBlock<C>,
    ) {
        self.missed.fixed_rows_mut::<C>(C * self.by_force.len()).copy_from(&missed);
        self.by_force.push(by_force);
        self.by_velocity.push(by_velocity);
    }
}

/// Equations for the forces of all contacts.
pub(super) trait Equations<const C: usize> {
    /// Where these forces are.
    fn at(&self, r: DVector<f64>) -> Linearisation<C>;

    /// What is added to the own block of a contact so that the equations of redundant contacts have a solution.
    fn shift(&self, contact: usize) -> f64;

    fn blocks(&self) -> &Blocks<C>;
}

/// How far steps are pursued.
#[derive(Debug, Clone, Copy)]
pub(super) struct Patience {
    /// Steps at most.
    pub(super) steps: usize,
    /// It has arrived where what is missed is this small, or this part of its terms.
    pub(super) enough: f64,
    pub(super) rounding: f64,
    /// Shorter parts of a step are not tried.
    pub(super) shortest: f64,
    /// So often the whole step is made although no part of it gains anything.
    pub(super) leaps: usize,
}

/// The place that Newton's method comes to, and how many steps it made. `order` is that of the elimination.
pub(super) fn descend<const C: usize>(
    equations: &impl Equations<C>,
    order: &[usize],
    r: DVector<f64>,
    mut patience: Patience,
) -> (Linearisation<C>, usize) {
    let mut here = equations.at(r);
    let mut made = 0;
    while made < patience.steps && here.size > patience.enough.max(patience.rounding * here.terms) {
        let Some(step) = newton_step(equations, order, &here) else { break };
        made += 1;
        let mut part = 1.0;
        let mut next = equations.at(&here.r + &step);
        while next.size.is_nan() || next.size > (1.0 - GAIN * part) * here.size {
            part *= 0.5;
            if part < patience.shortest {
                break;
            }
            next = equations.at(&here.r + &step * part);
        }
        if part < patience.shortest {
            if patience.leaps == 0 {
                break;
            }
            patience.leaps -= 1;
            next = equations.at(&here.r + &step);
        }
        here = next;
    }
    (here, made)
}

/// The step to where the linearised equations hold.
pub(super) fn newton_step<const C: usize>(
    equations: &impl Equations<C>,
    order: &[usize],
    here: &Linearisation<C>,
) -> Option<DVector<f64>> {
    let blocks = equations.blocks();
    let row = |i: usize| {
        let (by_force, by_velocity) = (here.by_force[i], here.by_velocity[i]);
        let own = blocks.own(i) + ContactBlock::identity() * equations.shift(i);
        let mut row = vec![(i, by_force + by_velocity * own)];
        // An open contact sees no other.
        if by_velocity.iter().any(|x| *x != 0.0) {
            row.extend(blocks.others(i).iter().map(|(j, w)| (*j, by_velocity * w)));
        }
        row
    };
    let rows: Vec<elimination::SparseRow<C>> = (0..blocks.len()).map(row).collect();
    elimination::solve(order, &rows, &-&here.missed)
}
