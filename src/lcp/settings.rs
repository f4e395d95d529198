//! Limits, tolerances and the covering vector of a solve. The problem is 0 ≤ z ⟂ w = M z + q ≥ 0. Lemke's method pivots along a path of bases, which
//! ends in a solution or in a ray, along which the covering variable never vanishes.

use super::outcome::BreakdownCause;
use nalgebra::DVector;

/// Limits, tolerances and the covering vector of a solve. [`Settings::default`] suits almost every problem.
///
/// Every tolerance is without units. The solver balances rows and columns of M first and compares each quantity with the largest terms from
/// which it was computed. Tolerances therefore need not follow the units of a problem.
///
/// ```
/// use grasp_lcp::lcp::{Lcp, Outcome, Settings};
/// use nalgebra::{DMatrix, DVector};
///
/// // Two pairs on the diagonal, both negative at z = 0: both have to be exchanged, which takes
/// // three pivots with z₀.
/// let problem = Lcp::new(DMatrix::identity(2, 2), DVector::from_vec(vec![-1.0, -2.0]))?;
/// let one_path = Settings::default().with_retries(0).with_enumerate_up_to(0);
/// assert!(problem.solve_with(&one_path.clone().with_max_pivots(3)).solution().is_some());
/// let cut_off = problem.solve_with(&one_path.with_max_pivots(2));
/// assert_eq!(cut_off, Outcome::PivotLimit { pivots: 2 });
/// # Ok::<(), grasp_lcp::lcp::LcpError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
#[must_use]
pub struct Settings {
    /// The covering vector d of the augmented problem w = q + M z + d z₀, one entry per row, in the
    /// caller's units.
    ///
    /// Lemke's path starts at z = 0 with z₀ so large that q + d z₀ ≥ 0, and ends when z₀ reaches zero. Every entry of d must be finite and
    /// nonnegative, and positive where q is negative; otherwise the solve ends in [`Outcome::Breakdown`](super::Outcome::Breakdown).
    ///
    /// Another d gives another path, which may end in another solution. For matrices on which Lemke's method is not guaranteed to succeed, it may
    /// also end in a ray although the path of the default d finds a solution. `None` means the vector of ones after rows and columns have been scaled
    /// such that nonzero entries of M lie near 1. This makes the path independent of the units of rows, columns and q.
    pub covering: Option<DVector<f64>>,
    /// Limit on the number of pivots. A solve that reaches a given limit ends with [`Outcome::PivotLimit`](super::Outcome::PivotLimit).
    ///
    /// The limit guards against problems on which Lemke's method takes about 2ⁿ pivots (Murty, Fathi); the tie rule excludes cycling. A given limit
    /// bounds the sum over all paths of a solve.
    ///
    /// `None` allows 10000 + 100 n pivots for the first path, and 100 + 10 n for each retry. Ordinary problems need n to 3 n pivots, and problems
    /// that need about 2ⁿ pivots are solved up to n = 13. A smaller limit stops solvable problems. A larger limit only lengthens the solves that need
    /// about 2ⁿ pivots.
    pub max_pivots: Option<usize>,
    /// Relative magnitude from which a coefficient of the entering column can block the entering variable; smaller coefficients are noise (default
    /// 1e-11). The coefficient must exceed this fraction of the largest entry of the column, or of the terms that were summed to compute the
    /// coefficient. The largest entry counts as at least 1, after M has been scaled such that its nonzero entries lie near 1.
    ///
    /// The tolerance guards against pivots on rounding errors where the true coefficient is zero. These errors are some 1e-16 times the growth of the
    /// elimination. If the tolerance is below 1e-14, rounding errors become pivots, and a path that should end in a ray continues to wrong bases. If
    /// it is above 1e-6, true blocking rows of ill-conditioned problems are overlooked.
    pub pivot_tolerance: f64,
    /// After a step of the entering variable, a basic variable counts as zero if its value is at most this fraction of its decrease in the step
    /// (default 1e-12). Variables that are zero in this sense after the shortest step tie. A value below its own rounding error counts as zero in any
    /// case.
    ///
    /// The tolerance is needed by the tie rule: rows that tie in exact arithmetic must be recognised as ties although rounding separates them. If the
    /// tolerance is 0, exact ties may be missed, and if z₀ then does not leave, the path of a solvable problem continues into a ray. If it is above
    /// 1e-8, rows that do not tie are treated as ties, and basic variables may become negative by this fraction.
    pub tie_tolerance: f64,
    /// Largest [`Residuals`](super::Residuals), recomputed from the given M and q, with which a point is accepted as a solution (default 1e-10).
    ///
    /// The tolerance guards against false solutions. Computed solutions have residuals below 1e-14 unless the basis is nearly singular. If the
    /// tolerance is below 1e-15, correctly rounded solutions are rejected. If it is above 1e-6, points are accepted that solve a visibly different
    /// problem.
    pub residual_tolerance: f64,
    /// Whether linear programming searches for a proof that no z ≥ 0 satisfies M z + q ≥ 0, if a ray contains no proof (default `true`).
    ///
    /// The proof decides problems that otherwise end in a ray. Up to 64 rows the search solves up to four linear programs, for more rows one. Each
    /// program takes as long as one path of a problem of 2 n + 1 rows. If this search is switched off, most infeasible problems end in
    /// [`Outcome::Ray`](super::Outcome::Ray), after all retries.
    pub prove_infeasible: bool,
    /// Number of retries (default 8). Each retry follows a path with another covering vector and, if that fails, a path from another starting basis.
    /// Retries come after a ray that proves nothing, a breakdown, or a first path that reached its default limit.
    ///
    /// With at least one retry, a solution whose slacks are negative by more than rounding is improved as well: its path is continued with ties
    /// resolved more finely.
    ///
    /// Retries guard against rays on solvable problems, which other paths often avoid. The retries are deterministic, so a problem takes the same
    /// paths in every solve. With 0 only one path is followed. More than a few dozen retries rarely solve further problems.
    pub retries: usize,
    /// Largest n for which all 2ⁿ complementary bases are tried (default 10). The bases are tried last, if no path ended in a solution and no proof
    /// of infeasibility was found.
    ///
    /// The search finds solutions that no path reaches. Each further row doubles the cost; for n above 20 the bases are never tried.
    pub enumerate_up_to: usize,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            covering: None,
            max_pivots: None,
            pivot_tolerance: 1e-11,
            tie_tolerance: 1e-12,
            residual_tolerance: 1e-10,
            prove_infeasible: true,
            retries: 8,
            enumerate_up_to: 10,
        }
    }
}

