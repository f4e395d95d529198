//! Problems with free variables and equality rows.

use super::basis::Basis;
use super::error::LcpError;
use super::farkas::{Domain, cleaned};
use super::outcome::{BreakdownCause, Certificate, Outcome, Unsolved};
use super::point::LcpPoint;
use super::principal;
use super::problem::Lcp;
use super::reduction::Reduction;
use super::residuals::{Residuals, ignores_q};
use super::settings::Settings;
use super::solution;
use crate::numerics::{IntoList, matrix_of, vector_of};
use crate::prelude::*;
use core::fmt;
use nalgebra::{DMatrix, DVector};

/// The mixed problem: find u (m entries, free) and z (n entries) with
///
/// ```text
/// 0 = A u + C z + b
/// 0 ≤ z  ⟂  w = D u + M z + q ≥ 0
/// ```
///
/// The free variables are eliminated by pivoting. A may be singular, as in equilibrium problems with A = 0. A free variable is then exchanged
/// with a w_i, and the z_i of that pair with an equality row. What remains is again a complementarity problem, in which w_i is the unknown of
/// pair i and z_i the slack.
///
/// The form is that of Cottle, Pang & Stone, *The Linear Complementarity Problem*, 1992, chapter 1.
///
/// ```
/// use grasp_lcp::lcp::{MixedLcp, Outcome};
/// use nalgebra::{DMatrix, DVector};
///
/// // A weight of 3 N on a spring of 2 N/m sinks by u (free) to the floor 1 m below,
/// // which pushes back with z:
/// // 0 = 2u + z − 3,  0 ≤ z ⟂ w = 1 − u ≥ 0.
/// let [a, c, d, m] = [2.0, 1.0, -1.0, 0.0].map(|entry| DMatrix::from_element(1, 1, entry));
/// let [b, q] = [-3.0, 1.0].map(|entry| DVector::from_element(1, entry));
/// let problem = MixedLcp::new(&a, &c, &d, &m, &b, &q)?;
/// let Outcome::Solved(rests) = problem.solve() else { panic!("it rests on the floor") };
/// assert_eq!((rests.u[0], rests.z[0], rests.w[0]), (1.0, 1.0, 0.0));
/// assert_eq!(problem.residuals(&rests.u, &rests.z).max(), 0.0);
/// # Ok::<(), grasp_lcp::lcp::LcpError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MixedLcp {
    /// The matrix [A, C; D, M] and the vector (b, q); the first `free` rows are equalities.
    whole: Lcp,
    free: usize,
}

/// A solution of a [`MixedLcp`].
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct MixedSolution {
    /// Free unknowns u (m entries).
    #[cfg_attr(feature = "serde", serde(serialize_with = "super::written::list"))]
    pub u: DVector<f64>,
    /// Unknowns z (n entries, none negative).
    #[cfg_attr(feature = "serde", serde(serialize_with = "super::written::list"))]
    pub z: DVector<f64>,
    /// Slacks w = D u + M z + q (n entries, none negative; exactly zero where z_i is basic).
    #[cfg_attr(feature = "serde", serde(serialize_with = "super::written::list"))]
    pub w: DVector<f64>,
    /// The basic z_i.
    pub basis: Basis,
    /// Residuals, recomputed from the given data.
    pub residuals: Residuals,
    /// Free variables that no row determines (their block is singular), counted from 0. They are set to 0; each may have any other value if the
    /// other free variables are changed accordingly.
    pub undetermined: Vec<usize>,
    /// Equality rows that follow from the others, counted from 0.
    pub dependent: Vec<usize>,
    /// Pivots of Lemke's method on the problem that gave the solution, the reduced or the split problem.
    pub pivots: usize,
}

impl fmt::Display for MixedSolution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} free, ", self.u.len())?;
        solution::line(f, &self.basis, &self.residuals, self.pivots)
    }
}

