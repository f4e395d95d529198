//! The sequence of attempts to solve a problem. The covering vector d multiplies the covering variable z₀ in w = q + M z + d z₀. In the slack basis
//! every slack w_i is basic. A Farkas vector y ≥ 0 with Mᵀy ≤ 0 and qᵀy < 0 proves that no solution exists.
//!
//! The order is: Lemke's path; a proof of infeasibility from the ray of this path; such a proof by linear programming; other Lemke paths; all
//! complementary bases. [`Lcp::solve_with`] describes when each attempt is made.

use super::outcome::{Certificate, Outcome, Unsolved};
use super::problem::Lcp;
use super::settings::Settings;
use super::solution::Solution;
use super::tolerances::{MOST_ENUMERATED, MOST_ROWS_WITH_VERTICES};
use super::workspace::Workspace;
use super::{enumerate, exclusion, linear_program, vertices};
use crate::numerics::generic;
#[cfg(not(feature = "std"))]
use crate::prelude::*;
use nalgebra::DVector;

impl Workspace {
    /// Makes the attempts in turn for a problem whose rows and columns have been balanced. `None` if an attempt solves the problem. Otherwise
    /// returns the proof that no solution exists or, without one, the outcome of the first path.
    pub(super) fn climb(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Unsolved> {
        let first = self.first_path(lcp, settings)?;
        match first {
            Outcome::Infeasible(Certificate { y, .. }) => return Some(self.infeasible(lcp, y)),
            Outcome::NearlyInfeasible(_) => return Some(self.few_rows(lcp).unwrap_or(first)),
            Outcome::PivotLimit { .. } if settings.max_pivots.is_some() => return Some(first),
            _ => {}
        }
        if settings.prove_infeasible
            && let Some(infeasible) = linear_program::proof(lcp, &self.path.scaling, settings)
        {
            return Some(match infeasible {
                Outcome::Infeasible(Certificate { y, .. }) => self.infeasible(lcp, y),
                other => self.few_rows(lcp).unwrap_or_else(|| other.after(self.path.pivots)),
            });
        }
        for attempt in 1..=settings.retries {
            self.retry(lcp, settings, attempt)?;
        }
        if lcp.len() <= settings.enumerate_up_to.min(MOST_ENUMERATED) {
            self.take_enumerated(lcp, settings)?;
            let small = lcp.len() <= MOST_ROWS_WITH_VERTICES;
            if small
                && settings.prove_infeasible
                && let Some(y) = vertices::farkas(lcp, &self.path.scaling)
            {
                return Some(self.infeasible(lcp, y));
            }
            if exclusion::every_basis(lcp, &self.path.scaling, settings) {
                return Some(Outcome::NoBasis { pivots: self.path.pivots });
            }
            if small && let Some(solution) = enumerate::at_corner(lcp, settings) {
                self.take(solution);
                return None;
            }
        }
        Some(first.after(self.path.pivots))
    }

    /// The outcome `Infeasible`. Its proof is a Farkas vector of one or two nonzero entries if there is one, otherwise a simpler form of the Farkas
    /// vector `y`.
    fn infeasible(&self, lcp: &Lcp, y: DVector<f64>) -> Unsolved {
        self.few_rows(lcp).unwrap_or_else(|| {
            Outcome::Infeasible(Certificate { y: lcp.plainer(y), pivots: self.path.pivots })
        })
    }

    /// The outcome `Infeasible`, with a Farkas vector of one or two nonzero entries; `None` if there is no such vector.
    fn few_rows(&self, lcp: &Lcp) -> Option<Unsolved> {
        let y = lcp.few_rows()?;
        Some(Outcome::Infeasible(Certificate { y, pivots: self.path.pivots }))
    }

    /// Follows a path with another covering vector d. If this path does not end in a solution, follows a path from a basis in which one or two of the
    /// z_i are basic. `None` if one of the paths ends in a solution.
    fn retry(&mut self, lcp: &Lcp, settings: &Settings, attempt: usize) -> Option<Unsolved> {
        let units = self.path.scaling.row_unit.iter().enumerate();
        self.path.d.clear();
        self.path.d.extend(
            // Entry i of the covering vector d is 2^e times `unit`, the factor that row i lacks because its scaling is rounded to a power of two.
            // Here e is between −3 and 3. If the range were narrower, the paths would stay close to the first path. If it were wider, the problems
            // would be badly scaled. The exponents follow from a fixed list of irregular numbers ([`generic`]), in which each attempt starts a
            // million numbers further. A dense problem has fewer than a million rows, so attempts share no number.
            units.map(|(i, unit)| unit * (6.0 * (generic(attempt * 1_000_003 + i) - 1.0)).exp2()),
        );
        let limit = settings.retry_limit(lcp.len(), self.path.pivots);
        let failure = self.follow(lcp, settings, limit)?;
        let Some([i, j]) = small_basis(lcp, attempt) else { return Some(failure) };
        let limit = settings.retry_limit(lcp.len(), self.path.pivots);
        if self.path.run_from(lcp.m.as_slice(), &|k| k == i || k == j, settings, limit) {
            return self.finish_or_resume(lcp, settings, limit);
        }
        Some(failure)
    }

    fn take_enumerated(&mut self, lcp: &Lcp, settings: &Settings) -> Option<()> {
        let all = enumerate::all_solutions(lcp, settings);
        let Some(solution) = all.solutions.into_iter().next() else { return Some(()) };
        self.take(solution);
        None
    }

    fn take(&mut self, solution: Solution) {
        self.point.z = solution.z.as_slice().to_vec();
        self.point.w = solution.w.as_slice().to_vec();
        self.basis = solution.basis;
        self.residuals = Some(solution.residuals);
        self.degenerate = solution.degenerate;
    }
}

/// A basis for the start of a path, for problems whose paths from the slack basis end in rays: z_i and z_j are basic, or z_i alone (returned as `[i,
/// i]`) if M_ii ≠ 0. `None` if no j has nonzero M_ij and M_ji.
///
/// The matrix [0, A; Bᵀ, 0] of a bimatrix game has no other regular bases with one or two basic z's. Each attempt uses another index i.
fn small_basis(lcp: &Lcp, attempt: usize) -> Option<[usize; 2]> {
    let n = lcp.len();
    let i = attempt.wrapping_mul(7).wrapping_add(attempt / n) % n;
    if lcp.m[(i, i)] != 0.0 {
        return Some([i, i]);
    }
    let coupled = |j: &usize| lcp.m[(i, *j)] != 0.0 && lcp.m[(*j, i)] != 0.0;
    (0..n).map(|k| (i + attempt + k) % n).find(coupled).map(|j| [i, j])
}
