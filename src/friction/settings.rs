//! Limits and tolerances.

use crate::lcp::{self, BreakdownCause};

/// Largest number of facets. More of them change forces by less than 1e-3, and make problems of thousands of rows.
pub(super) const MOST_CONE_FACETS: usize = 128;

/// Limits and tolerances of a solve; [`Settings::default`] is right for almost every problem.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Settings {
    /// Facets of the polygon from which Newton's method starts in space (default 8; values below 3 count as 3, above 128 as 128). More facets start
    /// closer to the cone, and cost a larger complementarity problem.
    pub facets: usize,
    /// The number of times Newton's method starts again after it did not converge (default 4). Each start has half as many facets more, turned to the
    /// slips.
    pub turns: usize,
    /// Newton's steps from each start, and in each round (default 30).
    pub steps: usize,
    /// The number of starts for many contacts, or where facets have failed: Gauss–Seidel, the central path and anchored steps (default 4,
    /// which is also the largest).
    pub starts: usize,
    /// Rounds of anchored steps of each of these starts (default 30). If no solution is found, they take most of the time.
    pub rounds: usize,
    /// Forces are called a solution only if all their [`Residuals`](super::Residuals) are at most this (default 1e-12).
    pub tolerance: f64,
    /// Settings for the complementarity problem. Up to twelve rows, three contacts in the plane, all bases are tried last.
    pub lcp: lcp::Settings,
}

impl Default for Settings {
    fn default() -> Self {
        let lcp = lcp::Settings::default().with_enumerate_up_to(12);
        Self { facets: 8, turns: 4, steps: 30, starts: 4, rounds: 30, tolerance: 1e-12, lcp }
    }
}

impl Settings {
    /// Checks that the tolerance is finite and not negative.
    pub(super) fn check(&self) -> Result<(), BreakdownCause> {
        let value = self.tolerance;
        if value.is_finite() && value >= 0.0 {
            return Ok(());
        }
        Err(BreakdownCause::Tolerance { name: "tolerance", value })
    }

    /// These settings with another number of facets, see [`Settings::facets`].
    #[must_use]
    pub fn with_facets(mut self, facets: usize) -> Self {
        self.facets = facets;
        self
    }

    /// These settings with another tolerance, see [`Settings::tolerance`].
    #[must_use]
    pub fn with_tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }
}
