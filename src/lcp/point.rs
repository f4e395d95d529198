//! A point z with its slacks w = M z + q, and its residuals.

use super::basis::Basis;
use super::problem::Lcp;
use super::residuals::{Residuals, residuals_from, slack_and_terms};
use super::tolerances::ZERO_VALUE;
use crate::prelude::*;
use nalgebra::DVector;

/// A point z, its slacks w = M z + q, and the magnitudes of the terms of each w_i.
#[derive(Debug, Clone, Default)]
pub(super) struct LcpPoint {
    pub(super) z: Vec<f64>,
    pub(super) w: Vec<f64>,
    /// Magnitude of the terms of w_i: a_i = |q_i| + Σ_j |M_ij| |z_j|.
    pub(super) terms: Vec<f64>,
}

impl LcpPoint {
    /// The point z of a problem, with its slacks and the magnitudes of their terms.
    pub(super) fn new(z: Vec<f64>, lcp: &Lcp) -> Self {
        let mut point = Self { z, ..Self::default() };
        point.sum(lcp);
        point
    }

    fn sum(&mut self, lcp: &Lcp) {
        self.w.resize(lcp.len(), 0.0);
        self.terms.resize(lcp.len(), 0.0);
        slack_and_terms(&lcp.m, lcp.q.as_slice(), &self.z, &mut self.w, &mut self.terms);
    }

    /// The residuals of the problem at this point z. `w` and `terms` must have been computed.
    pub(super) fn residuals(&self, lcp: &Lcp) -> Residuals {
        residuals_from(&lcp.m, lcp.q.as_slice(), &self.z, &self.w, &self.terms)
    }

    pub(super) fn evaluate(&mut self, lcp: &Lcp) -> Residuals {
        self.sum(lcp);
        self.residuals(lcp)
    }

    /// Whether w_i exceeds `tolerance` times the magnitude of its terms. Callers use this for basic z_i, whose w_i should vanish.
    pub(super) fn has_slack(&self, i: usize, tolerance: f64) -> bool {
        self.w[i] > tolerance * self.terms[i]
    }

    /// Sets the slack w_i to zero where z_i is basic, and negative w_i to zero elsewhere. Returns whether the point is degenerate: a basic z_i
    /// is exactly zero, or a basic w_i is zero up to rounding.
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
    /// The residuals of the problem at z (n entries), relative to the magnitudes of their terms.
    ///
    /// The residuals are infinite for a z of another length or with entries that are not finite.
    #[must_use]
    pub fn residuals(&self, z: &DVector<f64>) -> Residuals {
        if z.len() != self.len() {
            return Residuals::UNUSABLE;
        }
        LcpPoint::new(z.as_slice().to_vec(), self).residuals(self)
    }
}