impl MixedLcp {
    /// The problem with A (m × m), C (m × n), D (n × m), M (n × n), b (m) and q (n).
    ///
    /// # Errors
    ///
    /// [`LcpError::BlockShape`] or [`LcpError::Length`] if a size does not match that of A and M.
    /// [`LcpError::MatrixEntry`] or [`LcpError::VectorEntry`] for an entry that is not finite.
    pub fn new(
        a: &DMatrix<f64>,
        c: &DMatrix<f64>,
        d: &DMatrix<f64>,
        m: &DMatrix<f64>,
        b: &DVector<f64>,
        q: &DVector<f64>,
    ) -> Result<Self, LcpError> {
        let (free, n) = (a.nrows(), m.nrows());
        let size = free + n;
        let mut whole = Lcp { m: DMatrix::zeros(size, size), q: DVector::zeros(size) };
        for (what, block, at, shape) in [
            ("A", a, (0, 0), (free, free)),
            ("C", c, (0, free), (free, n)),
            ("D", d, (free, 0), (n, free)),
            ("M", m, (free, free), (n, n)),
        ] {
            LcpError::check_block(what, block, shape)?;
            whole.m.view_mut(at, shape).copy_from(block);
        }
        for (what, vector, at, needed) in [("b", b, 0, free), ("q", q, free, n)] {
            LcpError::check_vector(what, vector, needed)?;
            whole.q.rows_mut(at, needed).copy_from(vector);
        }
        Ok(Self { whole, free })
    }

    /// The problem with the matrix [A, C; D, M] and the vector (b, q).
    #[cfg(feature = "serde")]
    pub(super) fn whole(&self) -> &Lcp {
        &self.whole
    }

    /// Number m of free variables.
    #[must_use]
    pub fn free(&self) -> usize {
        self.free
    }

    /// Number n of pairs.
    #[must_use]
    pub fn len(&self) -> usize {
        self.whole.len() - self.free
    }

    /// Whether n = 0.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// This problem without free variables, as a problem of n + 2m unknowns (u⁺, u⁻, z) with u = u⁺ − u⁻.
    ///
    /// Each equality becomes two inequalities, so the slacks are (±(A u + C z + b), w). If xᵀ[A, C; D, M]x ≥ 0 for all x = (u, z) with u free
    /// and z ≥ 0, the matrix of the split problem is copositive.
    #[must_use]
    pub fn split(&self) -> Lcp {
        let m = self.free;
        let size = self.len() + 2 * m;
        let place = |i: usize| match i {
            i if i < m => (i, 1.0),
            i if i < 2 * m => (i - m, -1.0),
            i => (i - m, 1.0),
        };
        let matrix = matrix_of(size, size, &|i, j| {
            let ((i, a), (j, b)) = (place(i), place(j));
            a * b * self.whole.m[(i, j)]
        });
        let vector = vector_of(size, &|i| place(i).1 * self.whole.q[place(i).0]);
        Lcp { m: matrix, q: vector }
    }

    /// Solves the problem with the default [`Settings`].
    #[must_use]
    pub fn solve(&self) -> Outcome<MixedSolution> {
        self.solve_with(&Settings::default())
    }

    /// Solves the problem by elimination of the free variables and, if that yields no solution, in its split form. The covering vector of the
    /// settings is not used.
    #[must_use]
    pub fn solve_with(&self, settings: &Settings) -> Outcome<MixedSolution> {
        let settings = Settings { covering: None, ..settings.clone() };
        let (m, n) = (self.free, self.len());
        let reduction = Reduction::of(&self.whole, m);
        if let Some(reduced) = &reduction.problem
            && let Outcome::Solved(solution) = reduced.solve_with(&settings)
        {
            let alpha = (0..n).filter(|i| solution.basis.contains(*i) != reduction.swapped[*i]);
            let basis = Basis::from_indices(n, alpha);
            let point = reduction.point(&solution);
            if let Ok(solution) = self.conclude(point, basis, &reduction, solution.pivots, &settings) {
                return Outcome::Solved(solution);
            }
        }
        match self.split().solve_with(&settings) {
            Outcome::Infeasible(certificate) | Outcome::NearlyInfeasible(certificate) => {
                self.joined(&certificate).into()
            }
            outcome => outcome.and_then(|solution| {
                let basis = Basis::from_indices(n, (0..n).filter(|i| solution.basis.contains(2 * m + i)));
                let z = solution.z.as_slice();
                let free = (0..m).map(|i| z[i] - z[m + i]);
                let point = free.chain(z[2 * m..].iter().copied()).list();
                match self.conclude(point, basis, &reduction, solution.pivots, &settings) {
                    Ok(solution) => Outcome::Solved(solution),
                    Err(cause) => Outcome::Breakdown { pivots: solution.pivots, cause },
                }
            }),
        }
    }

