//! One attempt: Lemke's path from the slack basis to its end, and the check of the point at this end. In the slack basis every slack w_i of
//! w = M z + q is basic. The path runs through solutions of w = M z + q + d z₀ with a covering vector d and a covering variable z₀. Balanced rows and
//! columns are scaled by powers of two, so that nonzero entries of M lie near 1.
//!
//! An attempt returns `None` if it has left a solution in the [`Workspace`], otherwise the outcome with which it failed.

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
    /// Balances rows and columns of the problem, and resets the path and the residuals of the previous problem.
    pub(super) fn prepare(&mut self, lcp: &Lcp) {
        self.residuals = None;
        self.path.prepare(lcp.m.as_slice(), lcp.q.as_slice());
        self.reserve(lcp.len());
    }

    /// Follows Lemke's path from the slack basis, with the covering vector and the pivot limit of the settings. The problem must have been
    /// prepared by [`Self::prepare`]. `None` if the path ends in a solution.
    pub(super) fn first_path(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Unsolved> {
        self.cover(settings);
        self.follow(lcp, settings, settings.pivot_limit(lcp.len()))
    }

    /// Clears the residuals and the number of pivots of the previous problem, then checks the settings. Returns a breakdown if the settings are
    /// invalid for this problem, otherwise `None`.
    pub(super) fn refuse(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Unsolved> {
        self.residuals = None;
        self.path.pivots = 0;
        settings.check(&lcp.q).err().map(|cause| Outcome::Breakdown { pivots: 0, cause })
    }

    /// Stores the covering vector d of w = q + M z + d z₀ in the path. It is the vector of the settings, multiplied by the scale factors of the rows.
    /// Without a covering vector in the settings, every entry of d is 1 up to the rounding of the scale factors to powers of two.
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

    /// Follows Lemke's path from the slack basis with the stored covering vector d, and checks the point at its end. `limit` is the largest
    /// number of pivots of all paths of the solve together. `None` if the point is a solution.
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

    /// Checks the complementary point at the end of a path. If the point fails the check because of rounding, the path is resumed from the basis of
    /// this point, up to three times. `None` if one of the end points is a solution.
    pub(super) fn finish_or_resume(
        &mut self,
        lcp: &Lcp,
        settings: &Settings,
        limit: usize,
    ) -> Option<Unsolved> {
        // Each check costs one factorisation. A path whose end fails its check three times has met a nearly singular basis.
        for _ in 0..3 {
            let Some(failure) = self.finish(lcp, settings) else {
                self.sharpen(lcp, settings, limit);
                return None;
            };
            let active: Vec<bool> = numbered(lcp.len(), &|i| self.path.dictionary.is_active(i));
            if !self.path.run_from(lcp.m.as_slice(), &|i| active[i], settings, limit) {
                return Some(failure);
            }
        }
        self.finish(lcp, settings)
    }

    /// Improves a solution with slacks w that are more negative than rounding explains. Such slacks occur if the path treated nearly equal ratios as
    /// ties, or small values as noise. A second path starts at this solution with a tie tolerance of at most [`ROUNDED_SUM`]. Of the two points, the
    /// point with the smaller largest residual is kept. Settings without retries skip this step.
    fn sharpen(&mut self, lcp: &Lcp, settings: &Settings, limit: usize) {
        let coarse = match self.residuals {
            Some(r) if r.negative_w > residual_rounding(lcp.len()) && settings.retries > 0 => r,
            _ => return,
        };
        let m = lcp.m.as_slice();
        // The values of the basic variables are recomputed from q, since slightly negative values may have been set to zero earlier on the path.
        self.path.recompute_values();
        if !self.path.cover_violations(m, ROUNDED_SUM) {
            return;
        }
        let kept = (self.point.clone(), self.basis.clone(), self.degenerate);
        let sharp = Settings { tie_tolerance: settings.tie_tolerance.min(ROUNDED_SUM), ..settings.clone() };
        // Sixteen more pivots separate nearly tied ratios, if they can be separated at all. If this limit were left out, the second path of large
        // degenerate problems would take long.
        let limit = limit.min(self.path.pivots + 16);
        let goes_on = self.path.cover_and_run(m, &sharp, limit) == LemkeEnd::Complementary
            && self.finish_as_it_is(lcp, &sharp).is_none();
        if !goes_on || self.residuals.is_none_or(|sharper| sharper.max() >= coarse.max()) {
            (self.point, self.basis, self.degenerate) = kept;
            self.residuals = Some(coarse);
        }
    }
}
