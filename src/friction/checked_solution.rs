//! Acceptance of forces as a solution, after removal of rounding errors. For contact forces r the velocities of the contacts are u = W r + q, where q
//! are the velocities without contact forces.

use super::law::{ContactMode, projection, tangent};
use super::problem::{FrictionProblem, part};
use super::solution::Solution;
use super::tolerances::OUTSIDE_CONE;
use crate::lcp::tolerances::{BACKWARD_ERROR, LOST};
use crate::numerics::tolerances::{FEW_ROUNDINGS, NEGLIGIBLE};
use crate::numerics::{numbered, total};
use crate::prelude::*;
use nalgebra::{DVector, SVector};

impl<const C: usize> FrictionProblem<C> {
    /// Removes rounding errors from the forces r: forces of open contacts become zero, and forces just outside a cone are moved onto its boundary.
    /// `u` has the velocities of the contacts; the factor ρ of each contact converts velocities to forces.
    pub(super) fn snapped_to_cones(
        &self,
        mut r: DVector<f64>,
        u: &DVector<f64>,
        rho: &[f64],
    ) -> DVector<f64> {
        for (i, rho) in rho.iter().enumerate() {
            let (force, velocity): (SVector<f64, C>, SVector<f64, C>) = (part(&r, i), part(u, i));
            if Self::state(&force, &velocity, self.mu[i], *rho) == ContactMode::Open {
                r.fixed_rows_mut::<C>(C * i).fill(0.0);
                continue;
            }
            let (size, most) = (tangent(&force).norm(), self.mu[i] * force[0]);
            let nearest = projection(&force, self.mu[i]);
            if size > most && (force - nearest).norm() <= NEGLIGIBLE * force.norm() {
                let (size, most) = (tangent(&nearest).norm(), self.mu[i] * nearest[0]);
                let within = if size > most { most / size } else { 1.0 };
                r[C * i] = nearest[0];
                for k in 1..C {
                    r[C * i + k] = nearest[k] * within;
                }
            }
        }
        r
    }

    /// The solution with the forces r, after forces of open contacts are set to zero and, if needed, forces are moved onto their cones. `None` if a
    /// residual of the solution exceeds `tolerance`, or if q is smaller than the rounding error of W r.
    pub(super) fn checked_solution(
        &self,
        mut r: DVector<f64>,
        rho: &[f64],
        tolerance: f64,
    ) -> Option<Solution> {
        let states = |r: &DVector<f64>| -> Vec<ContactMode> {
            let u = self.velocities(r);
            let state = |i| Self::state(&part(r, i), &part(&u, i), self.mu[i], rho[i]);
            numbered(self.len(), &state)
        };
        let found = states(&r);
        for (i, _) in found.iter().enumerate().filter(|(_, state)| **state == ContactMode::Open) {
            r.fixed_rows_mut::<C>(C * i).fill(0.0);
        }
        let mut residuals = self.residuals(&r);
        let mut found = found;
        if !residuals.within(tolerance) || self.leaves_cones(&r) {
            r = self.without_noise(self.snapped_to_cones(r.clone(), &self.velocities(&r), rho));
            residuals = self.residuals(&r);
            found = states(&r);
        }
        if !residuals.within(tolerance) {
            return None;
        }
        // Forces are rejected if the terms of W r exceed q by many orders of magnitude. These terms then cancel, and their rounding error hides q. If
        // q were any other vector of this magnitude, the same forces would pass the check, too.
        let terms = (self.w.abs() * r.abs()).amax();
        if residuals.max() > FEW_ROUNDINGS && residuals.max() * terms > BACKWARD_ERROR * self.q.amax()
            || terms > 0.0 && self.q.amax() <= LOST * terms
        {
            return None;
        }
        let u = self.velocities(&r);
        Some(Solution { r, u, states: found, residuals, pivots: 0, steps: 0 })
    }

    /// Whether some contact's friction exceeds its limit, μ times its normal force, by more than rounding. The residual of the cone does not show
    /// this: it is relative to the whole force. If μ is large, it may be small although the excess is large relative to the normal force.
    fn leaves_cones(&self, r: &DVector<f64>) -> bool {
        (0..self.len()).any(|i| {
            let force: SVector<f64, C> = part(r, i);
            tangent(&force).norm() > (1.0 + OUTSIDE_CONE) * self.mu[i] * force[0]
        })
    }

    /// The forces r, without forces that are too small to matter. A contact's force is set to zero if it changes every velocity by less than the
    /// rounding error of that velocity.
    fn without_noise(&self, mut r: DVector<f64>) -> DVector<f64> {
        let terms = self.w.abs() * r.abs() + self.q.abs();
        for i in 0..self.len() {
            let force = part::<C>(&r, i).abs();
            let columns = self.w.columns(C * i, C);
            let unseen = |(row, terms): (usize, &f64)| {
                total(C, &|k| columns[(row, k)].abs() * force[k]) <= FEW_ROUNDINGS * terms
            };
            if columns.iter().any(|w| *w != 0.0) && terms.iter().enumerate().all(unseen) {
                r.fixed_rows_mut::<C>(C * i).fill(0.0);
            }
        }
        r
    }
}
