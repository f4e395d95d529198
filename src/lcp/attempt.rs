//! One attempt: a path from the slacks to its end, and the check of the point there.
//!
//! An attempt returns `None` if the workspace then holds a solution. Otherwise it returns the way in which it failed.

use super::certificate;
use super::dictionary::LemkeVariable;
use super::lemke::LemkeEnd;
use super::outcome::{BreakdownCause, Outcome, Unsolved};
use super::problem::Lcp;
use super::settings::Settings;
use super::tolerances::residual_rounding;
use super::workspace::Workspace;
use crate::numerics::numbered;
use crate::numerics::tolerances::ROUNDED_SUM;
use crate::prelude::*;

impl Workspace {
    /// Balances the problem and clears the results of the problem before.
    pub(super) fn prepare(&mut self, lcp: &Lcp) {
        self.residuals = None;
        self.path.prepare(lcp.m.as_slice(), lcp.q.as_slice());
        self.reserve(lcp.len());
    }

    /// Follows the path of a prepared problem with the covering vector of the settings.
    pub(super) fn first_path(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Unsolved> {
        self.cover(settings);
        self.follow(lcp, settings, settings.pivot_limit(lcp.len()))
    }

    /// Returns the breakdown that ends the solve before it begins, if the settings do not fit the problem.
    pub(super) fn refuse(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Unsolved> {
        self.residuals = None;
        self.path.pivots = 0;
        settings.check(&lcp.q).err().map(|cause| Outcome::Breakdown { pivots: 0, cause })
    }

    /// Writes the covering vector d, in balanced rows, into the path.
    fn cover(&mut self, settings: &Settings) {
        let path = &mut self.path;
        match &settings.covering {
            None => path.d.clone_from(&path.scaling.row_unit),
            Some(d) => {
                path.d.clear();
                path.d.extend(d.iter().zip(&path.scaling.row).map(|(d, row)| d * row));
            }
        }
    }

    /// Follows Lemke's path from the slack basis and checks where it ends.
    pub(super) fn follow(&mut self, lcp: &Lcp, settings: &Settings, limit: usize) -> Option<Unsolved> {
        let m = lcp.m.as_slice();
        self.path.start_from_slacks();
        self.path.dictionary.enter(LemkeVariable::Covering, m, &self.path.scaling);
        let end = self.path.cover_and_run(m, settings, limit);
        let pivots = self.path.pivots;
        Some(match end {
            LemkeEnd::Complementary => return self.finish_or_resume(lcp, settings, limit),
            LemkeEnd::Ray(entering) => match certificate::ray(lcp, &self.path, entering) {
                Some(outcome) => outcome,
                None => Outcome::Breakdown { pivots, cause: BreakdownCause::Overflow },
            },
            LemkeEnd::PivotLimit => Outcome::PivotLimit { pivots },
            LemkeEnd::Breakdown(cause) => Outcome::Breakdown { pivots, cause },
        })
    }

    /// Checks the end of a path. Where rounding has led the path to a basis that is not feasible,
    /// the path is resumed from that basis.
    pub(super) fn finish_or_resume(
        &mut self,
        lcp: &Lcp,
        settings: &Settings,
        limit: usize,
    ) -> Option<Unsolved> {
        // Each time costs one elimination. A path that misses three times has met a basis too close to
        // singular.
        for _ in 0..3 {
            let Some(failure) = self.finish(lcp, settings) else {
                self.sharpen(lcp, settings, limit);
                return None;
            };
            let active: Vec<bool> = numbered(lcp.len(), &|i| self.path.dictionary.is_active(i));
            if !self.path.run_from(lcp.m.as_slice(), |i| active[i], settings, limit) {
                return Some(failure);
            }
        }
        self.finish(lcp, settings)
    }

    /// Continues from a solution whose w is negative by more than rounding. Rows that nearly tie were taken for ties there, or small values for
    /// noise. The continuation does neither, and the better of the two points is kept. It is a second path, so settings without retries skip it.
    fn sharpen(&mut self, lcp: &Lcp, settings: &Settings, limit: usize) {
        let coarse = match self.residuals {
            Some(r) if r.negative_w > residual_rounding(lcp.len()) && settings.retries > 0 => r,
            _ => return,
        };
        let m = lcp.m.as_slice();
        // Values a little below zero may have been cut off on the way here.
        self.path.recompute_values();
        if !self.path.cover_violations(m, ROUNDED_SUM) {
            return;
        }
        let kept = (self.point.clone(), self.basis.clone(), self.degenerate);
        let sharp = Settings { tie_tolerance: settings.tie_tolerance.min(ROUNDED_SUM), ..settings.clone() };
        // A separation of near-ties that succeeds takes few pivots; large degenerate problems would otherwise
        // run for long.
        let limit = limit.min(self.path.pivots + 16);
        let goes_on = self.path.cover_and_run(m, &sharp, limit) == LemkeEnd::Complementary
            && self.finish_as_it_is(lcp, &sharp).is_none();
        if !goes_on || self.residuals.is_none_or(|sharper| sharper.max() >= coarse.max()) {
            (self.point, self.basis, self.degenerate) = kept;
            self.residuals = Some(coarse);
        }
    }
}
