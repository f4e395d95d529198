//! All solutions of a small problem 0 ≤ z ⟂ w = M z + q ≥ 0, by trying every complementary basis, i.e. every set α of the i with z_i basic.

use super::basis::Basis;
use super::point::LcpPoint;
use super::problem::Lcp;
use super::residuals::ignores_q;
use super::scaling::Scaling;
use super::settings::Settings;
use super::solution::Solution;
use super::tolerances::{MOST_ENUMERATED, ZERO_VALUE};
use super::{linear_program, principal, vertices};
use crate::numerics::tolerances::{NEGLIGIBLE, SOLVED_ROUNDING};
use crate::numerics::{Each, Reals, chosen, matrix_of, vector_of};
use crate::prelude::*;
use nalgebra::DVector;

/// The solutions found by trying all complementary bases ([`Lcp::all_solutions`]).
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct AllSolutions {
    /// One entry per solution point. Points of regular bases come first, ordered by the binary number of the basis, whose bit i is 1 if z_i is basic.
    ///
    /// A point that belongs to several bases is listed once, with [`Solution::degenerate`] set. [`Solution::pivots`] is 0.
    pub solutions: Vec<Solution>,
    /// The singular bases with a solution in their piece { z_α ≥ 0, (M z + q)_α = 0, (M z + q)_ᾱ ≥ 0 }, with z = 0 outside α. Here α is the set of i
    /// with z_i basic, and ᾱ its complement. Such a piece may be a whole face of solutions; only one point of the piece is among `solutions`.
    pub singular: Vec<Basis>,
}

impl Lcp {
    /// All solutions of a small problem, by trying all 2ⁿ complementary bases. `None` if n > 20.
    ///
    /// Each basis costs one factorisation of at most n rows, and each singular basis also a linear program.
    ///
    /// ```
    /// use grasp_lcp::lcp::Lcp;
    /// use nalgebra::{DMatrix, DVector};
    ///
    /// // w = 1 − z in both rows: z_i = 0 or z_i = 1, each by itself.
    /// let problem = Lcp::new(-DMatrix::identity(2, 2), DVector::from_element(2, 1.0))?;
    /// let all = problem.all_solutions().expect("n <= 20");
    /// let z: Vec<[f64; 2]> = all.solutions.iter().map(|solution| [solution.z[0], solution.z[1]]).collect();
    /// assert_eq!(z, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]);
    /// assert!(all.singular.is_empty());
    /// # Ok::<(), grasp_lcp::lcp::LcpError>(())
    /// ```
    #[must_use]
    pub fn all_solutions(&self) -> Option<AllSolutions> {
        self.all_solutions_with(&Settings::default())
    }

    /// All solutions of a small problem, by trying all 2ⁿ complementary bases with the given [`Settings`], of which only the tolerances matter.
    /// `None` if n > 20.
    #[must_use]
    pub fn all_solutions_with(&self, settings: &Settings) -> Option<AllSolutions> {
        (self.len() <= MOST_ENUMERATED).then(|| all_solutions(self, settings))
    }
}

/// Tries all 2ⁿ complementary bases of a problem with n rows; n is at most [`MOST_ENUMERATED`].
pub(super) fn all_solutions(lcp: &Lcp, settings: &Settings) -> AllSolutions {
    let n = lcp.len();
    let mut scaling = Scaling::default();
    scaling.balance(n, lcp.m.as_slice(), lcp.q.as_slice());
    let found = AllSolutions { solutions: Vec::new(), singular: Vec::new() };
    let mut search = Search { lcp, settings, scaling, found };
    let indices = |bits: u32| -> Vec<usize> { chosen(n, &|i| bits >> i & 1 == 1) };
    let mut without_point = Vec::new();
    for bits in 0..1_u32 << n {
        let alpha = indices(bits);
        match principal::solve(lcp, &alpha) {
            Some(basic) => drop(search.offer(&alpha, &basic)),
            None => without_point.push(bits),
        }
    }
    // Singular bases are processed last, so that solutions of regular bases come first in the list of solutions.
    for bits in without_point {
        let alpha = indices(bits);
        if let Some(basic) = search.point_of_singular_piece(&alpha)
            && let Some(basis) = search.offer(&alpha, &basic)
        {
            search.found.singular.push(basis);
        }
    }
    search.found
}

/// The first solution found at a vertex of the solution set of a singular basis, for problems in which linear programming has found none. `None`
/// if no vertex is a solution. The problem has at most [`MOST_ROWS_WITH_VERTICES`](super::tolerances::MOST_ROWS_WITH_VERTICES) rows.
pub(super) fn at_corner(lcp: &Lcp, settings: &Settings) -> Option<Solution> {
    let n = lcp.len();
    let mut scaling = Scaling::default();
    scaling.balance(n, lcp.m.as_slice(), lcp.q.as_slice());
    let found = AllSolutions { solutions: Vec::new(), singular: Vec::new() };
    let mut search = Search { lcp, settings, scaling, found };
    (1..1_u32 << n).find_map(|bits| {
        let alpha: Vec<usize> = chosen(n, &|i| bits >> i & 1 == 1);
        principal::solve(lcp, &alpha).is_none().then_some(())?;
        let _basis = vertices::of_piece(lcp, &alpha).find_map(|basic| search.offer(&alpha, &basic))?;
        search.found.solutions.pop()
    })
}

