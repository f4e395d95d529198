//! The central path of a few contacts, followed around its folds.
//!
//! The [`central_path`](super::central_path) leads through the interior of the friction cones to a solution as its parameter τ tends to zero.
//! Friction folds it: where contacts wedge, τ must increase again before it decreases. Forces and ln τ together are therefore followed by arc length,
//! for which a fold is an ordinary point (H. B. Keller, Numerical solution of bifurcation and nonlinear eigenvalue problems, 1977). The path starts
//! far inside the cones, where the solution is unique. Let the matrix W, which maps contact forces to velocities, be positive definite. The path then
//! ends at a solution of the problem, unless it meets another path or diverges.

use super::blocks::Blocks;
use super::central_path::{Smoothed, scales};
use super::equations::{Equations, IterationLimits, descend};
use super::problem::{FrictionProblem, part};
use super::tolerances::ON_CENTRAL_PATH;
use crate::numerics::{IntoList, Reals, total, vector_of};
use crate::prelude::*;
use nalgebra::{DMatrix, DVector};

/// Upper limit of the number of Newton corrections per step along the central path. If at most half of this number was needed, the next step is
/// longer.
const MOST_FOLD_CORRECTIONS: usize = 6;

/// Follows the central path around its folds. Returns the forces at the end of the path, or at the point of the path where steps become too short or
/// too many. `None` if no starting point or no tangent is found.
pub(super) fn around_folds<const C: usize>(
    problem: &FrictionProblem<C>,
    blocks: &Blocks<C>,
) -> Option<DVector<f64>> {
    let rho = scales(problem, blocks);
    let path = Path { problem, blocks, rho: &rho };
    let q = (0..problem.len()).map(|i| part::<C>(&problem.q, i).norm_squared() * rho[i]);
    let energy = q.added() / problem.len() as f64;
    let mut x = path.starting_point(energy)?;
    let end = (1e-18 * energy).ln();
    let size = x.len() - 1;
    let mut tangent = DVector::zeros(size + 1);
    tangent[size] = -1.0;
    let mut length = 0.1;
    for _ in 0..1000 {
        if x[size] <= end {
            break;
        }
        let measure = path.measure(&x);
        let ahead = path.tangent(&x, &tangent, &measure)?;
        // Length of the shortest step along the path; if a shorter step is needed, the path ends. A step of length 1 changes the forces by about
        // their own magnitude, or ln τ by 1.
        let shortest = 1e-7;
        while length >= shortest {
            let next = path.corrected(&x + &ahead * length, &ahead, &measure);
            let onward = next.and_then(|(next, corrections)| {
                let then = path.tangent(&next, &ahead, &measure)?;
                // The step is shortened if the tangent of the path turns by more than 45° in it.
                (then.dot(&ahead.component_mul(&measure)) >= 0.7).then_some((next, corrections))
            });
            if let Some((next, corrections)) = onward {
                x = next;
                if 2 * corrections <= MOST_FOLD_CORRECTIONS {
                    // Few corrections were needed, so the next step is longer. A step of length 1, the longest, changes the forces by about their own
                    // magnitude, or τ by a factor e.
                    length = (1.5 * length).min(1.0);
                }
                break;
            }
            length *= 0.3;
        }
        if length < shortest {
            return Some(x.rows(0, size).into_owned());
        }
        tangent = ahead;
    }
    Some(x.rows(0, size).into_owned())
}

struct Path<'a, const C: usize> {
    problem: &'a FrictionProblem<C>,
    blocks: &'a Blocks<C>,
    rho: &'a [f64],
}

