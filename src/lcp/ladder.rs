//! The ladder from one path to the next: Lemke's path; a proof from its ray; other paths; a proof by linear programming; all
//! complementary bases.

use super::Lcp;
use super::basis::Basis;
use super::certificate;
use super::dictionary::Unknown;
use super::enumerate;
use super::lemke::End;
use super::outcome::{BreakdownCause, Outcome, Proof, Ray};
use super::settings::Settings;
use super::workspace::Workspace;
use crate::numerics::generic;

impl Workspace {
    pub(super) fn solve_cold(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Outcome> {
        self.residuals = None;
        if lcp.q.iter().all(|q| *q >= 0.0) {
            self.path.pivots = 0;
            return self.accept_slack_basis(lcp, settings);
        }
        self.path.prepare(lcp.m.as_slice(), lcp.q.as_slice());
        self.reserve(lcp.len());
        self.solve_prepared(lcp, settings)
    }

    /// The ladder: Lemke's path; a proof from its ray; other paths; a proof by linear programming; all bases.
    fn solve_prepared(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Outcome> {
        let first = self.first_path(lcp, settings)?;
        match &first {
            Outcome::Ray(ray) if ray.proof != Proof::None => return Some(first),
            Outcome::PivotLimit { .. } if settings.max_pivots.is_some() => return Some(first),
            Outcome::Breakdown {
                cause: BreakdownCause::CoveringEntry { .. } | BreakdownCause::CoveringLength { .. },
                ..
            } => return Some(first),
            _ => {}
        }
        self.climb(lcp, settings, first)
    }

    fn first_path(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Outcome> {
        if let Err(cause) = self.cover(lcp, settings) {
            return Some(Outcome::Breakdown { pivots: self.path.pivots, cause });
        }
        self.follow(lcp, settings, settings.pivot_limit(lcp.len()))
    }

    /// After a first path without solution and without proof.
    fn climb(&mut self, lcp: &Lcp, settings: &Settings, mut first: Outcome) -> Option<Outcome> {
        if let Some(proof) = certificate::by_linear_programming(lcp, &self.path.scaling, settings) {
            let ray = if let Outcome::Ray(ray) = first { Some(ray) } else { None };
            let ray = ray.unwrap_or_else(|| Ray::without_direction(lcp.len(), self.path.pivots));
            return Some(Outcome::Ray(Ray { proof: Proof::Infeasible(proof), ..ray }));
        }
        for attempt in 1..=settings.retries {
            // An exponential path is not followed again to its end.
            let limit = self.short_limit(lcp, settings);
            let units = self.path.scaling.row_unit.iter().enumerate();
            self.path.d.clear();
            // Entries between 1/8 and 8.
            self.path.d.extend(
                units.map(|(i, unit)| unit * (6.0 * (generic(attempt * 1_000_003 + i) - 1.0)).exp2()),
            );
            self.follow(lcp, settings, limit)?;
            if let Some([i, j]) = small_basis(lcp, attempt) {
                let m = lcp.m.as_slice();
                let sound = self.path.install_basis(m, |k| k == i || k == j).is_ok();
                if sound && self.path.cover_violations(m) {
                    let limit = self.short_limit(lcp, settings);
                    if self.path.cover_and_run(m, settings, limit) == End::Complementary {
                        self.finish_or_go_on(lcp, settings, limit)?;
                    }
                }
            }
        }
        if lcp.len() <= settings.enumerate_up_to.min(enumerate::LARGEST) {
            let all = enumerate::all_solutions(lcp, settings);
            if let Some(solution) = all.solutions.into_iter().next() {
                self.point.z = solution.z.as_slice().to_vec();
                self.point.w = solution.w.as_slice().to_vec();
                self.basis = solution.basis;
                self.residuals = Some(solution.residuals);
                self.degenerate = solution.degenerate;
                return None;
            }
            let ray = if let Outcome::Ray(ray) = first { Some(ray) } else { None };
            let ray = ray.unwrap_or_else(|| Ray::without_direction(lcp.len(), self.path.pivots));
            first = Outcome::Ray(Ray { proof: Proof::NoComplementaryBasis, ..ray });
        }
        match &mut first {
            Outcome::Ray(Ray { pivots, .. }) | Outcome::Breakdown { pivots, .. } => {
                *pivots = self.path.pivots;
            }
            _ => {}
        }
        Some(first)
    }

    /// A limit for one more path.
    fn short_limit(&self, lcp: &Lcp, settings: &Settings) -> usize {
        settings.max_pivots.unwrap_or_else(|| self.path.pivots.saturating_add(100 + 10 * lcp.len()))
    }

    pub(super) fn solve_warm(&mut self, lcp: &Lcp, basis: &Basis, settings: &Settings) -> Option<Outcome> {
        self.residuals = None;
        self.path.prepare(lcp.m.as_slice(), lcp.q.as_slice());
        self.path.d.clear();
        self.path.d.resize(lcp.len(), 0.0);
        if basis.len() == lcp.len()
            && self.path.install_basis(lcp.m.as_slice(), |i| basis.contains(i)).is_ok()
        {
            self.resume(lcp, settings)
        } else {
            self.solve_prepared(lcp, settings)
        }
    }

    /// Solves a problem and leaves the dictionary of its basis, even if that is the slack basis.
    pub(crate) fn solve_first(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Outcome> {
        self.residuals = None;
        self.path.prepare(lcp.m.as_slice(), lcp.q.as_slice());
        self.solve_prepared(lcp, settings)
    }

    /// Solves for a right-hand side that belongs to the matrix whose dictionary the path holds.
    pub(crate) fn solve_next(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Outcome> {
        self.residuals = None;
        self.path.pivots = 0;
        self.path.set_right_hand_side(lcp.q.as_slice());
        self.path.recompute_values();
        self.resume(lcp, settings)
    }

    /// Follows the path from the present complementary basis; a failure starts again from the slacks.
    fn resume(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Outcome> {
        let limit = settings.pivot_limit(lcp.len());
        let m = lcp.m.as_slice();
        let feasible = !self.path.cover_violations(m);
        if (feasible || self.path.cover_and_run(m, settings, limit) == End::Complementary)
            && self.finish(lcp, settings).is_none()
        {
            return None;
        }
        self.solve_prepared(lcp, settings)
    }

    /// One path without the rest of the ladder.
    pub(crate) fn follow_once(&mut self, lcp: &Lcp, settings: &Settings) -> Outcome {
        self.residuals = None;
        self.path.prepare(lcp.m.as_slice(), lcp.q.as_slice());
        let failure = self.first_path(lcp, settings);
        self.answer(failure).into_outcome()
    }

    /// Puts the covering vector, in balanced rows, into the path.
    fn cover(&mut self, lcp: &Lcp, settings: &Settings) -> Result<(), BreakdownCause> {
        self.path.d.clear();
        let Some(d) = &settings.covering else {
            self.path.d.extend_from_slice(&self.path.scaling.row_unit);
            return Ok(());
        };
        if d.len() != lcp.len() {
            return Err(BreakdownCause::CoveringLength { given: d.len(), needed: lcp.len() });
        }
        for (row, (d, q)) in d.iter().zip(&lcp.q).enumerate() {
            if !(d.is_finite() && *d >= 0.0) || (*q < 0.0 && *d == 0.0) {
                return Err(BreakdownCause::CoveringEntry { row, value: *d });
            }
        }
        self.path.d.extend(d.iter().zip(&self.path.scaling.row).map(|(d, row)| d * row));
        Ok(())
    }

    /// Follows Lemke's path from the slack basis and checks where it ends.
    fn follow(&mut self, lcp: &Lcp, settings: &Settings, limit: usize) -> Option<Outcome> {
        let m = lcp.m.as_slice();
        self.path.start_from_slacks();
        self.path.dictionary.enter(Unknown::Covering, m, &self.path.scaling);
        match self.path.cover_and_run(m, settings, limit) {
            End::Complementary => self.finish_or_go_on(lcp, settings, limit),
            End::Ray(entering) => Some(match certificate::ray(lcp, &self.path, entering) {
                Some(ray) => Outcome::Ray(ray),
                None => Outcome::Breakdown { pivots: self.path.pivots, cause: BreakdownCause::Overflow },
            }),
            End::PivotLimit => Some(Outcome::PivotLimit { pivots: self.path.pivots }),
            End::Breakdown(cause) => Some(Outcome::Breakdown { pivots: self.path.pivots, cause }),
        }
    }

    /// Where rounding has led the path to a basis that is not feasible, it is taken up again from there.
    fn finish_or_go_on(&mut self, lcp: &Lcp, settings: &Settings, limit: usize) -> Option<Outcome> {
        let m = lcp.m.as_slice();
        for _ in 0..3 {
            let failure = self.finish(lcp, settings)?;
            let active: Vec<bool> = (0..lcp.len()).map(|i| self.path.dictionary.is_active(i)).collect();
            let sound = self.path.install_basis(m, |i| active[i]).is_ok() && self.path.cover_violations(m);
            if !sound || self.path.cover_and_run(m, settings, limit) != End::Complementary {
                return Some(failure);
            }
        }
        self.finish(lcp, settings)
    }
}

/// A basis of one or two z's to start a path from where the slack basis leads to rays, as in bimatrix games, whose matrix
/// [0, A; Bᵀ, 0] has no other regular bases with few z's. Each attempt takes another first index.
fn small_basis(lcp: &Lcp, attempt: usize) -> Option<[usize; 2]> {
    let n = lcp.len();
    let i = attempt.wrapping_mul(7).wrapping_add(attempt / n) % n;
    if lcp.m[(i, i)] != 0.0 {
        return Some([i, i]);
    }
    let coupled = |j: &usize| lcp.m[(i, *j)] != 0.0 && lcp.m[(*j, i)] != 0.0;
    (0..n).map(|k| (i + attempt + k) % n).find(coupled).map(|j| [i, j])
}
