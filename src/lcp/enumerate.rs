//! All solutions of a small problem.

use super::basis::Basis;
use super::linear_program::least_violation;
use super::outcome::Solution;
use super::point::Point;
use super::principal;
use super::problem::Lcp;
use super::residuals::ignores_q;
use super::scaling::Scaling;
use super::settings::Settings;
use super::tolerances::{SAME_ENTRY, SAME_POINT, ZERO};
use nalgebra::{DMatrix, DVector};

/// The largest n for which 2ⁿ bases are tried.
pub(crate) const LARGEST: usize = 20;

/// The solutions found by trying all complementary bases.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct AllSolutions {
    /// One entry for each solution point, in the order of the bases read as binary numbers (z_0 is the lowest bit),
    /// regular bases first.
    /// A point for which several bases stand is listed once, with `degenerate` set. `pivots` is 0.
    pub solutions: Vec<Solution>,
    /// The singular bases whose piece { z_α ≥ 0, (M z + q)_α = 0, (M z + q)_ᾱ ≥ 0 } is not empty. Such a piece may be
    /// a whole face of solutions; one point of it is among the solutions.
    pub singular: Vec<Basis>,
}

impl Lcp {
    /// All solutions of a small problem, by trying all 2ⁿ complementary bases: one factorisation of at most n rows each, and a linear
    /// program for each singular one. `None` if n > 20. Of the settings only the tolerances count.
    ///
    /// ```
    /// use grasp_lcp::lcp::{Lcp, Settings};
    /// use nalgebra::{DMatrix, DVector};
    ///
    /// // w = 1 − z in both rows: z_i = 0 or z_i = 1, each by itself.
    /// let problem = Lcp::new(-DMatrix::identity(2, 2), DVector::from_element(2, 1.0))?;
    /// let all = problem.all_solutions(&Settings::default()).expect("n <= 20");
    /// let z: Vec<[f64; 2]> = all.solutions.iter().map(|solution| [solution.z[0], solution.z[1]]).collect();
    /// assert_eq!(z, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]);
    /// assert!(all.singular.is_empty());
    /// # Ok::<(), grasp_lcp::lcp::LcpError>(())
    /// ```
    #[must_use]
    pub fn all_solutions(&self, settings: &Settings) -> Option<AllSolutions> {
        (self.len() <= LARGEST).then(|| all_solutions(self, settings))
    }
}

/// Tries all 2ⁿ complementary bases; n is at most [`LARGEST`].
pub(crate) fn all_solutions(lcp: &Lcp, settings: &Settings) -> AllSolutions {
    let n = lcp.len();
    let mut all = AllSolutions { solutions: Vec::new(), singular: Vec::new() };
    let indices = |bits: u32| -> Vec<usize> { (0..n).filter(|i| bits >> i & 1 == 1).collect() };
    let mut scaling = Scaling::default();
    scaling.balance(n, lcp.m.as_slice(), lcp.q.as_slice());
    let mut without_point = Vec::new();
    for bits in 0..1_u32 << n {
        let alpha = indices(bits);
        match principal::solve(lcp, &alpha) {
            Some(basic) => {
                let _ = all.offer(lcp, &scaling, &alpha, &basic, settings);
            }
            None => without_point.push(bits),
        }
    }
    // Singular bases come last, so that the first basis listed is a regular one if any is.
    for bits in without_point {
        let alpha = indices(bits);
        if let Some(basic) = point_of_singular_piece(lcp, &scaling, &alpha, settings)
            && let Some(basis) = all.offer(lcp, &scaling, &alpha, &basic, settings)
        {
            all.singular.push(basis);
        }
    }
    all
}

impl AllSolutions {
    /// Adds the point with these basic values if it is a solution not known yet; its basis if it is one at all.
    fn offer(
        &mut self,
        lcp: &Lcp,
        scaling: &Scaling,
        alpha: &[usize],
        basic: &DVector<f64>,
        settings: &Settings,
    ) -> Option<Basis> {
        let solution = solution_at(lcp, scaling, alpha, basic, settings)
            .or_else(|| solution_at(lcp, scaling, alpha, &without_noise(scaling, alpha, basic), settings))?;
        let basis = solution.basis.clone();
        match self.solutions.iter_mut().find(|known| same_point(lcp, known, &solution)) {
            Some(known) => known.degenerate = true,
            None => self.solutions.push(solution),
        }
        Some(basis)
    }
}

