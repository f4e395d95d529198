//! From the polygon to the round cone.

use super::facets::{FacetedProblem, Facets};
use super::law::{ContactMode, tangent};
use super::newton::Newton;
use super::problem::{FrictionProblem, part};
use super::settings::{MOST_FACETS, Settings};
use super::solution::Solution;
use crate::lcp::{BreakdownCause, Certificate, Outcome};
use nalgebra::{DVector, SVector};

impl<const C: usize> FrictionProblem<C> {
    /// Forces and velocities that obey Coulomb's law, with the default [`Settings`].
    #[must_use]
    pub fn solve(&self) -> Outcome<Solution> {
        self.solve_with(&Settings::default())
    }

    /// Forces and velocities that obey Coulomb's law.
    ///
    /// | outcome | means |
    /// |---|---|
    /// | [`Solved`](Outcome::Solved) | the law holds, to the tolerance of the settings |
    /// | [`Infeasible`](Outcome::Infeasible) | whatever the forces some contacts approach: y has one weight for each contact, see [`Self::proves_infeasible`] |
    /// | [`NoBasis`](Outcome::NoBasis) | in the plane: each combination of states is excluded without rounding |
    /// | others | nothing is known. A [`Ray`](crate::lcp::Ray) is that of [`Self::facets`] |
    #[must_use]
    pub fn solve_with(&self, settings: &Settings) -> Outcome<Solution> {
        if let Err(cause) = settings.check() {
            return Outcome::Breakdown { pivots: 0, cause };
        }
        let mut attempt = Attempt {
            problem: self,
            newton: Newton::new(self),
            settings,
            angles: vec![0.0; self.len()],
            pivots: 0,
            steps: 0,
            least: f64::INFINITY,
        };
        if (0..self.len()).all(|i| self.q[C * i] >= 0.0) {
            let solved = attempt.settled(DVector::zeros(self.q.len()));
            return solved
                .map_or(Outcome::Breakdown { pivots: 0, cause: BreakdownCause::Overflow }, Outcome::Solved);
        }
        let mut count = settings.facets.clamp(3, MOST_FACETS);
        let mut first = None;
        for turn in 0..=if C == 2 { 0 } else { settings.turns } {
            match attempt.by_facets(count, turn == 0) {
                Outcome::Solved(solution) => return Outcome::Solved(solution),
                unsolved => first = first.or(Some(unsolved)),
            }
            count = (count + count / 2).min(MOST_FACETS);
        }
        attempt.none(first)
    }
}

/// Residuals up to this are rounding.
const ROUNDING: f64 = 1e-15;
/// Above it the velocities that the law misses may be this part of the largest of q.
const KNOWN: f64 = 1e-6;
/// Below this part of the terms of W r the largest q is lost in them.
const LOST: f64 = 1e-11;

/// What has been tried so far.
struct Attempt<'a, const C: usize> {
    problem: &'a FrictionProblem<C>,
    newton: Newton<'a, C>,
    settings: &'a Settings,
    /// Where the first facet of each contact lies.
    angles: Vec<f64>,
    pivots: usize,
    steps: usize,
    /// The least residual that Newton's method has reached.
    least: f64,
}