impl<const C: usize> Path<'_, C> {
    /// Forces, followed by the logarithm of the path's parameter τ, at the starting point of the path, far inside the cones. `None` if Newton's
    /// method does not reach the path.
    fn starting_point(&self, energy: f64) -> Option<DVector<f64>> {
        let size = self.problem.q.len();
        // The initial τ is a million times `energy`, the mean of ρ_i ‖q_i‖² over the contacts. Here q_i is the velocity of contact i without contact
        // forces, and ρ_i converts it to a force. With so large a τ the path is far inside the cones, where Newton's method finds its point.
        let tau = 1e6 * energy;
        let mut x = DVector::zeros(size + 1);
        for i in 0..self.problem.len() {
            x[C * i] = (tau * self.rho[i]).sqrt();
        }
        x[size] = tau.ln();
        let order: Vec<usize> = (0..self.problem.len()).list();
        let far = Smoothed { problem: self.problem, blocks: self.blocks, rho: self.rho, tau };
        let enough = ON_CENTRAL_PATH * (self.problem.len() as f64 * tau).sqrt();
        let patience = IterationLimits { steps: 200, enough, rounding: 0.0, shortest: 1e-6, leaps: 0 };
        let (point, _) = descend(&far, &order, x.rows(0, size).into_owned(), patience);
        x.rows_mut(0, size).copy_from(&point.r);
        (point.size <= enough).then_some(x)
    }

    /// The equations at a point x (the forces, then ln τ). Returns their residuals, and the root mean square of these residuals divided by √τ. Also
    /// returns the derivatives of the residuals with respect to forces and ln τ.
    fn residual_and_derivatives(&self, x: &DVector<f64>) -> (DVector<f64>, f64, DMatrix<f64>) {
        let size = x.len() - 1;
        let r = x.rows(0, size).into_owned();
        let at =
            |log: f64| Smoothed { problem: self.problem, blocks: self.blocks, rho: self.rho, tau: log.exp() };
        let point = at(x[size]).at(r.clone());
        let mut change = DMatrix::zeros(size + 1, size + 1);
        for i in 0..self.problem.len() {
            let mut put = |j: usize, block| change.fixed_view_mut::<C, C>(C * i, C * j).copy_from(&block);
            put(i, point.by_force[i] + point.by_velocity[i] * self.blocks.diagonal(i));
            for (j, w) in self.blocks.off_diagonal(i) {
                put(*j, point.by_velocity[i] * w);
            }
        }
        // Derivative with respect to ln τ, by central differences.
        let nudge = 1e-5;
        let (more, less) = (at(x[size] + nudge).at(r.clone()), at(x[size] - nudge).at(r));
        let by_log = (more.residual - less.residual) / (2.0 * nudge);
        change.view_mut((0, size), (size, 1)).copy_from(&by_log);
        let mut residual = point.residual.insert_row(size, 0.0);
        residual[size] = 0.0;
        let near = point.size / (self.problem.len() as f64 * x[size].exp()).sqrt();
        (residual, near, change)
    }

    /// Diagonal of the metric in which steps along the path are measured. A change of ln τ counts as it is; a change of the forces counts relative to
    /// the magnitude of the forces at x.
    fn measure(&self, x: &DVector<f64>) -> DVector<f64> {
        let size = x.len() - 1;
        let energy = total(self.problem.len(), &|i| x.rows(C * i, C).norm_squared() / self.rho[i]);
        vector_of(size + 1, &|k| if k == size { 1.0 } else { 1.0 / (self.rho[k / C] * energy) })
    }

    /// The unit tangent of the path, oriented like the previous tangent `before`. Its length is one in the metric `measure`. `None` if the equations
    /// are singular.
    fn tangent(
        &self,
        x: &DVector<f64>,
        before: &DVector<f64>,
        measure: &DVector<f64>,
    ) -> Option<DVector<f64>> {
        let size = x.len() - 1;
        let (_, _, mut change) = self.residual_and_derivatives(x);
        let weighed = before.component_mul(measure);
        change.row_mut(size).copy_from(&weighed.transpose());
        let mut rhs = DVector::zeros(size + 1);
        rhs[size] = 1.0;
        let tangent = change.lu().solve(&rhs)?;
        let length = tangent.dot(&tangent.component_mul(measure)).sqrt();
        let tangent = tangent / length;
        tangent.iter().all(|x| x.is_finite()).then_some(tangent)
    }

    /// Moves x back to the path by Newton steps, within the hyperplane through x that is normal to `ahead`. Returns the point reached and the number
    /// of corrections, or `None` after more than [`MOST_FOLD_CORRECTIONS`] corrections.
    fn corrected(
        &self,
        mut x: DVector<f64>,
        ahead: &DVector<f64>,
        measure: &DVector<f64>,
    ) -> Option<(DVector<f64>, usize)> {
        let size = x.len() - 1;
        let weighed = ahead.component_mul(measure).transpose();
        for corrections in 0..=MOST_FOLD_CORRECTIONS {
            let (residual, near, mut change) = self.residual_and_derivatives(&x);
            if near <= ON_CENTRAL_PATH {
                return Some((x, corrections));
            }
            change.row_mut(size).copy_from(&weighed);
            x -= change.lu().solve(&residual)?;
            if !x.iter().all(|x| x.is_finite()) {
                return None;
            }
        }
        None
    }
}
