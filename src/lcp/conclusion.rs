//! The end of a path: the point z of the complementary basis is computed and refined, and its residuals are computed from the given M and q. The
//! problem is 0 ≤ z ⟂ w = M z + q ≥ 0. α is the set of the i with z_i basic.

use super::dictionary::LemkeVariable;
use super::memory::refill;
use super::outcome::{BreakdownCause, Outcome, Unsolved};
use super::path::LemkePath;
use super::principal;
use super::problem::Lcp;
use super::residuals::{Residuals, ignores_q};
use super::settings::Settings;
use super::tolerances::{SOUND_RESIDUAL, ZERO_VALUE, residual_rounding};
use super::workspace::Workspace;
use crate::numerics::{IntoList, add_times, any_index};
use crate::prelude::*;

impl Workspace {
    /// Makes z = 0 the point of the workspace, for a problem with q ≥ 0, and checks it. `None` if it is accepted as a solution, otherwise the
    /// breakdown.
    pub(super) fn accept_slack_basis(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Unsolved> {
        let n = lcp.len();
        self.basis.clear(n);
        refill(&mut self.vanishing, n, false);
        refill(&mut self.point.z, n, 0.0);
        let residuals = self.point.evaluate(lcp);
        self.conclude(lcp, residuals, settings)
    }

    /// Removes each z_j that is zero up to rounding from the complementary basis at the end of the path. Then refines the point of this basis
    /// and checks it against the given M and q. `None` if the point solves the problem.
    pub(super) fn finish(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Unsolved> {
        self.mark_vanishing(lcp);
        self.retire_vanishing(lcp);
        self.finish_basis(lcp, settings)
    }

    /// Refines and checks the point at the end of the path, with each z_j that is zero up to rounding kept in the basis. `None` if the point solves
    /// the problem.
    pub(super) fn finish_as_it_is(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Unsolved> {
        refill(&mut self.vanishing, lcp.len(), false);
        self.finish_basis(lcp, settings)
    }

    fn finish_basis(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Unsolved> {
        let n = lcp.len();
        self.basis.clear(n);
        for basic in &self.path.dictionary.basic {
            if let LemkeVariable::Z(j) = *basic {
                self.basis.insert(j);
            }
        }
        self.path.read_point(&mut self.point.z);
        let residuals = self.point.evaluate(lcp);
        let mut residuals = self.refine(lcp, residuals);
        // A basic z_j that is zero in exact arithmetic is computed as noise. It is set to zero if that does not increase the residuals beyond
        // rounding.
        if any_index(n, &|j| self.vanishing[j] && self.point.z[j] > 0.0) {
            let mut kept =
                self.point.z.iter().zip(&self.vanishing).map(|(z, out)| if *out { 0.0 } else { *z });
            self.candidate.z.clear();
            kept.append_to(&mut self.candidate.z);
            let free_of_charge = residuals.max().max(residual_rounding(n));
            self.take_spare(lcp, &mut residuals, |cut| cut <= free_of_charge);
        }
        if !residuals.within(SOUND_RESIDUAL) {
            self.finish_by_factorisation(lcp, &mut residuals);
        }
        if self.settle_pairs(settings) {
            residuals = self.point.evaluate(lcp);
        }
        self.conclude(lcp, residuals, settings)
    }

    /// Replaces the point of the workspace by the point `candidate` if `accept` is true for the largest residual of `candidate`. `residuals`
    /// then become the residuals of `candidate`.
    fn take_spare(&mut self, lcp: &Lcp, residuals: &mut Residuals, accept: impl Fn(f64) -> bool) {
        let candidate_residuals = self.candidate.evaluate(lcp);
        if accept(candidate_residuals.max()) {
            *residuals = candidate_residuals;
            core::mem::swap(&mut self.point, &mut self.candidate);
        }
    }

    /// Marks each basic z_j that is zero up to rounding.
    ///
    /// One of two tests must hold. First, z_j is at most [`ZERO_VALUE`] times the magnitude of the terms from which it was computed. Second, z_j is
    /// at most [`ZERO_VALUE`] times the largest entry of z. In the second test the residuals must also stay at the level of rounding errors if all
    /// entries below this limit are set to zero. The second test finds entries that were computed from noise alone.
    fn mark_vanishing(&mut self, lcp: &Lcp) {
        let n = lcp.len();
        refill(&mut self.vanishing, n, false);
        refill(&mut self.candidate.z, n, 0.0);
        let dictionary = &self.path.dictionary;
        let basic_z = || {
            let values = dictionary.basic.iter().zip(&dictionary.x).zip(&dictionary.term_sizes);
            values.filter_map(|((basic, x), term_size)| match *basic {
                LemkeVariable::Z(j) => Some((j, *x, *term_size)),
                _ => None,
            })
        };
        let faint = ZERO_VALUE * basic_z().fold(0.0_f64, |most, (_, x, _)| most.max(x));
        let mut doubtful = false;
        for (j, x, term_size) in basic_z() {
            self.vanishing[j] = x <= ZERO_VALUE * term_size;
            doubtful |= !self.vanishing[j] && x <= faint;
            if x > faint {
                self.candidate.z[j] = x * self.path.scaling.column[j];
            }
        }
        if doubtful && self.candidate.evaluate(lcp).within(residual_rounding(n)) {
            for (j, ..) in basic_z() {
                self.vanishing[j] |= self.candidate.z[j] == 0.0;
            }
        }
    }

    /// Exchanges each z_j that [`Self::mark_vanishing`] has marked with w_j, unless the pivot is too small.
    ///
    /// The other basic variables then have a smaller principal block, and the noise of z_j does not affect them. Variables are processed in the
    /// order of their indices, since the order of the rows of the dictionary (the condensed tableau) depends on rounding.
    fn retire_vanishing(&mut self, lcp: &Lcp) {
        let LemkePath { dictionary, scaling, .. } = &mut self.path;
        for j in (0..lcp.len()).filter(|j| self.vanishing[*j]) {
            if let Some(row) = dictionary.basic.iter().position(|basic| *basic == LemkeVariable::Z(j)) {
                dictionary.retire(j, row, scaling, lcp.m.as_slice());
            }
        }
    }

    /// Refines the point by at most three steps. Refinement ends earlier if the residuals are at the level of rounding errors, or if a step does not
    /// halve the largest residual. Keeps the point with the smallest largest residual and returns its residuals.
    fn refine(&mut self, lcp: &Lcp, mut residuals: Residuals) -> Residuals {
        let n = lcp.len();
        // Each refinement step costs O(n²); already the third step rarely gains anything.
        for _ in 0..3 {
            if residuals.within(residual_rounding(n)) || residuals == Residuals::UNUSABLE {
                break;
            }
            self.correct_values();
            self.path.read_point(&mut self.candidate.z);
            let before = residuals.max();
            self.take_spare(lcp, &mut residuals, |refined| refined < before);
            // A refinement step that leaves more than half of the largest residual has reached the level of rounding.
            if residuals.max() >= 0.5 * before {
                break;
            }
        }
        residuals
    }

    /// One step of refinement: computes the defect of each row of w = M z + q at the present point, and corrects the values of the basic
    /// variables for it. If z_i is basic, the defect of row i is the value of w_i, which should vanish.
    fn correct_values(&mut self) {
        let path = &mut self.path;
        self.defect.clear();
        self.point.w.iter().zip(&path.scaling.row).map(|(w, row)| w * row).append_to(&mut self.defect);
        for (i, defect) in self.defect.iter_mut().enumerate() {
            if !path.dictionary.is_active(i) {
                *defect = 0.0;
            }
        }
        refill(&mut self.correction, self.defect.len(), 0.0);
        path.dictionary.effect(&self.defect, &mut self.correction);
        add_times(&mut path.dictionary.x, &self.correction, 1.0);
    }

    /// Sets to zero, and removes from the basis, each basic z_i whose w_i exceeds the residual tolerance relative to the terms of w_i. If all
    /// residuals are within this tolerance, the contribution of such a z_i to every row is also within it. Returns whether any z_i was set.
    fn settle_pairs(&mut self, settings: &Settings) -> bool {
        let mut changed = false;
        for i in 0..self.point.z.len() {
            if self.basis.contains(i) && self.point.has_slack(i, settings.residual_tolerance) {
                self.point.z[i] = 0.0;
                self.basis.toggle(i);
                changed = true;
            }
        }
        changed
    }

    /// Factorises the principal block M_αα of the basis anew: first without the z_j that are zero up to rounding, then with them. Replaces the
    /// point z if the largest residual of the new point is smaller.
    fn finish_by_factorisation(&mut self, lcp: &Lcp, best: &mut Residuals) {
        let alpha: Vec<usize> = self.basis.iter().list();
        let support: Vec<usize> = alpha.iter().copied().filter(|i| !self.vanishing[*i]).list();
        for indices in [&support, &alpha] {
            if best.within(SOUND_RESIDUAL) {
                break;
            }
            if let Some(basic) = principal::solve(lcp, indices) {
                refill(&mut self.candidate.z, lcp.len(), 0.0);
                for (j, value) in indices.iter().zip(&basic) {
                    self.candidate.z[*j] = value.max(0.0);
                }
                let before = best.max();
                self.take_spare(lcp, best, |fresh| fresh < before);
            }
        }
    }

    /// Accepts the point (`None`) if its residuals are within the tolerance of the settings, unless q is smaller than the rounding errors of M z: the
    /// point then also solves problems with a very different q. Otherwise returns the breakdown.
    fn conclude(&mut self, lcp: &Lcp, residuals: Residuals, settings: &Settings) -> Option<Unsolved> {
        let cause = if residuals == Residuals::UNUSABLE {
            BreakdownCause::Overflow
        } else if !residuals.within(settings.residual_tolerance) {
            BreakdownCause::Residual(residuals)
        } else if ignores_q(residuals, lcp.q.as_slice(), &self.point.terms, &self.path.scaling.row) {
            BreakdownCause::SingularBasis
        } else {
            self.degenerate = self.point.settle_slacks(&self.basis) | self.vanishing.contains(&true);
            self.residuals = Some(residuals);
            return None;
        };
        Some(Outcome::Breakdown { pivots: self.path.pivots, cause })
    }
}