impl<const C: usize> Attempt<'_, C> {
    /// The forces of a polygon, or where Newton's method goes from them. Where the polygon has none it may set out from no force at all.
    fn by_facets(&mut self, count: usize, from_zero: bool) -> Outcome<Solution> {
        let Ok(polygon) = self.problem.polygon(Facets::regular(count, &self.angles)) else {
            return Outcome::Breakdown { pivots: self.pivots, cause: BreakdownCause::Overflow };
        };
        let outcome = polygon.lcp.solve_with(&self.settings.lcp).and_then(|solution| {
            self.pivots += solution.pivots;
            match polygon.forces(&solution.z) {
                Ok(forces) => self.goes_on(forces),
                Err(_) => self.missed(),
            }
        });
        if outcome.solution().is_some() || C == 2 || !from_zero {
            return weighed(outcome, &polygon);
        }
        match self.goes_on(DVector::zeros(self.problem.q.len())) {
            Outcome::Solved(solution) => Outcome::Solved(solution),
            _ => weighed(outcome, &polygon),
        }
    }

    /// These forces if they solve the problem, or where Newton's method goes from them.
    fn goes_on(&mut self, start: DVector<f64>) -> Outcome<Solution> {
        self.turn(&start);
        if let Some(solution) = self.settled(start.clone()) {
            return Outcome::Solved(solution);
        }
        let (r, steps) = self.newton.run(start, self.settings.steps);
        self.steps += steps;
        self.least = self.least.min(self.problem.residuals(&r).max());
        match self.settled(r) {
            Some(solution) => Outcome::Solved(solution),
            None => self.missed(),
        }
    }

    /// Turns the facets so that one lies along the slip of each contact that slides.
    fn turn(&mut self, r: &DVector<f64>) {
        let u = self.problem.velocities(r);
        for (i, angle) in self.angles.iter_mut().enumerate() {
            let slip: SVector<f64, C> = tangent(&part(&u, i));
            if slip.norm() > 0.0 {
                *angle = (-slip[C - 1]).atan2(-slip[1]);
            }
        }
    }

    /// These forces as a solution, if they are one.
    fn settled(&self, mut r: DVector<f64>) -> Option<Solution> {
        let states = self.newton.states(&r, &self.problem.velocities(&r));
        // What is left on an open contact is noise.
        for (i, _) in states.iter().enumerate().filter(|(_, state)| **state == ContactMode::Open) {
            r.fixed_rows_mut::<C>(C * i).fill(0.0);
        }
        let residuals = self.problem.residuals(&r);
        if !residuals.within(self.settings.tolerance) {
            return None;
        }
        // Beside forces without bound q is lost, and any would do.
        let terms = (self.problem.w.abs() * r.abs()).amax();
        if residuals.max() > ROUNDING && residuals.max() * terms > KNOWN * self.problem.q.amax()
            || terms > 0.0 && self.problem.q.amax() <= LOST * terms
        {
            return None;
        }
        let u = self.problem.velocities(&r);
        Some(Solution { r, u, states, residuals, pivots: self.pivots, steps: self.steps })
    }

    fn missed(&self) -> Outcome<Solution> {
        Outcome::Breakdown {
            pivots: self.pivots,
            cause: BreakdownCause::NoConvergence { residual: self.least },
        }
    }

    /// What is known where nothing was found, given what the first polygon said.
    fn none(self, polygon: Option<Outcome<Solution>>) -> Outcome<Solution> {
        let problem = self.problem;
        let told = match &polygon {
            Some(Outcome::Infeasible(certificate) | Outcome::NearlyInfeasible(certificate)) => {
                Some(certificate.y.clone())
            }
            _ => None,
        };
        let proof =
            told.filter(|y| problem.proves_infeasible(y)).or_else(|| problem.certificate(&self.settings.lcp));
        match (proof, polygon) {
            (Some(y), _) => Outcome::Infeasible(Certificate::new(y, self.pivots)),
            // In the plane the polygon is the cone.
            (None, Some(polygon)) if C == 2 => match polygon {
                Outcome::Infeasible(certificate) => Outcome::NearlyInfeasible(certificate),
                other => other,
            },
            _ => self.missed(),
        }
    }
}

/// An outcome whose certificate weighs contacts, not the rows of the polygon's problem.
fn weighed<const C: usize>(outcome: Outcome<Solution>, polygon: &FacetedProblem<C>) -> Outcome<Solution> {
    let weigh =
        |certificate: Certificate| Certificate::new(polygon.normals(&certificate.y), certificate.pivots);
    match outcome {
        Outcome::Infeasible(certificate) => Outcome::Infeasible(weigh(certificate)),
        Outcome::NearlyInfeasible(certificate) => Outcome::NearlyInfeasible(weigh(certificate)),
        other => other,
    }
}
