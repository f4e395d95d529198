//! The central path to a solution, through the interior of the friction cones, as a parameter τ decreases to zero.
//!
//! A contact with normal n has the force r and the velocity u. Coulomb's law is û ⟂ r with r in the friction cone and û = u + μ ‖u_T‖ n in its dual
//! cone ([module](super)). In the coordinates r' = (μ r_N, r_T) and û' = (û_N / μ, û_T) both cones become ‖x_T‖ ≤ x_N. The law is then r' = P(r' − ρ
//! û') with the projection P onto this cone and any factor ρ > 0. On the central path û' ∘ r' = τ (1, 0) instead, with the Jordan product ∘ of the
//! cone. These are the same equations with the smoothed projection
//!
//! ```text
//! P(x) = Σ± φ(x_N ± ‖x_T‖) (1, ± x_T / ‖x_T‖) / 2,     φ(λ) = (λ + √(λ² + 4 ρ τ)) / 2
//! ```
//!
//! which keeps forces strictly inside (M. Fukushima, Z.-Q. Luo and P. Tseng, SIAM J. Optim. 12, 2001), so that no contact has to be declared open,
//! sticking or sliding before the end of the path. Newton's method follows the solutions as τ decreases.

use super::blocks::{Blocks, ContactBlock};
use super::equations::{Equations, IterationLimits, Linearisation, descend};
use super::law::tangent;
use super::problem::{FrictionProblem, part};
use super::tolerances::SHIFTED_BLOCK;
use crate::numerics::{Reals, numbered};
use crate::prelude::*;
use core::ops::ControlFlow;
use nalgebra::{DVector, SVector};

/// The smoothed equations r' = P(r' − ρ û') of all contacts for one value of the path's parameter τ (symbols at the top of the file).
pub(super) struct Smoothed<'a, const C: usize> {
    pub(super) problem: &'a FrictionProblem<C>,
    pub(super) blocks: &'a Blocks<C>,
    /// The factor ρ of each contact that converts velocities to forces, from [`scales`].
    pub(super) rho: &'a [f64],
    pub(super) tau: f64,
}

/// The factor ρ of each contact that converts velocities to forces, in the scaled coordinates r' and û' (see the top of the file).
pub(super) fn scales<const C: usize>(problem: &FrictionProblem<C>, blocks: &Blocks<C>) -> Vec<f64> {
    let scale = |i: usize| {
        let own = blocks.diagonal(i);
        let mu = if problem.mu[i] > 0.0 { problem.mu[i] } else { 1.0 };
        let mut size = tangent_block(own).amax().max(own[(0, 0)].abs() / (mu * mu));
        if size == 0.0 {
            size = blocks.size(i);
        }
        if size > 0.0 { 1.0 / size } else { 1.0 }
    };
    numbered(problem.len(), &scale)
}

fn tangent_block<const C: usize>(own: &ContactBlock<C>) -> ContactBlock<C> {
    let mut block = *own;
    block.row_mut(0).fill(0.0);
    block.column_mut(0).fill(0.0);
    block
}

/// Follows the central path from the forces r, as its parameter τ decreases. The first τ is `begin` times the mean of ‖r_i‖² / ρ_i over the
/// contacts i. `judge` returns the residual of the forces that it receives, or stops the path. Returns the forces with the smallest residual,
/// and the number of Newton steps.
pub(super) fn follow<const C: usize>(
    problem: &FrictionProblem<C>,
    blocks: &Blocks<C>,
    order: &[usize],
    mut r: DVector<f64>,
    begin: f64,
    mut judge: impl FnMut(&DVector<f64>) -> ControlFlow<(), f64>,
) -> (DVector<f64>, usize) {
    let rho = scales(problem, blocks);
    let count = problem.len() as f64;
    let energy = (0..problem.len()).map(|i| part::<C>(&r, i).norm_squared() / rho[i]).added() / count;
    let ControlFlow::Continue(missing) = judge(&r) else { return (r, 0) };
    let mut best = (missing, r.clone());
    // The parameter τ of the last point on the central path, and the factor by which τ is reduced for the next point. `made` is the number of Newton
    // steps made so far.
    let (mut tau, mut factor, mut made) = (begin * energy, 1.0, 0);
    // Factor of τ between the first two points of the path; later factors adapt to the number of Newton steps.
    let slow = 0.2;
    // The path ends where τ is 1e-16 times `energy`, the mean of ‖r_i‖² / ρ_i at the start; 1e-16 is near the working precision. The factor of τ
    // moves towards 1 whenever Newton's method fails. Once the factor exceeds 0.9, Newton's method has lost the path.
    while tau * factor > 1e-16 * energy && (factor < 0.9 || factor == 1.0) {
        let smoothed = Smoothed { problem, blocks, rho: &rho, tau: tau * factor };
        // A point counts as on the path if the root mean square of its residuals is below this fraction of √τ. With a smaller fraction Newton steps
        // are made that the next τ makes obsolete; with a larger one Newton's method loses the path.
        let enough = 0.1 * (count * smoothed.tau).sqrt();
        let patience = IterationLimits { steps: 50, enough, rounding: 0.0, shortest: 1e-3, leaps: 0 };
        let (point, steps) = descend(&smoothed, order, r.clone(), patience);
        made += steps;
        let ControlFlow::Continue(missing) = judge(&point.r) else { break };
        if missing < best.0 {
            best = (missing, point.r.clone());
        }
        let first = factor == 1.0;
        if point.size <= enough {
            (r, tau) = (point.r, tau * factor);
            factor = if first {
                slow
            } else if steps <= 3 {
                (factor * factor).max(0.03)
            } else {
                factor
            };
        } else if first {
            // Newton's method has not reached the first point of the path. A larger τ puts this point farther inside the cones, where Newton's method
            // finds it more easily.
            tau /= slow;
            if tau > 1e3 * energy {
                break;
            }
        } else {
            factor = factor.sqrt();
        }
    }
    (best.1, made)
}

