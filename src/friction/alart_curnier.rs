//! The piecewise smooth equations of P. Alart and A. Curnier, alone or with a proximal term that holds forces near an anchor.
//!
//! A contact has the force r and the velocity u, with normal and tangential parts N and T. Let ζ = r − ρ u, with a factor ρ that converts velocities
//! to forces. The contact is open if ζ_N ≤ 0, sticks if ‖ζ_T‖ ≤ μ ζ_N, and slides otherwise. The law is r = Π(ζ) with
//!
//! ```text
//! open      Π = 0
//! sticking  Π = ζ
//! sliding   Π_N = ζ_N,   Π_T = μ ζ_N ζ_T / ‖ζ_T‖
//! ```
//!
//! (Comput. Methods Appl. Mech. Eng. 92, 1991.) The forces of redundant contacts are not determined, so Newton's method may drift among them. Let a
//! be given forces, the anchor, and δ > 0 a weight. With ζ = r − ρ u − δ (r − a) the forces are determined: the proximal term −δ (r − a) holds them
//! near a. The anchor a is replaced again and again by the forces that solve these equations, while δ decreases. The forces then converge to a
//! solution of the law (proximal point method, R. T. Rockafellar, SIAM J. Control Optim. 14, 1976).

use super::blocks::{Blocks, ContactBlock};
use super::equations::{Equations, Linearisation};
use super::law::tangent;
use super::problem::{FrictionProblem, part};
use super::tolerances::LEAST_ANCHOR;
use crate::numerics::{Reals, mapped, numbered};
use crate::prelude::*;
use nalgebra::{DVector, SMatrix, SVector};

/// The law r = Π(ζ) of a contact with friction μ. Returns the contact force Π(ζ) and its derivative with respect to ζ, for the value ζ = r − ρ u,
/// which is `trial`.
pub(super) fn answer<const C: usize>(
    trial: &SVector<f64, C>,
    mu: f64,
) -> (SVector<f64, C>, SMatrix<f64, C, C>) {
    let slip = tangent(trial);
    let length = slip.norm();
    if trial[0] <= 0.0 {
        return (SVector::zeros(), SMatrix::zeros());
    }
    if length <= mu * trial[0] && mu > 0.0 {
        return (*trial, SMatrix::identity());
    }
    let mut change = SMatrix::zeros();
    let mut answer = SVector::zeros();
    if length > 0.0 {
        let along = slip / length;
        answer = along * (mu * trial[0]);
        change = (SMatrix::identity() - along * along.transpose()) * (mu * trial[0] / length);
        change.column_mut(0).copy_from(&(along * mu));
        change.row_mut(0).fill(0.0);
    }
    (answer[0], change[(0, 0)]) = (trial[0], 1.0);
    (answer, change)
}

/// The equations r = Π(ζ) of all contacts, with a proximal term of weight δ (`delta`) that holds the forces r near the forces `anchor`.
pub(super) struct Anchored<'a, const C: usize> {
    pub(super) problem: &'a FrictionProblem<C>,
    pub(super) blocks: &'a Blocks<C>,
    /// The factor ρ of each contact that converts velocities to forces.
    pub(super) rho: Vec<f64>,
    pub(super) anchor: DVector<f64>,
    pub(super) delta: f64,
    /// Weight of each contact's squared residual in the norm of the residuals that the line search reduces.
    pub(super) weight: Vec<f64>,
}

impl<'a, const C: usize> Anchored<'a, C> {
    /// The equations of Alart and Curnier with the proximal term −δ (r − a), where a are the forces `anchor`. The line search reduces a weighted norm
    /// of the residuals. If `by_contact` is false, each squared residual is divided by ρ, which makes it an energy. If it is true, each squared
    /// residual is divided by the squared magnitude of the contact's own force and velocity, so that every contact counts alike.
    pub(super) fn with_anchor(
        problem: &'a FrictionProblem<C>,
        blocks: &'a Blocks<C>,
        rho: Vec<f64>,
        anchor: &DVector<f64>,
        (delta, by_contact): (f64, bool),
    ) -> Self {
        let energy = || mapped(&rho, &|rho| 1.0 / rho);
        let own_sizes = || {
            let terms = blocks.terms(anchor, &problem.q);
            let size =
                |i: usize| part::<C>(anchor, i).norm().max(rho[i] * part::<C>(&terms, i).amax()).powi(2);
            let largest = (0..rho.len()).map(|i| size(i) / rho[i]).most();
            // Lower limit of the magnitude of a contact's force and velocity, relative to the largest magnitude of all contacts. Residuals are
            // divided by this magnitude. Without the limit, a contact with almost no force would dominate the norm of the residuals.
            let faintest = 1e-6;
            let weight = |i: usize| 1.0 / size(i).max(faintest * faintest * largest * rho[i]);
            numbered(rho.len(), &weight)
        };
        let weight = if by_contact { own_sizes() } else { energy() };
        Self { problem, blocks, rho, anchor: anchor.clone(), delta, weight }
    }
}

impl<const C: usize> Equations<C> for Anchored<'_, C> {
    fn at(&self, r: DVector<f64>) -> Linearisation<C> {
        let u = self.blocks.velocities(&r, &self.problem.q);
        let mut point = Linearisation::new(r);
        for (i, (rho, weight)) in self.rho.iter().zip(&self.weight).enumerate() {
            let (force, velocity) = (part::<C>(&point.r, i), part::<C>(&u, i) * *rho);
            let trial = force - velocity - (force - part::<C>(&self.anchor, i)) * self.delta;
            let (answer, change) = answer(&trial, self.problem.mu[i]);
            let residual = force - answer;
            point.size += residual.norm_squared() * weight;
            point.terms += (force.norm_squared() + velocity.norm_squared()) * weight;
            point.push(residual, ContactBlock::identity() - change, change * *rho);
        }
        (point.size, point.terms) = (point.size.sqrt(), point.terms.sqrt());
        point
    }

    fn shift(&self, contact: usize) -> f64 {
        self.delta.max(LEAST_ANCHOR) / self.rho[contact]
    }

    fn blocks(&self) -> &Blocks<C> {
        self.blocks
    }
}
