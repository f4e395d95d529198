//! Forces that are called a solution.

use super::law::{ContactMode, projection, tangent};
use super::problem::{FrictionProblem, part};
use super::solution::Solution;
use crate::prelude::*;
use nalgebra::{DVector, SVector};

/// Residuals up to this are rounding.
const ROUNDING: f64 = 1e-15;
/// Above it the velocities that the law misses may be this part of the largest of q.
const KNOWN: f64 = 1e-6;
/// Below this part of the terms of W r the largest q is lost in them.
const LOST: f64 = 1e-11;
/// A force is noise if it is no more than this part of the terms of any row.
const NOISE: f64 = 2.0 * f64::EPSILON;
/// A force this far outside of its cone, as part of it, is on its edge but for rounding.
const ON_EDGE: f64 = 1e-9;

/// Friction is visibly larger than μ r_N by this part of it.
const VISIBLE: f64 = 1e-13;

impl<const C: usize> FrictionProblem<C> {
    /// These forces without what is left on open contacts, which is noise, and with those on the edge of a cone exactly there. u are their velocities,
    /// ρ says how force and velocity of a contact compare.
    pub(super) fn tidied(&self, mut r: DVector<f64>, u: &DVector<f64>, rho: &[f64]) -> DVector<f64> {
        for (i, rho) in rho.iter().enumerate() {
            let (force, velocity): (SVector<f64, C>, SVector<f64, C>) = (part(&r, i), part(u, i));
            if Self::state(&force, &velocity, self.mu[i], *rho) == ContactMode::Open {
                r.fixed_rows_mut::<C>(C * i).fill(0.0);
                continue;
            }
            let (size, most) = (tangent(&force).norm(), self.mu[i] * force[0]);
            let nearest = projection(&force, self.mu[i]);
            if size > most && (force - nearest).norm() <= ON_EDGE * force.norm() {
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

    /// These forces as a solution, if they are one to this tolerance.
    pub(super) fn settled(&self, mut r: DVector<f64>, rho: &[f64], tolerance: f64) -> Option<Solution> {
        let states = |r: &DVector<f64>| -> Vec<ContactMode> {
            let u = self.velocities(r);
            let state = |i| Self::state(&part(r, i), &part(&u, i), self.mu[i], rho[i]);
            (0..self.len()).map(state).collect()
        };
        let found = states(&r);
        for (i, _) in found.iter().enumerate().filter(|(_, state)| **state == ContactMode::Open) {
            r.fixed_rows_mut::<C>(C * i).fill(0.0);
        }
        let mut residuals = self.residuals(&r);
        let mut found = found;
        if !residuals.within(tolerance) || self.leaves_cones(&r) {
            r = self.without_noise(self.tidied(r.clone(), &self.velocities(&r), rho));
            residuals = self.residuals(&r);
            found = states(&r);
        }
        if !residuals.within(tolerance) {
            return None;
        }
        // Beside forces without bound q is lost, and any would do.
        let terms = (self.w.abs() * r.abs()).amax();
        if residuals.max() > ROUNDING && residuals.max() * terms > KNOWN * self.q.amax()
            || terms > 0.0 && self.q.amax() <= LOST * terms
        {
            return None;
        }
        let u = self.velocities(&r);
        Some(Solution { r, u, states: found, residuals, pivots: 0, steps: 0 })
    }

    /// Whether friction is visibly larger than cones allow. Of steep cones that is little beside the force, and much beside its normal component.
    fn leaves_cones(&self, r: &DVector<f64>) -> bool {
        (0..self.len()).any(|i| {
            let force: SVector<f64, C> = part(r, i);
            tangent(&force).norm() > (1.0 + VISIBLE) * self.mu[i] * force[0]
        })
    }

    /// These forces without those that no row would miss.
    fn without_noise(&self, mut r: DVector<f64>) -> DVector<f64> {
        let terms = self.w.abs() * r.abs() + self.q.abs();
        for i in 0..self.len() {
            let force = part::<C>(&r, i).abs();
            let columns = self.w.columns(C * i, C);
            let unseen = |(row, terms): (usize, &f64)| {
                (0..C).map(|k| columns[(row, k)].abs() * force[k]).sum::<f64>() <= NOISE * terms
            };
            if columns.iter().any(|w| *w != 0.0) && terms.iter().enumerate().all(unseen) {
                r.fixed_rows_mut::<C>(C * i).fill(0.0);
            }
        }
        r
    }
}