impl Settings {
    setters! {
        /// These settings with another covering vector ([`Settings::covering`]).
        pub fn with_covering(mut self, covering: DVector<f64>) { self.covering = Some(covering); }

        /// These settings with a limit on the number of pivots of all Lemke paths of a solve together ([`Settings::max_pivots`]).
        pub fn with_max_pivots(mut self, max_pivots: usize) { self.max_pivots = Some(max_pivots); }

        /// These settings with or without the search for a proof by linear programming ([`Settings::prove_infeasible`]).
        pub fn with_prove_infeasible(mut self, prove_infeasible: bool) {
            self.prove_infeasible = prove_infeasible;
        }

        /// These settings with another number of retries; with 0 only one path is followed ([`Settings::retries`]).
        pub fn with_retries(mut self, retries: usize) { self.retries = retries; }

        /// These settings with another largest n for which all complementary bases are tried; with 0 none are tried ([`Settings::enumerate_up_to`]).
        pub fn with_enumerate_up_to(mut self, enumerate_up_to: usize) {
            self.enumerate_up_to = enumerate_up_to;
        }
    }

    /// Checks that the tolerances are finite and not negative, and that the covering vector, if one is set, fits a problem with this q. The error is
    /// the first fault.
    pub(super) fn check(&self, q: &DVector<f64>) -> Result<(), BreakdownCause> {
        for (name, value) in [
            ("pivot_tolerance", self.pivot_tolerance),
            ("tie_tolerance", self.tie_tolerance),
            ("residual_tolerance", self.residual_tolerance),
        ] {
            if !(value.is_finite() && value >= 0.0) {
                return Err(BreakdownCause::Tolerance { name, value });
            }
        }
        let Some(d) = &self.covering else { return Ok(()) };
        if d.len() != q.len() {
            return Err(BreakdownCause::CoveringLength { given: d.len(), needed: q.len() });
        }
        let fits = |d: f64, q: f64| d.is_finite() && d >= 0.0 && !(q < 0.0 && d == 0.0);
        match d.iter().zip(q).position(|(d, q)| !fits(*d, *q)) {
            Some(row) => Err(BreakdownCause::CoveringEntry { row, value: d[row] }),
            None => Ok(()),
        }
    }

    /// Settings with which a single path is followed: without a linear program for a proof, without retries, and without trying all 2ⁿ bases. Such
    /// settings are for problems on which Lemke's method cannot fail, and for callers that have a better alternative to retries.
    pub(crate) fn one_path() -> Self {
        Self { prove_infeasible: false, retries: 0, enumerate_up_to: 0, ..Self::default() }
    }

    /// The limit on the pivots of a first path of a problem of n rows: the caller's limit, otherwise 10000 + 100 n.
    pub(crate) fn pivot_limit(&self, n: usize) -> usize {
        self.max_pivots.unwrap_or_else(|| 10_000_usize.saturating_add(n.saturating_mul(100)))
    }

    /// For a retry of a problem of n rows, the limit on the pivots of all paths together. It is the caller's limit if one is set. Otherwise it is
    /// `made`, the number of pivots of all earlier paths, plus 100 + 10 n.
    ///
    /// A path that needs about 2ⁿ pivots is thus not followed to its end a second time.
    pub(super) fn retry_limit(&self, n: usize, made: usize) -> usize {
        self.max_pivots.unwrap_or_else(|| made.saturating_add(100 + 10 * n))
    }
}
