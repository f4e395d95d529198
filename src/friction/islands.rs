//! Islands: sets of contacts that the matrix W couples, directly or through other contacts. Each island is a separate problem.

use super::approach::Watcher;
use super::blocks::Blocks;
use super::law::ContactMode;
use super::problem::FrictionProblem;
use super::settings::Settings;
use super::solution::Solution;
use crate::lcp::{BreakdownCause, Certificate, Outcome};
use crate::numerics::{mapped, matrix_of, vector_of};
use crate::prelude::*;
use nalgebra::DVector;

/// The islands of a problem as sorted lists of contact indices, ordered by their first contact.
pub(super) fn islands<const C: usize>(blocks: &Blocks<C>) -> Vec<Vec<usize>> {
    let n = blocks.len();
    let mut near = vec![Vec::new(); n];
    for i in 0..n {
        for (j, _) in blocks.off_diagonal(i) {
            // If W couples contact i to contact j only in one direction (W need not be symmetric), they are in one island, too.
            near[i].push(*j);
            near[*j].push(i);
        }
    }
    let mut visited = vec![false; n];
    let mut islands = Vec::new();
    for first in 0..n {
        if core::mem::replace(&mut visited[first], true) {
            continue;
        }
        let mut island = vec![first];
        let mut next = 0;
        while next < island.len() {
            for j in &near[island[next]] {
                if !core::mem::replace(&mut visited[*j], true) {
                    island.push(*j);
                }
            }
            next += 1;
        }
        island.sort_unstable();
        islands.push(island);
    }
    islands
}

impl<const C: usize> FrictionProblem<C> {
    /// The problem of the given contacts alone: their rows and columns of W, and their entries of q and μ.
    pub(super) fn of_contacts(&self, contacts: &[usize]) -> Self {
        let component = |k: usize| C * contacts[k / C] + k % C;
        let size = C * contacts.len();
        Self {
            w: matrix_of(size, size, &|i, j| self.w[(component(i), component(j))]),
            q: vector_of(size, &|i| self.q[component(i)]),
            mu: mapped(contacts, &|i| self.mu[*i]),
        }
    }

    /// Solves all islands and combines their solutions. If an island is proved to have no solution, or the caller's function `watch` stops the solve,
    /// this outcome is returned at once. If islands fail in another way, the outcome of the first of them is returned after all have been tried.
    pub(super) fn solve_islands(
        &self,
        islands: &[Vec<usize>],
        settings: &Settings,
        watch: &mut Watcher<'_>,
    ) -> Outcome<Solution> {
        let n = self.len();
        let mut r = DVector::zeros(self.q.len());
        let mut states = vec![ContactMode::Open; n];
        let (mut pivots, mut steps, mut unsolved) = (0, 0, None);
        for island in islands {
            let alone = self.of_contacts(island);
            match alone.solve_island(&Blocks::of(&alone), settings, (island, watch)) {
                Outcome::Solved(solution) => {
                    for (k, i) in island.iter().enumerate() {
                        r.rows_mut(C * i, C).copy_from(&solution.r.rows(C * k, C));
                        states[*i] = solution.states[k];
                    }
                    (pivots, steps) = (pivots + solution.pivots, steps + solution.steps);
                }
                Outcome::Infeasible(certificate) => {
                    return Outcome::Infeasible(extend_to_all(&certificate, island, n));
                }
                Outcome::NoBasis { pivots } => return Outcome::NoBasis { pivots },
                Outcome::NearlyInfeasible(certificate) => {
                    unsolved =
                        unsolved.or(Some(Outcome::NearlyInfeasible(extend_to_all(&certificate, island, n))));
                }
                Outcome::Breakdown { pivots, cause: BreakdownCause::Stopped { residual, contact } } => {
                    let cause = BreakdownCause::Stopped { residual, contact: island[contact] };
                    return Outcome::Breakdown { pivots, cause };
                }
                Outcome::Breakdown { pivots, cause: BreakdownCause::NoConvergence { residual, contact } } => {
                    let cause = BreakdownCause::NoConvergence { residual, contact: island[contact] };
                    unsolved = unsolved.or(Some(Outcome::Breakdown { pivots, cause }));
                }
                // Lemke's method has ended on a ray: a half-line of points of this island's complementarity problem. The points have no entries for
                // other islands, so they are no ray of the whole problem, and its outcome is `NoConvergence`.
                Outcome::Ray(ray) => {
                    let cause = BreakdownCause::NoConvergence { residual: f64::INFINITY, contact: island[0] };
                    unsolved = unsolved.or(Some(Outcome::Breakdown { pivots: ray.pivots, cause }));
                }
                other => unsolved = unsolved.or(Some(other)),
            }
        }
        if let Some(unsolved) = unsolved {
            return unsolved;
        }
        let (u, residuals) = (self.velocities(&r), self.residuals(&r));
        Outcome::Solved(Solution { r, u, states, residuals, pivots, steps })
    }
}

/// The certificate (proof that no solution exists) of an island as a certificate of the whole problem: the weights of all other contacts are zero.
fn extend_to_all(certificate: &Certificate, island: &[usize], n: usize) -> Certificate {
    let mut y = DVector::zeros(n);
    for (weight, i) in certificate.y.iter().zip(island) {
        y[*i] = *weight;
    }
    Certificate::new(y, certificate.pivots)
}
