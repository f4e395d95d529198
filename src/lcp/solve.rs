//! The starts of a solve: from the slack basis, from a given basis, or from the dictionary of the previous problem. A dictionary is the condensed
//! tableau of one basis. In the slack basis every slack w_i of w = M z + q is basic. Lemke's path runs through solutions of w = M z + q + d z₀ with a
//! covering vector d and a covering variable z₀.

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

    /// Solves the problem by Lemke's method. An ordinary path has n to 3 n pivots.
    ///
    /// The first path may end without a solution. If it ended because of a pivot limit or an invalid covering vector that the caller has set, this
    /// outcome is returned. Otherwise the following attempts are made until one decides the problem. A ray is an end of the path along which the
    /// covering variable never vanishes. A Farkas vector y ≥ 0 with Mᵀy ≤ 0 and qᵀy < 0 proves that no solution exists.
    ///
    /// 1. the ray itself as a Farkas vector;
    /// 2. a Farkas vector from the linear program min { t : M z + q + t 1 ≥ 0, z, t ≥ 0 }
    ///    ([`Settings::prove_infeasible`]);
    /// 3. paths with other covering vectors and from other bases ([`Settings::retries`]);
    /// 4. all 2ⁿ complementary bases of a problem with n rows, for n up to [`Settings::enumerate_up_to`].
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

    /// Solves the problem by Lemke's method from a complementary basis instead of the slack basis, for example from the solution of a
    /// neighbouring problem.
    ///
    /// The covering variable z₀ of w = q + M z + d z₀ covers only the rows whose basic variable is negative for this basis. The path is therefore
    /// short if the basis is close to the basis of the solution.
    ///
    /// If the basis is singular or has another length, or if the path does not end in a solution, [`Lcp::solve_with`] takes over. For many q
    /// with the same M use a [`Series`](super::Series).
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
    /// Solves a problem by Lemke's method from the slack basis, as [`Lcp::solve_with`] does, in the scratch buffers of this workspace.
    pub fn solve(&mut self, lcp: &Lcp, settings: &Settings) -> OutcomeView<'_> {
        let failure = match self.refuse(lcp, settings) {
            Some(refused) => Some(refused),
            None if lcp.q.iter().all(|q| *q >= 0.0) => self.accept_slack_basis(lcp, settings),
            None => self.solve_first(lcp, settings),
        };
        self.answer(failure)
    }

    /// Solves a problem by Lemke's method from the complementary basis `basis`, as [`Lcp::solve_from`] does, in the scratch buffers of this
    /// workspace.
    pub fn solve_from(&mut self, lcp: &Lcp, basis: &Basis, settings: &Settings) -> OutcomeView<'_> {
        if let Some(refused) = self.refuse(lcp, settings) {
            return self.answer(Some(refused));
        }
        self.prepare(lcp);
        refill(&mut self.path.d, lcp.len(), 0.0);
        let fits = basis.len() == lcp.len()
            && self.path.install_basis(lcp.m.as_slice(), &|i| basis.contains(i)).is_ok();
        let failure = if fits { self.resume(lcp, settings) } else { self.climb(lcp, settings) };
        self.answer(failure)
    }

    /// Solves the problem like [`Self::solve`], but without the shortcut that returns z = 0 for q ≥ 0. The workspace thus always holds the dictionary
    /// at the end of Lemke's path, which [`Self::solve_next`] needs. `None` if the problem is solved.
    pub(super) fn solve_first(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Unsolved> {
        if let Some(refused) = self.refuse(lcp, settings) {
            return Some(refused);
        }
        self.prepare(lcp);
        self.climb(lcp, settings)
    }

    /// Solves the problem for a new right-hand side q, starting from the dictionary of the last basis, which the workspace holds for the same
    /// matrix M. `None` if the problem is solved.
    pub(super) fn solve_next(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Unsolved> {
        if let Some(refused) = self.refuse(lcp, settings) {
            return Some(refused);
        }
        self.path.set_right_hand_side(lcp.q.as_slice());
        self.path.recompute_values();
        self.resume(lcp, settings)
    }

    /// Follows Lemke's path from the complementary basis that the dictionary holds. If this path does not end in a solution, the solve starts
    /// again from the slack basis. `None` if a solution is found.
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
