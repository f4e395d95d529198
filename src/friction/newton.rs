//! Newton's method on the round cone for a few contacts, from forces near a solution. It solves the equations of
//! [`alart_curnier`](super::alart_curnier) as one dense system. The contact forces r cause the contact velocities u = W r + q, with the matrix W of
//! the problem and the velocities q without contact forces.

use super::alart_curnier::answer;
use super::problem::{FrictionProblem, part};
use super::tolerances::UNDETERMINED_FORCE;
use crate::numerics::tolerances::{FEW_ROUNDINGS, SOLVED_ROUNDING, SUFFICIENT_DECREASE};
use crate::numerics::{Reals, add_times, dot, increasing, mapped, numbered, summed};
use crate::prelude::*;
use nalgebra::{DMatrix, DVector, SMatrix};

/// An iterate of Newton's method: forces of all contacts, and the residuals at these forces.
#[derive(Debug, Clone)]
struct Iterate<const C: usize> {
    r: DVector<f64>,
    /// The residual r − Π(ζ) of the law r = Π(ζ), with the forces r, the velocities u and ζ = r − ρ u. The map Π takes ζ to the force of the contact
    /// (see `alart_curnier`).
    residual: DVector<f64>,
    /// Derivative of each contact's return map Π, from the trial value ζ to the force, with respect to ζ.
    changes: Vec<SMatrix<f64, C, C>>,
    /// Norm √(Σ ‖·‖² / ρ) of the residual, summed over all contacts; ρ converts velocities to forces.
    size: f64,
    /// Norm of the terms whose differences are the residual: the forces r and the scaled velocities ρ u. It has the same weights 1/ρ as `size`.
    terms: f64,
}

/// Newton's method for one frictional contact problem.
pub(super) struct Newton<'a, const C: usize> {
    problem: &'a FrictionProblem<C>,
    /// The factor ρ of each contact that converts velocities to forces: the inverse of the largest entry of its diagonal block of the matrix W.
    pub(super) rho: Vec<f64>,
}

impl<'a, const C: usize> Newton<'a, C> {
    pub(super) fn new(problem: &'a FrictionProblem<C>) -> Self {
        let rho = |i: usize| {
            let own = problem.w.fixed_view::<C, C>(C * i, C * i).amax();
            let any = problem.w.rows(C * i, C).amax();
            let size = if own > 0.0 { own } else { any };
            if size > 0.0 { 1.0 / size } else { 1.0 }
        };
        Self { problem, rho: numbered(problem.len(), &rho) }
    }

    /// Newton's method from the forces r, until the residual is at the level of rounding errors or `steps` steps are made. Returns the last forces,
    /// converged or not, and the number of steps made.
    pub(super) fn run(&self, r: DVector<f64>, steps: usize) -> (DVector<f64>, usize) {
        let mut point = self.iterate_at(r);
        let mut made = 0;
        while made < steps && point.size > FEW_ROUNDINGS * point.terms {
            let Some(step) = self.step(&point) else { break };
            made += 1;
            let mut part = 1.0;
            let mut next = self.iterate_at(&point.r + &step);
            // Shortest fraction of a Newton step that the line search tries.
            let shortest = 1e-3;
            while next.size > (1.0 - SUFFICIENT_DECREASE * part) * point.size && part > shortest {
                part *= 0.5;
                next = self.iterate_at(&point.r + &step * part);
            }
            if part <= shortest {
                if point.size <= SOLVED_ROUNDING * point.terms {
                    // The line search has failed: no fraction of the step reduces the residual enough. Since the residual is at the level of rounding
                    // errors, Newton's method ends.
                    break;
                }
                next = self.iterate_at(&point.r + &step);
            }
            point = next;
        }
        (point.r, made)
    }

    fn iterate_at(&self, r: DVector<f64>) -> Iterate<C> {
        let u = self.problem.velocities(&r);
        let mut residual = r.clone();
        let mut changes = Vec::with_capacity(self.problem.len());
        let (mut size, mut terms) = (0.0, 0.0);
        for (i, rho) in self.rho.iter().enumerate() {
            let (force, velocity) = (part::<C>(&r, i), part::<C>(&u, i));
            let (answer, change) = answer(&(force - velocity * *rho), self.problem.mu[i]);
            let left = force - answer;
            size += left.norm_squared() / rho;
            terms += force.norm_squared() / rho + velocity.norm_squared() * rho;
            residual.fixed_rows_mut::<C>(C * i).copy_from(&left);
            changes.push(change);
        }
        Iterate { r, residual, changes, size: size.sqrt(), terms: terms.sqrt() }
    }

    /// The Newton step. Forces that the equations do not determine, such as those of redundant contacts, do not change in it. `None` if the step is
    /// not finite.
    fn step(&self, point: &Iterate<C>) -> Option<DVector<f64>> {
        let size = point.r.len();
        let mut jacobian = DMatrix::zeros(size, size);
        for (i, change) in point.changes.iter().enumerate() {
            // The Jacobian of the residual r − Π(r − ρ (W r + q)) with respect to the forces r, row by row; `change` is the derivative of Π.
            for a in 0..C {
                for column in 0..size {
                    let row = (0..C).map(|b| change[(a, b)] * self.problem.w[(C * i + b, column)]);
                    jacobian[(C * i + a, column)] = row.added() * self.rho[i];
                }
                for b in 0..C {
                    let unchanged = if a == b { 1.0 } else { 0.0 };
                    jacobian[(C * i + a, C * i + b)] += unchanged - change[(a, b)];
                }
            }
        }
        let step = least_squares(&jacobian, -&point.residual);
        step.iter().all(|x| x.is_finite()).then_some(step)
    }
}

/// Least-squares solution x of A x ≈ b by Gram–Schmidt orthogonalisation of the columns of A, the longest remaining column first. Unknowns that A
/// does not determine are zero.
fn least_squares(a: &DMatrix<f64>, mut b: DVector<f64>) -> DVector<f64> {
    let size = b.len();
    let mut columns: Vec<Vec<f64>> = numbered(size, &|j| a.as_slice()[size * j..][..size].to_vec());
    // Column j of `products` has the dot products of column j of A with the orthonormal vectors found so far; `parts` has the products of b with
    // these vectors.
    let (mut products, mut parts) = (DMatrix::zeros(size, size), Vec::new());
    let (mut open, mut order, mut largest): (Vec<usize>, Vec<usize>, f64) =
        (numbered(size, &|j| j), vec![], 0.0);
    while !open.is_empty() {
        let squares: Vec<f64> = mapped(&open, &|j| dot(&columns[*j], &columns[*j]));
        let longest = increasing(&squares)[open.len() - 1];
        let (j, length) = (open.swap_remove(longest), squares[longest].sqrt());
        largest = largest.max(length);
        if length <= UNDETERMINED_FORCE * largest || length.is_nan() {
            break;
        }
        let unit = mapped(&columns[j], &|x| x / length);
        let project = |vector: &mut [f64]| {
            let product = dot(&unit, vector);
            add_times(vector, &unit, -product);
            product
        };
        for i in &open {
            products[(order.len(), *i)] = project(&mut columns[*i]);
        }
        products[(order.len(), j)] = length;
        parts.push(project(b.as_mut_slice()));
        order.push(j);
    }
    let mut x = DVector::zeros(size);
    for (k, j) in order.iter().enumerate().rev() {
        let later = summed(&order[k + 1..], &|i| products[(k, *i)] * x[*i]);
        x[*j] = (parts[k] - later) / products[(k, *j)];
    }
    x
}
