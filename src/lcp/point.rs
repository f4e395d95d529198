//! A point and how well it solves the problem.

use super::problem::Lcp;
use super::residuals::{Residuals, residuals_from, slack_and_terms};

/// z, w = M z + q, and the sizes of the terms of w.
#[derive(Debug, Clone, Default)]
pub(super) struct Point {
    pub(super) z: Vec<f64>,
    pub(super) w: Vec<f64>,
    pub(super) terms: Vec<f64>,
}

impl Point {
    pub(super) fn evaluate(&mut self, lcp: &Lcp) -> Residuals {
        let n = lcp.len();
        self.w.resize(n, 0.0);
        self.terms.resize(n, 0.0);
        slack_and_terms(&lcp.m, lcp.q.as_slice(), &self.z, &mut self.w, &mut self.terms);
        residuals_from(&lcp.m, &self.z, &self.w, &self.terms)
    }
}