impl<const C: usize> Equations<C> for Smoothed<'_, C> {
    fn at(&self, r: DVector<f64>) -> Linearisation<C> {
        let u = self.blocks.velocities(&r, &self.problem.q);
        let mut point = Linearisation::new(r);
        for (i, rho) in self.rho.iter().enumerate() {
            let (residual, by_force, by_velocity) =
                contact::<C>(&part(&point.r, i), &part(&u, i), self.problem.mu[i], (*rho, self.tau));
            point.size += residual.norm_squared() / rho;
            point.push(residual, by_force, by_velocity);
        }
        point.size = point.size.sqrt();
        point
    }

    fn shift(&self, contact: usize) -> f64 {
        SHIFTED_BLOCK / self.rho[contact]
    }

    fn blocks(&self) -> &Blocks<C> {
        self.blocks
    }
}

/// The residual r' − P(r' − ρ û') of a contact's smoothed law, and its derivatives with respect to the contact's force and velocity. The top of the
/// file explains the symbols.
fn contact<const C: usize>(
    force: &SVector<f64, C>,
    velocity: &SVector<f64, C>,
    mu: f64,
    (rho, tau): (f64, f64),
) -> (SVector<f64, C>, ContactBlock<C>, ContactBlock<C>) {
    let width = rho * tau;
    if mu == 0.0 {
        // Without friction the cone is a ray, and only the normal component of the residual involves the projection.
        let x = force[0] - rho * velocity[0];
        let (mut residual, mut by_force, mut by_velocity) =
            (*force, ContactBlock::identity(), ContactBlock::zeros());
        residual[0] -= smoothed(x, width);
        by_force[(0, 0)] -= slope(x, width);
        by_velocity[(0, 0)] = rho * slope(x, width);
        return (residual, by_force, by_velocity);
    }
    // The slip speed ‖u_T‖, smoothed near zero.
    let slip = tangent(velocity);
    let rounded = (tau / rho).sqrt();
    let speed = slip.norm().hypot(rounded);
    let mut dilated = *velocity;
    dilated[0] += mu * (speed - rounded);
    let mut dilation = ContactBlock::identity();
    for k in 1..C {
        dilation[(0, k)] = mu * slip[k] / speed;
    }
    let (mut scale, mut inverse) = (ContactBlock::identity(), ContactBlock::identity());
    (scale[(0, 0)], inverse[(0, 0)]) = (mu, 1.0 / mu);
    let scaled = scale * force;
    let (projected, change) = projection(&(scaled - inverse * dilated * rho), width);
    (scaled - projected, scale - change * scale, change * inverse * dilation * rho)
}

/// The smoothed projection P of x onto the cone ‖x_T‖ ≤ x_N, and its derivative; `width` is the product ρ τ (see the top of the file).
fn projection<const C: usize>(x: &SVector<f64, C>, width: f64) -> (SVector<f64, C>, ContactBlock<C>) {
    let slip = tangent(x);
    let length = slip.norm();
    let mut along = slip / length;
    if length == 0.0 {
        along.fill(0.0);
        along[1] = 1.0;
    }
    let (most, least) = (x[0] + length, x[0] - length);
    let mean = 0.5 * (slope(most, width) + slope(least, width));
    let difference = 0.5 * (slope(most, width) - slope(least, width));
    let around =
        if most > least { (smoothed(most, width) - smoothed(least, width)) / (most - least) } else { mean };
    let mut projected = along * (0.5 * (smoothed(most, width) - smoothed(least, width)));
    projected[0] = 0.5 * (smoothed(most, width) + smoothed(least, width));
    let ahead = along * along.transpose();
    let mut change = tangent_block(&((ContactBlock::identity() - ahead) * around + ahead * mean));
    change[(0, 0)] = mean;
    for k in 1..C {
        (change[(0, k)], change[(k, 0)]) = (difference * along[k], difference * along[k]);
    }
    (projected, change)
}

/// The smoothed positive part φ(x), with the product ρ τ as `width` (see the top of the file). For negative x a second form of φ
/// avoids cancellation, so that small values of φ are accurate, too.
fn smoothed(x: f64, width: f64) -> f64 {
    let root = (x * x + 4.0 * width).sqrt();
    if x >= 0.0 { 0.5 * (x + root) } else { 2.0 * width / (root - x) }
}

fn slope(x: f64, width: f64) -> f64 {
    let root = (x * x + 4.0 * width).sqrt();
    if x >= 0.0 { 0.5 * (1.0 + x / root) } else { 2.0 * width / (root * (root - x)) }
}
