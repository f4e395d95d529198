//! Choice and order of the methods for a frictional contact problem: polygons in place of the cones, iterations over contacts, central path, proof
//! that no solution exists. The matrix W maps contact forces to velocities. An island is a set of contacts that W couples, directly or through other
//! contacts.

use super::approach::{IslandSolve, STARTS, Watcher};
use super::blocks::Blocks;
use super::islands::islands;
use super::polygons::Polygons;
use super::problem::FrictionProblem;
use super::progress::SolveProgress;
use super::settings::{MOST_CONE_FACETS, Settings};
use super::solution::Solution;
use super::tolerances::MOST_ROWS_FACETS_FIRST;
use crate::lcp::{BreakdownCause, Certificate, Outcome};
use crate::numerics::{IntoList, every_index};
use crate::prelude::*;
use core::ops::ControlFlow;
use nalgebra::DVector;

impl<const C: usize> FrictionProblem<C> {
    /// Finds forces and velocities that satisfy Coulomb's law, with the default [`Settings`].
    #[must_use]
    pub fn solve(&self) -> Outcome<Solution> {
        self.solve_with(&Settings::default())
    }

    /// Finds forces and velocities that satisfy Coulomb's law.
    ///
    /// | outcome | means |
    /// |---|---|
    /// | [`Solved`](Outcome::Solved) | the law is satisfied to the tolerance of the settings |
    /// | [`Infeasible`](Outcome::Infeasible) | no solution: whatever forces in the cones act, some contact approaches. `y` has a weight per contact, see [`Self::proves_infeasible`] |
    /// | [`NoBasis`](Outcome::NoBasis) | in the plane: no solution exists, since each combination of contact states of an island is excluded without rounding |
    /// | others | undecided. A [`Ray`](crate::lcp::Ray) is a ray of the complementarity problem of [`Self::facets`] |
    #[must_use]
    pub fn solve_with(&self, settings: &Settings) -> Outcome<Solution> {
        self.solve_watched(settings, &mut |_| ControlFlow::Continue(()))
    }

