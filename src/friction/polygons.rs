//! Solves a frictional contact problem of a few contacts, first with polygonal cones and then with round cones.
//!
//! The polygonal cones, "polygons" for short, have plane facets, so that the problem is a linear complementarity problem. Lemke's method solves it,
//! and Newton's method on the round cones starts from its forces. If Newton's method does not converge, the facets are rotated towards the slip
//! directions, and their number increases.

use super::facets::{FacetedProblem, Facets};
use super::law::tangent;
use super::newton::Newton;
use super::problem::{FrictionProblem, part};
use super::settings::{MOST_CONE_FACETS, Settings};
use super::solution::Solution;
use crate::lcp::{BreakdownCause, Certificate, Outcome};
use crate::prelude::*;
use nalgebra::{DVector, SVector};

/// The search for forces on the round cone that starts from polygons. It has the angles of the facets, and the numbers of pivots and Newton steps. It
/// also has the smallest residual after a run of Newton's method.
pub(super) struct Polygons<'a, const C: usize> {
    problem: &'a FrictionProblem<C>,
    newton: Newton<'a, C>,
    settings: &'a Settings,
    /// Angle of the first facet direction of each contact, rad.
    angles: Vec<f64>,
    pub(super) pivots: usize,
    pub(super) steps: usize,
    /// The largest residual over all contacts, and the index (from 0) of its contact, at the end of the best run of Newton's method so far. Infinite
    /// before the first run.
    pub(super) least: (f64, usize),
}

impl<'a, const C: usize> Polygons<'a, C> {
    pub(super) fn new(problem: &'a FrictionProblem<C>, settings: &'a Settings) -> Self {
        Self {
            problem,
            newton: Newton::new(problem),
            settings,
            angles: vec![0.0; problem.len()],
            pivots: 0,
            steps: 0,
            least: (f64::INFINITY, 0),
        }
    }

    /// A solution or, if no try finds a solution, the outcome of the first try. After a failure the facets of each contact are rotated and 1.5 times
    /// as many are used, up to `restarts` times. In the plane there is only one try.
    pub(super) fn solve(&mut self, restarts: usize) -> Outcome<Solution> {
        let mut count = self.settings.facets.clamp(3, MOST_CONE_FACETS);
        let mut first = None;
        for restart in 0..=if C == 2 { 0 } else { restarts } {
            match self.by_facets(count, restart == 0) {
                Outcome::Solved(solution) => return Outcome::Solved(solution),
                unsolved => first = first.or(Some(unsolved)),
            }
            count = (count + count / 2).min(MOST_CONE_FACETS);
        }
        first.unwrap_or_else(|| self.no_convergence())
    }

    /// One try: solves the problem with polygons of `count` facets, and starts Newton's method from the forces of this solution. If the polygons give
    /// no solution and `from_zero` is set, Newton's method starts from zero forces; in the plane it does not.
    fn by_facets(&mut self, count: usize, from_zero: bool) -> Outcome<Solution> {
        let Ok(polygon) = self.problem.polygon(Facets::regular(count, &self.angles)) else {
            return Outcome::Breakdown { pivots: self.pivots, cause: BreakdownCause::Overflow };
        };
        let outcome = polygon.lcp.solve_with(&self.settings.lcp).and_then(|solution| {
            self.pivots += solution.pivots;
            match polygon.forces(&solution.z) {
                Ok(forces) => self.solution_from(forces),
                Err(_) => self.no_convergence(),
            }
        });
        if outcome.solution().is_some() || C == 2 || !from_zero {
            return weighed(outcome, &polygon);
        }
        match self.solution_from(DVector::zeros(self.problem.q.len())) {
            Outcome::Solved(solution) => Outcome::Solved(solution),
            _ => weighed(outcome, &polygon),
        }
    }

    /// Accepts the forces `start` as a solution, or the forces at which Newton's method from `start` ends. Without a solution the outcome is
    /// `NoConvergence`. In any case the facets are rotated for the next polygon.
    fn solution_from(&mut self, start: DVector<f64>) -> Outcome<Solution> {
        self.rotate_facets(&start);
        if let Some(solution) = self.checked_solution(start.clone()) {
            return Outcome::Solved(solution);
        }
        let (r, steps) = self.newton.run(start, self.settings.steps);
        self.steps += steps;
        let (residuals, worst) = self.problem.worst_residuals(&r);
        if residuals.max() < self.least.0 {
            self.least = (residuals.max(), worst);
        }
        match self.checked_solution(r) {
            Some(solution) => Outcome::Solved(solution),
            None => self.no_convergence(),
        }
    }

    fn checked_solution(&self, r: DVector<f64>) -> Option<Solution> {
        let solution = self.problem.checked_solution(r, &self.newton.rho, self.settings.tolerance)?;
        Some(Solution { pivots: self.pivots, steps: self.steps, ..solution })
    }

    /// Rotates the facets of each contact that moves tangentially under the forces r, so that its first facet direction opposes its slip.
    fn rotate_facets(&mut self, r: &DVector<f64>) {
        let u = self.problem.velocities(r);
        for (i, angle) in self.angles.iter_mut().enumerate() {
            let slip: SVector<f64, C> = tangent(&part(&u, i));
            if slip.norm() > 0.0 {
                *angle = (-slip[C - 1]).atan2(-slip[1]);
            }
        }
    }

    fn no_convergence(&self) -> Outcome<Solution> {
        let (residual, contact) = self.least;
        Outcome::Breakdown { pivots: self.pivots, cause: BreakdownCause::NoConvergence { residual, contact } }
    }
}

/// Converts a certificate, a vector that proves that the problem has no solution, from one weight for each row to one weight for each contact. The
/// problem with polygons has several rows for each contact; the weight of the normal row is taken. Other outcomes are returned unchanged.
fn weighed<const C: usize>(outcome: Outcome<Solution>, polygon: &FacetedProblem<C>) -> Outcome<Solution> {
    let weigh =
        |certificate: Certificate| Certificate::new(polygon.normals(&certificate.y), certificate.pivots);
    match outcome {
        Outcome::Infeasible(certificate) => Outcome::Infeasible(weigh(certificate)),
        Outcome::NearlyInfeasible(certificate) => Outcome::NearlyInfeasible(weigh(certificate)),
        other => other,
    }
}