/// The point without what is zero but for rounding. The sign of such noise would decide in rows whose other terms are all
/// zero; where it was not noise, the rows show it.
fn without_noise(scaling: &Scaling, alpha: &[usize], basic: &DVector<f64>) -> DVector<f64> {
    let size = |j: usize| basic[j].abs() / scaling.column[alpha[j]];
    let largest = (0..alpha.len()).map(size).fold(0.0, f64::max);
    DVector::from_fn(alpha.len(), |j, _| if size(j) <= ZERO * largest { 0.0 } else { basic[j] })
}

fn solution_at(
    lcp: &Lcp,
    scaling: &Scaling,
    alpha: &[usize],
    basic: &DVector<f64>,
    settings: &Settings,
) -> Option<Solution> {
    let tolerance = settings.residual_tolerance;
    let mut z = vec![0.0; lcp.len()];
    for (i, value) in alpha.iter().zip(basic) {
        z[*i] = *value;
    }
    let mut point = Point { z, ..Point::default() };
    // With its negative entries first: those that are more than noise must not be cut off.
    if !point.evaluate(lcp).within(tolerance) {
        return None;
    }
    point.z.iter_mut().for_each(|z| *z = z.max(0.0));
    let residuals = point.evaluate(lcp);
    if !residuals.within(tolerance)
        || alpha.iter().any(|i| point.has_slack(*i, tolerance))
        || ignores_q(residuals, lcp.q.as_slice(), &point.terms, &scaling.row)
    {
        return None;
    }
    let basis = Basis::from_indices(lcp.len(), alpha.iter().copied());
    let degenerate = point.settle_slacks(&basis);
    let [z, w] = [point.z, point.w].map(DVector::from_vec);
    Some(Solution { z, w, basis, residuals, pivots: 0, degenerate })
}

/// Whether two points differ by no more than rounding, entry by entry or measured by the largest entry.
fn same_point(lcp: &Lcp, a: &Solution, b: &Solution) -> bool {
    let size = a.z.amax().max(b.z.amax());
    (0..lcp.len()).all(|i| {
        let difference = (a.z[i] - b.z[i]).abs();
        difference <= SAME_ENTRY * a.z[i].abs().max(b.z[i].abs()) || difference <= SAME_POINT * size
    })
}

/// A point of { z_α ≥ 0, (M z + q)_α = 0, (M z + q)_ᾱ ≥ 0 } by linear programming on balanced data; the caller checks it. The
/// balance is exact here, not rounded to powers of two, so that the same point of a face is found in any units.
fn point_of_singular_piece(
    lcp: &Lcp,
    scaling: &Scaling,
    alpha: &[usize],
    settings: &Settings,
) -> Option<DVector<f64>> {
    let n = lcp.len();
    let k = alpha.len();
    let balanced_row = |i: usize| scaling.row[i] / scaling.row_unit[i];
    let column = |j: usize| scaling.column[alpha[j]] * scaling.column_unit(alpha[j]);
    let row = |i: usize| {
        if i < n { (i, balanced_row(i)) } else { (alpha[i - n], -balanced_row(alpha[i - n])) }
    };
    let a = DMatrix::from_fn(n + k, k, |i, j| {
        let (i, factor) = row(i);
        factor * lcp.m[(i, alpha[j])] * column(j)
    });
    let load = (0..n).fold(0.0_f64, |load, i| load.max((lcp.q[i] * balanced_row(i)).abs()));
    let load = if load > 0.0 { load } else { 1.0 };
    let b = DVector::from_fn(n + k, |i, _| row(i).1 * lcp.q[row(i).0] / load);
    let program = least_violation(&a, &b, settings)?;
    Some(DVector::from_fn(k, |j, _| program.x[j] * column(j) * load))
}
