//! A point z with its slacks, and its residuals.

use super::basis::Basis;
use super::principal;
use super::problem::Lcp;
use super::residuals::{Residuals, is_lost, residuals_from, slack_and_terms};
use super::tolerances::ZERO_VALUE;
use crate::numerics::IntoList;
use crate::prelude::*;
use nalgebra::DVector;

/// z, w = M z + q, and the sizes of the terms of w.
#[derive(Debug, Clone, Default)]
pub(super) struct LcpPoint {
    pub(super) z: Vec<f64>,
    pub(super) w: Vec<f64>,
    /// a_i = |q_i| + Σ_j |M_ij| |z_j|.
    pub(super) terms: Vec<f64>,
}

impl LcpPoint {
    /// The point z of a problem.
    pub(super) fn new(z: Vec<f64>, lcp: &Lcp) -> Self {
        let mut point = Self { z, ..Self::default() };
        point.sum(lcp);
        point
    }

    /// Sums w and its terms.
    fn sum(&mut self, lcp: &Lcp) {
        self.w.resize(lcp.len(), 0.0);
        self.terms.resize(lcp.len(), 0.0);
        slack_and_terms(&lcp.m, lcp.q.as_slice(), &self.z, &mut self.w, &mut self.terms);
    }

    /// Measures the violations, once w and its terms are summed.
    pub(super) fn residuals(&self, lcp: &Lcp) -> Residuals {
        residuals_from(&lcp.m, lcp.q.as_slice(), &self.z, &self.w, &self.terms)
    }

    /// Sums w and its terms and measures the violations.
    pub(super) fn evaluate(&mut self, lcp: &Lcp) -> Residuals {
        self.sum(lcp);
        self.residuals(lcp)
    }

    /// Whether w_i exceeds its tolerance; called where z_i is basic, so w_i should vanish.
    pub(super) fn has_slack(&self, i: usize, tolerance: f64) -> bool {
        self.w[i] > tolerance * self.terms[i]
    }

    /// Whether the basis of this point is singular, judged by q. Then a q_i ≠ 0 is lost in the terms of a row that must
    /// vanish, and a factorisation of the block finds no inverse.
    ///
    /// The entries of such a point are quotients of noise by noise, however small its residuals.
    pub(super) fn is_noise(&self, lcp: &Lcp, basic: impl Iterator<Item = usize> + Clone) -> bool {
        let lost = |i: usize| lcp.q[i] != 0.0 && is_lost(lcp.q[i], self.terms[i]);
        basic.clone().any(lost) && principal::solve(lcp, &basic.list()).is_none()
    }

    /// Sets w_i = 0 where z_i is basic, and negative w_i to zero elsewhere. Returns whether a
    /// basic variable is zero.
    pub(super) fn settle_slacks(&mut self, basis: &Basis) -> bool {
        let mut degenerate = false;
        for (i, w) in self.w.iter_mut().enumerate() {
            if basis.contains(i) {
                *w = 0.0;
                degenerate |= self.z[i] == 0.0;
            } else {
                degenerate |= *w <= ZERO_VALUE * self.terms[i];
                *w = w.max(0.0);
            }
        }
        degenerate
    }
}

impl Lcp {
    /// The violations of the problem at z (n entries), see [`Residuals`].
    ///
    /// A z of another length, or with entries that are not finite, solves nothing: its residuals
    /// are infinite.
    #[must_use]
    pub fn residuals(&self, z: &DVector<f64>) -> Residuals {
        if z.len() != self.len() {
            return Residuals::UNUSABLE;
        }
        LcpPoint::new(z.as_slice().to_vec(), self).residuals(self)
    }
}
