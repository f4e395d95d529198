//! Limits and tolerances.

use crate::lcp::{self, BreakdownCause};

/// More facets than these miss the cone by less than 1e-3 of their forces, and make problems of thousands of rows.
pub(super) const MOST_FACETS: usize = 128;

/// Limits and tolerances of a solve; [`Settings::default`] is right for almost every problem.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Settings {
    /// Facets of the polygon from which Newton's method sets out in space (default 8; less than 3 count as 3, more than 128 as 128). More of them start closer to the
    /// cone, and cost a larger complementarity problem.
    pub facets: usize,
    /// How often Newton's method starts again when it did not arrive, each time from half as many facets more, turned to where
    /// contacts slide (default 4).
    pub turns: usize,
    /// Newton's steps from each start, and in each round (default 30).
    pub steps: usize,
    /// How often it sets out anew for many contacts, or where facets have led nowhere: by Gauss–Seidel, the central path and anchored steps (default 4,
    /// which is the most).
    pub starts: usize,
    /// Rounds of anchored steps of each of these starts (default 30). They take most of the time where nothing is found.
    pub rounds: usize,
    /// Forces are called a solution only if all their [`Residuals`](super::Residuals) are at most this (default 1e-12).
    pub tolerance: f64,
    /// For the complementarity problem. Up to twelve rows, three contacts in the plane, all bases are tried at last.
    pub lcp: lcp::Settings,
}

impl Default for Settings {
    fn default() -> Self {
        let lcp = lcp::Settings::default().with_enumerate_up_to(12);
        Self { facets: 8, turns: 4, steps: 30, starts: 4, rounds: 30, tolerance: 1e-12, lcp }
    }
}

impl Settings {
    /// Refuses a tolerance that is none.
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
