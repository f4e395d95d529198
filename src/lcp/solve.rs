//! The starts of a solve: from the slacks, from a basis, or from the dictionary of the previous
//! problem.

use super::basis::Basis;
use super::lemke::LemkeEnd;
use super::memory::refill;
use super::outcome::{Outcome, OutcomeView, Unsolved};
use super::problem::Lcp;
use super::settings::Settings;
use super::tolerances::ZERO_VALUE;
use super::workspace::Workspace;

impl Lcp {
    /// Solves the problem by Lemke's method with the default [`Settings`].
    #[must_use]
    pub fn solve(&self) -> Outcome {
        self.solve_with(&Settings::default())
    }

    /// Solves the problem by Lemke's method. An ordinary path has one to three times n pivots.
    ///
    /// The first path may end without a solution. If the caller has set a limit on pivots or a wrong covering vector, that
    /// is then the answer. Otherwise these follow, each only if those before
    /// have settled nothing:
    ///
    /// 1. the ray itself as a Farkas vector;
    /// 2. a Farkas vector from the linear program min { t : M z + q + t 1 ≥ 0, z, t ≥ 0 }
    ///    ([`Settings::prove_infeasible`]);
    /// 3. paths with other covering vectors and from other bases ([`Settings::retries`]);
    /// 4. all 2ⁿ complementary bases of a small problem ([`Settings::enumerate_up_to`]).
    ///
    /// ```
    /// use grasp_lcp::lcp::{Lcp, Outcome, Settings};
    /// use nalgebra::{DMatrix, DVector};
    ///
    /// // w = −z − 1 is negative for every z ≥ 0: y = 1 has Mᵀy = −1 ≤ 0 and qᵀy = −1 < 0.
    /// let problem = Lcp::new(DMatrix::from_element(1, 1, -1.0), DVector::from_element(1, -1.0))?;
    /// let one_path = Settings::default().with_retries(0);
    /// let Outcome::Infeasible(certificate) = problem.solve_with(&one_path) else { panic!("w < 0") };
    /// assert!(problem.proves_infeasible(&certificate.y));
    /// # Ok::<(), grasp_lcp::lcp::LcpError>(())
    /// ```
    #[must_use]
    pub fn solve_with(&self, settings: &Settings) -> Outcome {
        Workspace::new().solve(self, settings).into_outcome()
    }

    /// Solves the problem by Lemke's method from a complementary basis instead of the slacks, for
    /// example that of a neighbouring problem.
    ///
    /// Only rows that are infeasible there are covered by z₀, so the path is as short as the bases
    /// are close.
    ///
    /// A singular basis, a basis of another length, or a path that does not end in a solution lead
    /// back to [`Lcp::solve_with`]. For many q with one M use a [`Series`](super::Series).
    ///
    /// ```
    /// use grasp_lcp::lcp::{Basis, Lcp, Settings};
    /// use nalgebra::{DMatrix, DVector};
    ///
    /// // w = z - 1 is solved where z is basic: started there, no pivot is left to be made.
    /// let problem = Lcp::new(DMatrix::from_element(1, 1, 1.0), DVector::from_element(1, -1.0))?;
    /// let outcome = problem.solve_from(&Basis::from_indices(1, [0]), &Settings::default());
    /// let solution = outcome.solution().expect("M > 0");
    /// assert_eq!((solution.z[0], solution.w[0], solution.pivots), (1.0, 0.0, 0));
    /// # Ok::<(), grasp_lcp::lcp::LcpError>(())
    /// ```
    #[must_use]
    pub fn solve_from(&self, basis: &Basis, settings: &Settings) -> Outcome {
        Workspace::new().solve_from(self, basis, settings).into_outcome()
    }
}

impl Workspace {
    /// Solves a problem like [`Lcp::solve_with`].
    pub fn solve(&mut self, lcp: &Lcp, settings: &Settings) -> OutcomeView<'_> {
        let failure = match self.refuse(lcp, settings) {
            Some(refused) => Some(refused),
            None if lcp.q.iter().all(|q| *q >= 0.0) => self.accept_slack_basis(lcp, settings),
            None => self.solve_first(lcp, settings),
        };
        self.answer(failure)
    }

    /// Solves a problem like [`Lcp::solve_from`].
    pub fn solve_from(&mut self, lcp: &Lcp, basis: &Basis, settings: &Settings) -> OutcomeView<'_> {
        if let Some(refused) = self.refuse(lcp, settings) {
            return self.answer(Some(refused));
        }
        self.prepare(lcp);
        refill(&mut self.path.d, lcp.len(), 0.0);
        let fits = basis.len() == lcp.len()
            && self.path.install_basis(lcp.m.as_slice(), |i| basis.contains(i)).is_ok();
        let failure = if fits { self.resume(lcp, settings) } else { self.climb(lcp, settings) };
        self.answer(failure)
    }

    /// Solves a problem and leaves the dictionary of its basis, even if that is the slack basis.
    pub(super) fn solve_first(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Unsolved> {
        if let Some(refused) = self.refuse(lcp, settings) {
            return Some(refused);
        }
        self.prepare(lcp);
        self.climb(lcp, settings)
    }

    /// Solves for a right-hand side that belongs to the matrix whose dictionary the path holds.
    pub(super) fn solve_next(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Unsolved> {
        if let Some(refused) = self.refuse(lcp, settings) {
            return Some(refused);
        }
        self.path.set_right_hand_side(lcp.q.as_slice());
        self.path.recompute_values();
        self.resume(lcp, settings)
    }

    /// Follows the path from the present complementary basis. A failure starts again from the
    /// slacks.
    fn resume(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Unsolved> {
        let limit = settings.pivot_limit(lcp.len());
        let m = lcp.m.as_slice();
        let feasible = !self.path.cover_violations(m, ZERO_VALUE);
        if (feasible || self.path.cover_and_run(m, settings, limit) == LemkeEnd::Complementary)
            && self.finish_or_resume(lcp, settings, limit).is_none()
        {
            return None;
        }
        self.climb(lcp, settings)
    }
}
