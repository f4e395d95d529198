//! Limits, tolerances and the covering vector of a solve.

use super::outcome::BreakdownCause;
use nalgebra::DVector;

/// Limits, tolerances and the covering vector of a solve. [`Settings::default`] is right for almost
/// every problem.
///
/// Every tolerance is a pure number. The solver balances rows and columns of M first and compares
/// each quantity with the largest terms it was computed from. So no tolerance has to follow the
/// units of a problem.
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
pub struct Settings {
    /// The covering vector d of the augmented problem w = q + M z + d z₀, one entry per row, in the
    /// caller's units.
    ///
    /// Lemke's path starts at z = 0 with z₀ so large that q + d z₀ ≥ 0, and ends when z₀ reaches
    /// zero. Every entry of d must be finite and not negative, and positive where q is negative;
    /// otherwise the solve ends in [`Outcome::Breakdown`](super::Outcome::Breakdown).
    ///
    /// Another d gives another path. It may end in another solution and, on matrices without a
    /// guarantee, in a ray where this one finds a solution. `None` takes the vector of ones on the
    /// balanced problem, which makes the path independent of the units of rows, columns and q.
    pub covering: Option<DVector<f64>>,
    /// The number of pivots after which the solve gives up with
    /// [`Outcome::PivotLimit`](super::Outcome::PivotLimit).
    ///
    /// It guards against the problems on which Lemke's method takes about 2ⁿ pivots (Murty, Fathi);
    /// the tie rule excludes cycling. A number given here bounds all paths together.
    ///
    /// `None` allows 10000 + 100 n for the first path, and 100 + 10 n for each retry. Ordinary
    /// problems need one to three times n, and the exponential families are still solved up to
    /// n = 13. Smaller values cut solvable problems off, larger ones only make the exponential
    /// families run longer.
    pub max_pivots: Option<usize>,
    /// A coefficient of the entering column blocks the entering variable only if it is more than noise
    /// (default 1e-11). It must exceed this part of the largest entry of the column, at least 1 in
    /// balanced units, or of the terms of its own row.
    ///
    /// It guards against pivots on rounding noise where the true coefficient is zero. Noise is some
    /// 1e-16 times the growth of the elimination. A value below 1e-14 lets noise become a pivot and
    /// turns rays into wrong bases; one above 1e-6 overlooks real blocking rows of badly
    /// conditioned problems.
    pub pivot_tolerance: f64,
    /// Part of the decrease of a basic variable in a step below which the remaining value counts as zero (default 1e-12).
    /// Variables that are zero in this sense after the shortest step tie. A value below its own rounding error counts as zero
    /// in any case.
    ///
    /// It guards the tie rule: rows which tie in exact arithmetic must be recognised as ties, although
    /// rounding separated them. At 0 exact ties may be missed and z₀ lose one, so the path of a solved problem
    /// continues into a ray. Above 1e-8 rows that do not tie are treated as if they did, and
    /// values of that size become negative.
    pub tie_tolerance: f64,
    /// A point is called a solution only if all its [`Residuals`](super::Residuals), recomputed
    /// from the M and q given, are at most this (default 1e-10).
    ///
    /// It guards against wrong success. Solutions come out below 1e-14 unless the basis is nearly
    /// singular. A value below 1e-15 would reject correctly rounded solutions; one above 1e-6 would
    /// accept points that solve a visibly different problem.
    pub residual_tolerance: f64,
    /// Whether linear programming searches for a proof that no z ≥ 0 has M z + q ≥ 0 (default `true`), where a ray contains none.
    ///
    /// It guards against a ray where the answer is known. Up to 64 rows it takes up to four linear programs, beyond that one;
    /// each is a path of a problem of 2 n + 1 rows. Without it most problems that are infeasible end in
    /// [`Outcome::Ray`](super::Outcome::Ray), after all retries.
    pub prove_infeasible: bool,
    /// How many other covering vectors, and as many other starting bases, are tried (default 8).
    /// They follow a ray that proves nothing, a breakdown, or a first path of its default length
    /// that reached no end.
    ///
    /// With at least one retry, a solution with slacks negative by more than rounding is improved as well. Its path is followed
    /// further, with ties resolved more finely.
    ///
    /// It guards against rays on solvable problems, which other paths often avoid. The retries are
    /// fixed, so a problem takes the same paths in every solve. 0 follows one path only; more than
    /// a few dozen hardly ever find more.
    pub retries: usize,
    /// Largest n for which all 2ⁿ complementary bases are tried (default 10). That comes last, when no path has
    /// ended in a solution and no proof of infeasibility was found.
    ///
    /// It guards against missing solutions that no path reaches. Each further row doubles the cost;
    /// no n above 20 is tried.
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
    /// These settings with another covering vector, see [`Settings::covering`].
    #[must_use]
    pub fn with_covering(mut self, covering: DVector<f64>) -> Self {
        self.covering = Some(covering);
        self
    }

    /// These settings with a limit on the pivots of all paths together, see
    /// [`Settings::max_pivots`].
    #[must_use]
    pub fn with_max_pivots(mut self, max_pivots: usize) -> Self {
        self.max_pivots = Some(max_pivots);
        self
    }

    /// These settings with or without the search for a proof, see [`Settings::prove_infeasible`].
    #[must_use]
    pub fn with_prove_infeasible(mut self, prove_infeasible: bool) -> Self {
        self.prove_infeasible = prove_infeasible;
        self
    }

    /// These settings with another number of retries; 0 follows one path only. See
    /// [`Settings::retries`].
    #[must_use]
    pub fn with_retries(mut self, retries: usize) -> Self {
        self.retries = retries;
        self
    }

    /// These settings with all complementary bases tried up to another n; 0 tries none. See
    /// [`Settings::enumerate_up_to`].
    #[must_use]
    pub fn with_enumerate_up_to(mut self, enumerate_up_to: usize) -> Self {
        self.enumerate_up_to = enumerate_up_to;
        self
    }

    /// Checks that the covering vector fits a problem with this q, and that the tolerances are finite and not negative.
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

    /// Settings for one path only: for problems on which Lemke's method cannot fail, and for callers with a better next step.
    pub(crate) fn one_path() -> Self {
        Self { prove_infeasible: false, retries: 0, enumerate_up_to: 0, ..Self::default() }
    }

    /// The pivot limit for a problem of n rows.
    pub(crate) fn pivot_limit(&self, n: usize) -> usize {
        self.max_pivots.unwrap_or_else(|| 10_000_usize.saturating_add(n.saturating_mul(100)))
    }

    /// The pivot limit of one more path for a problem of n rows, after `made` pivots.
    ///
    /// It keeps a path of exponential length from being followed to its end a second time.
    pub(super) fn retry_limit(&self, n: usize, made: usize) -> usize {
        self.max_pivots.unwrap_or_else(|| made.saturating_add(100 + 10 * n))
    }
}