/// An enumeration of complementary bases of one problem, with the solutions found so far.
struct Search<'a> {
    lcp: &'a Lcp,
    settings: &'a Settings,
    scaling: Scaling,
    found: AllSolutions,
}

impl Search<'_> {
    /// Adds the point with the values `basic` of z_α and z = 0 elsewhere to the solutions, if it solves the problem and is new. α is the list
    /// `alpha`. A point that is already known is marked as degenerate. Returns the basis of the solution, new or known; `None` if the point is no
    /// solution.
    fn offer(&mut self, alpha: &[usize], basic: &DVector<f64>) -> Option<Basis> {
        let solution = self
            .solution_at(alpha, basic)
            .or_else(|| self.solution_at(alpha, &self.without_noise(alpha, basic)))?;
        let basis = solution.basis.clone();
        let solutions = &mut self.found.solutions;
        match solutions.iter_mut().find(|known| is_one_point(&known.z, &solution.z)) {
            Some(known) => known.degenerate = true,
            None => solutions.push(solution),
        }
        Some(basis)
    }

    /// The values `basic` of z_α, with zero in place of values that are zero up to rounding.
    ///
    /// If they were not replaced, rounding noise would decide the sign of the slack w in a row whose other terms are all zero. If a replaced value
    /// was not noise, the residuals become large.
    fn without_noise(&self, alpha: &[usize], basic: &DVector<f64>) -> DVector<f64> {
        let size = |j: usize| basic[j].abs() / self.scaling.column[alpha[j]];
        let largest = (0..alpha.len()).map(size).most();
        vector_of(alpha.len(), &|j| if size(j) <= ZERO_VALUE * largest { 0.0 } else { basic[j] })
    }

    /// The solution with the values `basic` of z_α and z = 0 elsewhere. `None` if the residuals of this point exceed the tolerance, or if q is
    /// smaller than the rounding errors of M z.
    fn solution_at(&self, alpha: &[usize], basic: &DVector<f64>) -> Option<Solution> {
        let (lcp, tolerance) = (self.lcp, self.settings.residual_tolerance);
        let mut z = vec![0.0; lcp.len()];
        for (i, value) in alpha.iter().zip(basic) {
            z[*i] = *value;
        }
        let mut point = LcpPoint::new(z, lcp);
        // Residuals are checked before negative entries of z are set to zero, so that a point with entries more negative than noise fails.
        if !point.residuals(lcp).within(tolerance) {
            return None;
        }
        for z in &mut point.z {
            *z = z.max(0.0);
        }
        let residuals = point.evaluate(lcp);
        if !residuals.within(tolerance)
            || alpha.iter().any(|i| point.has_slack(*i, tolerance))
            || ignores_q(residuals, lcp.q.as_slice(), &point.terms, &self.scaling.row)
        {
            return None;
        }
        let basis = Basis::from_indices(lcp.len(), alpha.iter().copied());
        let degenerate = point.settle_slacks(&basis);
        let [z, w] = [point.z, point.w].each(DVector::from_vec);
        Some(Solution { z, w, basis, residuals, pivots: 0, degenerate })
    }

    /// The z_α of a point of the piece { z_α ≥ 0, (M z + q)_α = 0, (M z + q)_ᾱ ≥ 0 } for a singular block M_αα. A linear program finds the point with
    /// the least violation of these conditions. If the piece is empty, this point violates a condition, so that the caller must check its residuals.
    /// `None` if rounding prevents the solution of the program.
    ///
    /// If the piece has many points, the point found depends on the scaling of rows and columns. Here their scale factors are not rounded to powers
    /// of two, so that the point does not depend on units.
    fn point_of_singular_piece(&self, alpha: &[usize]) -> Option<DVector<f64>> {
        let Self { lcp, scaling, .. } = self;
        let n = lcp.len();
        let row = |i: usize| scaling.row[i] / scaling.row_unit[i];
        let column = |j: usize| scaling.column[j] * scaling.column_unit(j);
        let m = matrix_of(n, n, &|i, j| row(i) * lcp.m[(i, j)] * column(j));
        let q = vector_of(n, &|i| row(i) * lcp.q[i]);
        let program = linear_program::of_piece((&m, &q), alpha, 0.0, self.settings)?;
        Some(vector_of(alpha.len(), &|j| program.x[j] * column(alpha[j])))
    }
}

/// Whether two points differ only by rounding. The difference of each entry is compared with this entry and with the largest entry of both points.
fn is_one_point(a: &DVector<f64>, b: &DVector<f64>) -> bool {
    let size = a.amax().max(b.amax());
    a.iter().zip(b).all(|(a, b)| {
        let difference = (a - b).abs();
        // The first limit allows for the errors of bases with condition numbers up to 1e7, the second for entries that are zero up to rounding.
        difference <= NEGLIGIBLE * a.abs().max(b.abs()) || difference <= SOLVED_ROUNDING * size
    })
}