    /// Finds forces and velocities that satisfy Coulomb's law, with progress reports, for hundreds of contacts that take seconds. `watch` may stop
    /// the solve, for lack of time or because the forces are good enough. The outcome is then a breakdown, [`Stopped`](BreakdownCause::Stopped), and
    /// the best forces are the forces last reported to `watch`.
    ///
    /// ```
    /// use grasp_lcp::friction::{SolveProgress, Settings, SpatialContacts};
    /// use nalgebra::{DMatrix, DVector};
    /// use std::ops::ControlFlow;
    ///
    /// // Forty blocks in a row, each pushed down and against the next.
    /// let w = DMatrix::from_fn(120, 120, |i, j| [2.0, 0.0, 0.0, -0.5].get(i.abs_diff(j)).copied().unwrap_or(0.0));
    /// let q = DVector::from_fn(120, |i, _| [-1.0, 0.6, 0.0][i % 3]);
    /// let problem = SpatialContacts::new(w, q, vec![0.4; 40])?;
    /// let mut best = f64::INFINITY;
    /// let outcome = problem.solve_watched(&Settings::default(), &mut |progress: &SolveProgress<'_>| {
    ///     best = progress.residual;
    ///     ControlFlow::Continue(())
    /// });
    /// assert!(outcome.solution().is_some() && best <= 1e-12);
    /// # Ok::<(), grasp_lcp::friction::Error>(())
    /// ```
    #[must_use]
    pub fn solve_watched(
        &self,
        settings: &Settings,
        watch: &mut dyn FnMut(&SolveProgress<'_>) -> ControlFlow<()>,
    ) -> Outcome<Solution> {
        if let Err(cause) = settings.check() {
            return Outcome::Breakdown { pivots: 0, cause };
        }
        let blocks = Blocks::of(self);
        let islands = islands(&blocks);
        if let [_, _, ..] = islands[..] {
            return self.solve_islands(&islands, settings, watch);
        }
        let all: Vec<usize> = (0..self.len()).list();
        self.solve_island(&blocks, settings, (&all, watch))
    }

    /// Solves one island, a set of contacts that the matrix W couples. `names` has the indices of its contacts in the caller's problem, for progress
    /// reports.
    pub(super) fn solve_island<'a>(
        &'a self,
        blocks: &'a Blocks<C>,
        settings: &'a Settings,
        (names, watch): (&'a [usize], &'a mut Watcher<'_>),
    ) -> Outcome<Solution> {
        let rho = blocks.scales();
        if every_index(self.len(), &|i| self.q[C * i] >= 0.0) {
            let solved = self.checked_solution(DVector::zeros(self.q.len()), &rho, settings.tolerance);
            return solved
                .map_or(Outcome::Breakdown { pivots: 0, cause: BreakdownCause::Overflow }, Outcome::Solved);
        }
        let facets = if C == 2 { 2 } else { settings.facets.clamp(3, MOST_CONE_FACETS) };
        let rows = self.len() * (2 + facets);
        let mut polygons = Polygons::new(self, settings);
        let mut polygon = (rows <= MOST_ROWS_FACETS_FIRST).then(|| polygons.solve(settings.turns));
        let mut approach = IslandSolve::new(self, blocks, settings, (names, watch));
        match polygon.take_if(|outcome| self.is_known(outcome)) {
            Some(Outcome::Solved(solution)) if solution.residuals.max() > 0.1 * settings.tolerance => {
                // Solutions with residuals close to the tolerance are refined by further Newton steps: residuals that the caller sums in another
                // order might exceed the tolerance.
                let r = approach.polished(&solution.r);
                let polished = self.checked_solution(r, &rho, solution.residuals.max());
                let (pivots, steps) = (solution.pivots, solution.steps);
                let better = polished.map(|polished| Solution { pivots, steps, ..polished });
                return Outcome::Solved(better.unwrap_or(solution));
            }
            Some(known) => return self.proved(known),
            None => {}
        }
        for start in 0..settings.starts.min(STARTS.len()) {
            let mut converged = approach.run_start(start);
            if start == 0 && !converged && !approach.best.stopped {
                // The linear program for a proof of infeasibility costs the cube of the number of contacts, so it is solved for at most 200
                // contacts.
                if self.len() <= 200
                    && let Some(y) = self.certificate(&settings.lcp)
                {
                    return Outcome::Infeasible(Certificate::new(y, polygons.pivots));
                }
                converged = rows <= MOST_ROWS_FACETS_FIRST && approach.around_folds();
            }
            let (best, pivots) = (&approach.best, polygons.pivots);
            if converged
                && let Some(solution) = self.checked_solution(best.r.clone(), &rho, settings.tolerance)
            {
                let steps = polygons.steps + best.steps;
                return Outcome::Solved(Solution { pivots, steps, ..solution });
            }
            if best.stopped {
                let cause = BreakdownCause::Stopped { residual: best.residual, contact: best.worst };
                return Outcome::Breakdown { pivots, cause };
            }
        }
        // All other methods have failed. If the problem with polygons in place of the cones has not been tried yet, it is tried now. With more than
        // 600 rows polygons take many seconds, and are not tried.
        if polygon.is_none() && rows <= 600 {
            let last = polygons.solve(0);
            if self.is_known(&last) {
                return self.proved(last);
            }
            polygon = Some(last);
        }
        match polygon {
            // In the plane the polygon is the cone itself, so the outcome with polygons is the outcome of the problem.
            Some(polygon) if C == 2 => self.proved(polygon),
            _ => {
                let (residual, worst) = [polygons.least, (approach.best.residual, approach.best.worst)]
                    .into_iter()
                    .fold((f64::INFINITY, 0), |least, next| if next.0 < least.0 { next } else { least });
                let cause = BreakdownCause::NoConvergence { residual, contact: worst };
                Outcome::Breakdown { pivots: polygons.pivots, cause }
            }
        }
    }

    /// Whether the outcome of the problem with polygons also holds for the round cones. This is so for a checked solution, and for a proof that is
    /// valid for the round cones.
    fn is_known(&self, polygon: &Outcome<Solution>) -> bool {
        match polygon {
            Outcome::Solved(_) => true,
            Outcome::Infeasible(certificate) | Outcome::NearlyInfeasible(certificate) => {
                self.proves_infeasible(&certificate.y)
            }
            Outcome::NoBasis { .. } => C == 2,
            _ => false,
        }
    }

    /// The outcome of the problem with polygons, as the outcome of the problem with round cones. A proof that no solution exists stays a proof only
    /// if its certificate holds for the round cones, too; otherwise the outcome is `NearlyInfeasible`.
    fn proved(&self, polygon: Outcome<Solution>) -> Outcome<Solution> {
        match polygon {
            Outcome::Infeasible(certificate) | Outcome::NearlyInfeasible(certificate) => {
                if self.proves_infeasible(&certificate.y) {
                    Outcome::Infeasible(certificate)
                } else {
                    Outcome::NearlyInfeasible(certificate)
                }
            }
            other => other,
        }
    }
}
