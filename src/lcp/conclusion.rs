//! From the end of a path to a point that is checked against the data given.

use super::dictionary::Unknown;
use super::outcome::{BreakdownCause, Outcome};
use super::path::Path;
use super::principal;
use super::problem::Lcp;
use super::residuals::{Residuals, ignores_q, rounded};
use super::settings::Settings;
use super::workspace::Workspace;

/// Values below this fraction of the largest term they were computed from are zero.
pub(crate) const ZERO: f64 = 1e-13;

impl Workspace {
    pub(super) fn accept_slack_basis(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Outcome> {
        self.basis.clear(lcp.len());
        self.vanishing.clear();
        self.vanishing.resize(lcp.len(), false);
        self.point.z.clear();
        self.point.z.resize(lcp.len(), 0.0);
        let residuals = self.point.evaluate(lcp);
        self.conclude(lcp, residuals, settings)
    }

    /// The point of the complementary basis in the dictionary, refined against the M and q given. `None` if it solves
    /// the problem.
    pub(super) fn finish(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Outcome> {
        let n = lcp.len();
        self.basis.clear(n);
        self.mark_vanishing(lcp);
        // A z_j which is zero in exact arithmetic comes out as noise that spoils the rows it enters. If w_j can take its place, the
        // point is that of a smaller block. By index, since the order of rows depends on rounding.
        let Path { dictionary, scaling, .. } = &mut self.path;
        for j in (0..n).filter(|j| self.vanishing[*j]) {
            if let Some(row) = dictionary.basic.iter().position(|basic| *basic == Unknown::Z(j)) {
                dictionary.retire(j, row, scaling, lcp.m.as_slice());
            }
        }
        for basic in &dictionary.basic {
            if let Unknown::Z(j) = *basic {
                self.basis.insert(j);
            }
        }
        self.read_point(n);
        let mut residuals = self.point.evaluate(lcp);
        for _ in 0..3 {
            if residuals.within(rounded(n)) || residuals == Residuals::UNUSABLE {
                break;
            }
            std::mem::swap(&mut self.point, &mut self.spare);
            self.refine();
            self.read_point(n);
            let refined = self.point.evaluate(lcp);
            let gain = refined.max() < 0.5 * residuals.max();
            if refined.max().is_nan() || refined.max() >= residuals.max() {
                std::mem::swap(&mut self.point, &mut self.spare);
            } else {
                residuals = refined;
            }
            if !gain {
                break;
            }
        }
        // A basic variable which is zero in exact arithmetic comes out as noise; it is left out if that costs nothing.
        if (0..n).any(|j| self.vanishing[j] && self.point.z[j] > 0.0) {
            self.spare.z.clear();
            self.spare
                .z
                .extend(self.point.z.iter().zip(&self.vanishing).map(|(z, out)| if *out { 0.0 } else { *z }));
            let cut = self.spare.evaluate(lcp);
            if cut.max() <= residuals.max().max(rounded(n)) {
                std::mem::swap(&mut self.point, &mut self.spare);
                residuals = cut;
            }
        }
        if !residuals.within(ZERO) {
            residuals = self.finish_by_factorisation(lcp, residuals);
        }
        if self.settle_pairs(settings) {
            residuals = self.point.evaluate(lcp);
        }
        self.conclude(lcp, residuals, settings)
    }

    /// Which basic z's are zero but for rounding: those that are small against the terms they were computed from, and
    /// those that are small against the largest z, if the point without them is as good. The terms alone do not show the noise
    /// of a z whose terms all vanish.
    fn mark_vanishing(&mut self, lcp: &Lcp) {
        let n = lcp.len();
        self.vanishing.clear();
        self.vanishing.resize(n, false);
        let dictionary = &self.path.dictionary;
        let values = || dictionary.basic.iter().zip(&dictionary.x).zip(&dictionary.level);
        let faint = ZERO
            * values().fold(
                0.0_f64,
                |most, ((basic, x), _)| {
                    if matches!(basic, Unknown::Z(_)) { most.max(*x) } else { most }
                },
            );
        let mut doubtful = false;
        self.spare.z.clear();
        self.spare.z.resize(n, 0.0);
        for ((basic, x), level) in values() {
            if let Unknown::Z(j) = *basic {
                self.vanishing[j] = *x <= ZERO * level;
                doubtful |= !self.vanishing[j] && *x <= faint;
                if *x > faint {
                    self.spare.z[j] = x * self.path.scaling.column[j];
                }
            }
        }
        if doubtful && self.spare.evaluate(lcp).within(rounded(n)) {
            for basic in &self.path.dictionary.basic {
                if let Unknown::Z(j) = *basic {
                    self.vanishing[j] |= self.spare.z[j] == 0.0;
                }
            }
        }
    }

    /// z from the values in the dictionary; noise below zero is cut off.
    fn read_point(&mut self, n: usize) {
        self.point.z.clear();
        self.point.z.resize(n, 0.0);
        let dictionary = &self.path.dictionary;
        for (basic, x) in dictionary.basic.iter().zip(&dictionary.x) {
            if let Unknown::Z(j) = *basic {
                self.point.z[j] = x.max(0.0) * self.path.scaling.column[j];
            }
        }
    }

    /// Adds to the values the effect of the defect that the point in `spare` leaves in the rows that should vanish.
    fn refine(&mut self) {
        let path = &mut self.path;
        self.defect.clear();
        self.defect.extend(self.spare.w.iter().zip(&path.scaling.row).map(|(w, row)| w * row));
        for (i, defect) in self.defect.iter_mut().enumerate() {
            if !path.dictionary.is_active(i) {
                *defect = 0.0;
            }
        }
        self.correction.clear();
        self.correction.resize(self.defect.len(), 0.0);
        path.dictionary.effect(&self.defect, &mut self.correction);
        for (x, c) in path.dictionary.x.iter_mut().zip(&self.correction) {
            *x += c;
        }
    }

    /// Where z_i is basic but w_i is not zero although the residuals are small, z_i has no share in any row that
    /// could be seen: it is the one to vanish. Returns whether there was such a pair.
    fn settle_pairs(&mut self, settings: &Settings) -> bool {
        let mut changed = false;
        for (i, z) in self.point.z.iter_mut().enumerate() {
            if self.basis.contains(i) && self.point.w[i] > settings.residual_tolerance * self.point.terms[i] {
                *z = 0.0;
                self.basis.toggle(i);
                changed = true;
            }
        }
        changed
    }

    /// The point of the basis by a fresh factorisation, without and with its vanishing variables; the best one is kept.
    fn finish_by_factorisation(&mut self, lcp: &Lcp, mut best: Residuals) -> Residuals {
        let alpha: Vec<usize> = self.basis.iter().collect();
        let support: Vec<usize> = alpha.iter().copied().filter(|i| !self.vanishing[*i]).collect();
        for indices in [&support, &alpha] {
            if best.within(ZERO) {
                break;
            }
            if let Some(basic) = principal::solve(&lcp.m, &lcp.q, indices) {
                self.spare.z.clear();
                self.spare.z.resize(lcp.len(), 0.0);
                for (j, value) in indices.iter().zip(&basic) {
                    self.spare.z[*j] = value.max(0.0);
                }
                let residuals = self.spare.evaluate(lcp);
                if best.max().is_nan() || residuals.max() < best.max() {
                    best = residuals;
                    std::mem::swap(&mut self.point, &mut self.spare);
                }
            }
        }
        best
    }

    /// Says "solved" only if the residuals do.
    fn conclude(&mut self, lcp: &Lcp, residuals: Residuals, settings: &Settings) -> Option<Outcome> {
        let pivots = self.path.pivots;
        if residuals == Residuals::UNUSABLE {
            return Some(Outcome::Breakdown { pivots, cause: BreakdownCause::Overflow });
        }
        if !residuals.within(settings.residual_tolerance) {
            return Some(Outcome::Breakdown { pivots, cause: BreakdownCause::Residual(residuals) });
        }
        if ignores_q(residuals, lcp.q.as_slice(), &self.point.terms, &self.path.scaling.row) {
            return Some(Outcome::Breakdown { pivots, cause: BreakdownCause::SingularBasis });
        }
        self.degenerate = false;
        for (i, w) in self.point.w.iter_mut().enumerate() {
            if self.basis.contains(i) {
                *w = 0.0;
                self.degenerate |= self.vanishing[i] || self.point.z[i] == 0.0;
            } else {
                self.degenerate |= self.vanishing[i] || *w <= ZERO * self.point.terms[i];
                *w = w.max(0.0);
            }
        }
        self.residuals = Some(residuals);
        None
    }
}