    /// Whether y (m + n entries) proves, by Farkas' lemma, that no u and z ≥ 0 satisfy A u + C z + b = 0 and D u + M z + q ≥ 0:
    ///
    /// ```text
    /// y_i ≥ 0 for i ≥ m,   [A, C; D, M]ᵀ y = 0 in the first m rows, ≤ 0 in the others,   (b, q)ᵀ y < 0
    /// ```
    ///
    /// All sums are exact, see [`Lcp::proves_infeasible`].
    #[must_use]
    pub fn proves_infeasible(&self, y: &DVector<f64>) -> bool {
        let free = |i: usize| i < self.free;
        let domain = |j| if free(j) { Domain::Free } else { Domain::NotNegative };
        self.whole.contradicts(y, free, domain)
    }

    /// Converts a certificate of the split problem to one of this problem: the two entries of each equality are subtracted.
    fn joined(&self, of_split: &Certificate) -> Unsolved {
        let (y, m) = (&of_split.y, self.free);
        let y = vector_of(self.whole.len(), &|i| if i < m { y[i] - y[m + i] } else { y[m + i] });
        let certificate = |y| Certificate { y, pivots: of_split.pivots };
        let exact = cleaned(&y).find(|y| self.proves_infeasible(y));
        match exact {
            Some(y) => Outcome::Infeasible(certificate(y)),
            None => Outcome::NearlyInfeasible(certificate(y)),
        }
    }

    /// The better of two points: the given (u, z), and the point of its basis computed from the data. An error if its residuals exceed the
    /// tolerance or its basis is singular.
    fn conclude(
        &self,
        point: Vec<f64>,
        basis: Basis,
        reduction: &Reduction,
        pivots: usize,
        settings: &Settings,
    ) -> Result<MixedSolution, BreakdownCause> {
        let m = self.free;
        let (mut residuals, mut point) = self.evaluate(point);
        let determined = (0..m).filter(|i| !reduction.undetermined.contains(i));
        let indices: Vec<usize> = determined.chain(basis.iter().map(|i| m + i)).list();
        if reduction.dependent.is_empty()
            && let Some(values) = principal::solve(&self.whole, &indices)
        {
            let mut fresh = vec![0.0; self.whole.len()];
            for (i, value) in indices.iter().zip(&values) {
                fresh[*i] = if *i < m { *value } else { value.max(0.0) };
            }
            let fresh = self.evaluate(fresh);
            if residuals.max().is_nan() || fresh.0.max() <= residuals.max() {
                (residuals, point) = fresh;
            }
        }
        if !residuals.within(settings.residual_tolerance) {
            return Err(BreakdownCause::Residual(residuals));
        }
        if ignores_q(residuals, self.whole.q.as_slice(), &point.terms, reduction.row_factors())
            || point.is_noise(&self.whole, indices.iter().copied())
        {
            return Err(BreakdownCause::SingularBasis);
        }
        let slack = |i: usize| if basis.contains(i) { 0.0 } else { point.w[m + i].max(0.0) };
        Ok(MixedSolution {
            u: DVector::from_column_slice(&point.z[..m]),
            z: DVector::from_column_slice(&point.z[m..]),
            w: vector_of(self.len(), &|i| slack(i)),
            basis,
            residuals,
            undetermined: reduction.undetermined.clone(),
            dependent: reduction.dependent.clone(),
            pivots,
        })
    }

    /// Residuals of the problem at u (m entries) and z (n entries); infinite for vectors of another length.
    #[must_use]
    pub fn residuals(&self, u: &DVector<f64>, z: &DVector<f64>) -> Residuals {
        if u.len() != self.free || z.len() != self.len() {
            return Residuals::UNUSABLE;
        }
        self.evaluate(u.iter().chain(z).copied().list()).0
    }

    fn evaluate(&self, point: Vec<f64>) -> (Residuals, LcpPoint) {
        let point = LcpPoint::new(point, &self.whole);
        let mut equality = 0.0_f64;
        for (w, terms) in point.w.iter().zip(&point.terms).take(self.free) {
            if *w != 0.0 {
                let miss = w.abs() / terms;
                equality = if miss.is_nan() { f64::INFINITY } else { equality.max(miss) };
            }
        }
        // Free unknowns and equality rows have no sign condition.
        let mut pairs = point.clone();
        pairs.z[..self.free].fill(0.0);
        pairs.w[..self.free].fill(0.0);
        (Residuals { equality, ..pairs.residuals(&self.whole) }, point)
    }
}
