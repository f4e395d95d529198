//! Piecewise smooth equations for the forces, one per component of each contact, and damped Newton steps for their solution.
//!
//! The equations of [`alart_curnier`](super::alart_curnier) and of the [`central_path`](super::central_path) have this form. In both, the residual of
//! a contact depends only on its own force and velocity. The Jacobian therefore has the block pattern of the matrix W from forces to velocities.

use super::blocks::{Blocks, ContactBlock};
use super::elimination;
use crate::numerics::tolerances::SUFFICIENT_DECREASE;
use crate::numerics::{IntoList, numbered};
use crate::prelude::*;
use nalgebra::{DVector, SVector};

/// Residuals of the equations of all contacts at the forces r, and their derivatives.
#[derive(Debug, Clone)]
pub(super) struct Linearisation<const C: usize> {
    pub(super) r: DVector<f64>,
    /// Residual of each contact: C components each, in the order of contacts.
    pub(super) residual: DVector<f64>,
    /// Derivative of a contact's residual with respect to its force, at constant velocity.
    pub(super) by_force: Vec<ContactBlock<C>>,
    /// Derivative of a contact's residual with respect to its velocity.
    pub(super) by_velocity: Vec<ContactBlock<C>>,
    /// Weighted norm of the residuals of all contacts.
    pub(super) size: f64,
    /// Weighted norm of the terms whose differences are the residuals. Residuals that are small relative to it are rounding errors. The equations of
    /// the central path do not compute it; it stays 0.
    pub(super) terms: f64,
}

impl<const C: usize> Linearisation<C> {
    pub(super) fn new(r: DVector<f64>) -> Self {
        let (residual, n) = (DVector::zeros(r.len()), r.len() / C);
        Self {
            r,
            residual,
            by_force: Vec::with_capacity(n),
            by_velocity: Vec::with_capacity(n),
            size: 0.0,
            terms: 0.0,
        }
    }

    pub(super) fn push(
        &mut self,
        residual: SVector<f64, C>,
        by_force: ContactBlock<C>,
        by_velocity: ContactBlock<C>,
    ) {
        self.residual.fixed_rows_mut::<C>(C * self.by_force.len()).copy_from(&residual);
        self.by_force.push(by_force);
        self.by_velocity.push(by_velocity);
    }
}

/// Equations for the forces of all contacts, given by their residuals at trial forces; [`descend`] solves them.
pub(super) trait Equations<const C: usize> {
    /// Residuals and derivatives at the forces r.
    fn at(&self, r: DVector<f64>) -> Linearisation<C>;

    /// Multiple of the identity that is added to a contact's diagonal block of the matrix W. This shift makes the equations of redundant contacts
    /// regular.
    fn shift(&self, contact: usize) -> f64;

    fn blocks(&self) -> &Blocks<C>;
}

/// Limits of Newton's method with line search ([`descend`]).
#[derive(Debug, Clone, Copy)]
pub(super) struct IterationLimits {
    /// Upper limit of the number of Newton steps.
    pub(super) steps: usize,
    /// Norm of the residuals at which the iteration has converged.
    pub(super) enough: f64,
    /// Norm of the residuals, relative to the norm of their terms, at which the iteration has also converged.
    pub(super) rounding: f64,
    /// The line search tries no smaller fraction of a Newton step than this.
    pub(super) shortest: f64,
    /// Upper limit of the number of full Newton steps that are made in spite of a failed line search. The line search fails if no fraction of a step,
    /// down to `shortest`, reduces the residuals enough.
    pub(super) leaps: usize,
}

/// Newton's method with line search, from the forces r, within the limits of `patience`. Returns the last point, converged or not, and the number of
/// steps. `order` is the elimination order.
pub(super) fn descend<const C: usize>(
    equations: &impl Equations<C>,
    order: &[usize],
    r: DVector<f64>,
    mut patience: IterationLimits,
) -> (Linearisation<C>, usize) {
    let mut point = equations.at(r);
    let mut made = 0;
    while made < patience.steps && point.size > patience.enough.max(patience.rounding * point.terms) {
        let Some(step) = newton_step(equations, order, &point) else { break };
        made += 1;
        let mut part = 1.0;
        let mut next = equations.at(&point.r + &step);
        while next.size.is_nan() || next.size > (1.0 - SUFFICIENT_DECREASE * part) * point.size {
            part *= 0.5;
            if part < patience.shortest {
                break;
            }
            next = equations.at(&point.r + &step * part);
        }
        if part < patience.shortest {
            if patience.leaps == 0 {
                break;
            }
            patience.leaps -= 1;
            next = equations.at(&point.r + &step);
        }
        point = next;
    }
    (point, made)
}

/// The Newton step at `point`: a change of the forces of all contacts. `None` if a pivot block of the elimination is singular.
pub(super) fn newton_step<const C: usize>(
    equations: &impl Equations<C>,
    order: &[usize],
    point: &Linearisation<C>,
) -> Option<DVector<f64>> {
    let blocks = equations.blocks();
    let row = |i: usize| {
        let (by_force, by_velocity) = (point.by_force[i], point.by_velocity[i]);
        let own = blocks.diagonal(i) + ContactBlock::identity() * equations.shift(i);
        let mut row = vec![(i, by_force + by_velocity * own)];
        // If the residual of a contact does not depend on its velocity (an open contact), it does not depend on the forces of other contacts.
        if by_velocity.iter().any(|x| *x != 0.0) {
            blocks.off_diagonal(i).iter().map(|(j, w)| (*j, by_velocity * w)).append_to(&mut row);
        }
        row
    };
    let rows: Vec<elimination::SparseRow<C>> = numbered(blocks.len(), &row);
    elimination::solve(order, &rows, &-&point.residual)
}
