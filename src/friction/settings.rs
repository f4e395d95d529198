//! Limits and tolerances for the solution of a frictional contact problem: contact forces and velocities that satisfy Coulomb's law with round cones.
//!
//! In space each round cone is first replaced by a polygonal cone with plane facets, which gives a linear complementarity problem. Newton's method on
//! the round cones starts from the forces that solve this problem. If this fails, iterative methods follow.

use crate::lcp::{self, BreakdownCause};

/// Upper limit of the number of facets of a polygonal cone. More facets change forces by less than a thousandth, and give complementarity problems of
/// thousands of rows.
pub(super) const MOST_CONE_FACETS: usize = 128;

/// Limits and tolerances of a solve. [`Settings::default`] suits almost every problem.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
#[must_use]
pub struct Settings {
    /// Number of facets of each polygonal cone in the complementarity problem from which Newton's method starts in space (default 8; at least 3, at
    /// most 128). With more facets Newton's method starts closer to the solution on the round cones, but the complementarity problem is larger.
    pub facets: usize,
    /// In space, the largest number of restarts if Newton's method does not converge (default 4). Each restart solves the problem with polygonal
    /// cones again, with 1.5 times as many facets, rotated towards the slip directions.
    pub turns: usize,
    /// Largest number of Newton steps in one run of Newton's method (default 30). A run starts from the solution with polygonal cones, or is a round
    /// of anchored Newton steps. In these a proximal term holds the forces near given forces, the anchor.
    pub steps: usize,
    /// Largest number of starts of the iterative methods (default and maximum 4). These methods are used if polygonal cones have led to no solution.
    /// Polygonal cones are not tried for more than 40 contacts that affect one another in the plane, or 16 in space with 8 facets. Each start makes
    /// Gauss–Seidel sweeps, follows the central path and makes anchored Newton steps.
    pub starts: usize,
    /// Largest number of rounds of anchored Newton steps in each of the `starts` (default 30). Rounds take most of the time if no solution is found.
    pub rounds: usize,
    /// Forces are accepted as a solution if none of their [`Residuals`](super::Residuals), which have no unit, exceeds this (default 1e-12).
    pub tolerance: f64,
    /// Settings of the complementarity problem with polygonal cones. If this problem has up to twelve rows (three contacts in the plane), the last
    /// resort is to try all complementary bases.
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

    setters! {
        /// These settings with another number of facets of each polygonal cone ([`Settings::facets`]).
        pub fn with_facets(mut self, facets: usize) { self.facets = facets; }

        /// These settings with another limit of the residuals of a solution ([`Settings::tolerance`]).
        pub fn with_tolerance(mut self, tolerance: f64) { self.tolerance = tolerance; }
    }
}
