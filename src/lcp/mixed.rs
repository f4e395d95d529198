//! Problems with free variables and equality rows.

use super::basis::Basis;
use super::error::LcpError;
use super::outcome::Outcome;
use super::principal;
use super::problem::Lcp;
use super::reduction::Reduction;
use super::residuals::{Residuals, residuals_from, slack_and_terms};
use super::settings::Settings;
use nalgebra::{DMatrix, DVector};

/// The mixed problem: find u (m entries, free) and z (n entries) with
///
/// ```text
/// 0 = A u + C z + b
/// 0 ≤ z  ⟂  w = D u + M z + q ≥ 0
/// ```
///
/// The free variables are eliminated by pivoting. Where A is singular, as in problems of equilibrium with A = 0, a free
/// variable is exchanged with a w_i and the z_i of the same pair with an equality row, which keeps the rest a
/// complementarity problem: the pair i then changes its roles.
///
/// ```
/// use grasp_lcp::lcp::{MixedLcp, MixedOutcome};
/// use nalgebra::{DMatrix, DVector};
///
/// // A weight of 3 N on a spring of 2 N/m sinks by u (free) to the floor 1 m below, which pushes back with z:
/// // 0 = 2u + z − 3,  0 ≤ z ⟂ w = 1 − u ≥ 0.
/// let [a, c, d, m] = [2.0, 1.0, -1.0, 0.0].map(|entry| DMatrix::from_element(1, 1, entry));
/// let [b, q] = [-3.0, 1.0].map(|entry| DVector::from_element(1, entry));
/// let problem = MixedLcp::new(&a, &c, &d, &m, &b, &q)?;
/// let MixedOutcome::Solved(rests) = problem.solve() else { panic!("it rests on the floor") };
/// assert_eq!((rests.u[0], rests.z[0], rests.w[0]), (1.0, 1.0, 0.0));
/// assert_eq!(problem.residuals(&rests.u, &rests.z).max(), 0.0);
/// # Ok::<(), grasp_lcp::lcp::LcpError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MixedLcp {
    /// [A, C; D, M].
    matrix: DMatrix<f64>,
    /// (b, q).
    vector: DVector<f64>,
    free: usize,
}

/// How solving a [`MixedLcp`] can end.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum MixedOutcome {
    /// A solution was found and checked against the data given.
    Solved(MixedSolution),
    /// No solution was found; the outcome is that of [`MixedLcp::split`], which a proof of infeasibility refers to (its y has n + 2m
    /// entries). `undetermined` and `dependent` name the free variables and equality rows that the elimination could not use.
    Unsolved {
        /// The outcome for the split problem, never [`Outcome::Solved`].
        outcome: Box<Outcome>,
        /// Free variables without a pivot, counted from 0.
        undetermined: Vec<usize>,
        /// Equality rows without a pivot, counted from 0.
        dependent: Vec<usize>,
    },
    /// The split problem is solved, but the point misses the tolerance for these residuals.
    Inaccurate(MixedResiduals),
}

/// A solution of a [`MixedLcp`].
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct MixedSolution {
    /// u (m entries).
    pub u: DVector<f64>,
    /// z (n entries, none negative).
    pub z: DVector<f64>,
    /// w = D u + M z + q (n entries, none negative; exactly zero where z_i is basic).
    pub w: DVector<f64>,
    /// Which z_i are basic.
    pub basis: Basis,
    /// The violations, recomputed from the data given.
    pub residuals: MixedResiduals,
    /// Free variables which nothing determines (a singular block), counted from 0; they are 0 here, and could be moved along.
    pub undetermined: Vec<usize>,
    /// Equality rows which follow from the others, counted from 0.
    pub dependent: Vec<usize>,
    /// Pivots of Lemke's method on the problem that led here, the reduced or the split one.
    pub pivots: usize,
}

/// The violations at a point of a [`MixedLcp`], measured as in [`Residuals`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct MixedResiduals {
    /// max_i |A u + C z + b|_i / a_i, with a_i the sum of the sizes of the terms of the row.
    pub equality: f64,
    /// Those of z and w.
    pub complementarity: Residuals,
}

impl MixedResiduals {
    /// The largest violation; NaN if one of them is.
    #[must_use]
    pub fn max(&self) -> f64 {
        if self.equality.is_nan() { f64::NAN } else { self.equality.max(self.complementarity.max()) }
    }
}

impl MixedLcp {
    /// The problem with A (m × m), C (m × n), D (n × m), M (n × n), b (m) and q (n).
    ///
    /// # Errors
    ///
    /// [`LcpError::BlockShape`] or [`LcpError::Length`] if a size does not match that of A and M, [`LcpError::MatrixEntry`] or
    /// [`LcpError::VectorEntry`] for an entry that is not finite.
    pub fn new(
        a: &DMatrix<f64>,
        c: &DMatrix<f64>,
        d: &DMatrix<f64>,
        m: &DMatrix<f64>,
        b: &DVector<f64>,
        q: &DVector<f64>,
    ) -> Result<Self, LcpError> {
        let (free, n) = (a.nrows(), m.nrows());
        for (what, block, shape) in
            [("A", a, (free, free)), ("C", c, (free, n)), ("D", d, (n, free)), ("M", m, (n, n))]
        {
            LcpError::check_block(what, block, shape)?;
        }
        LcpError::check_vector("b", b, free)?;
        LcpError::check_vector("q", q, n)?;
        let entry = |i: usize, j: usize| match (i < free, j < free) {
            (true, true) => a[(i, j)],
            (true, false) => c[(i, j - free)],
            (false, true) => d[(i - free, j)],
            (false, false) => m[(i - free, j - free)],
        };
        let matrix = DMatrix::from_fn(free + n, free + n, entry);
        let vector = DVector::from_fn(free + n, |i, _| if i < free { b[i] } else { q[i - free] });
        Ok(Self { matrix, vector, free })
    }

    /// The number m of free variables.
    #[must_use]
    pub fn free(&self) -> usize {
        self.free
    }

    /// The number n of pairs.
    #[must_use]
    pub fn len(&self) -> usize {
        self.vector.len() - self.free
    }

    /// Whether there is no pair.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The same problem without free variables, u = u⁺ − u⁻ and each equality as two inequalities: the unknowns are (u⁺, u⁻, z),
    /// n + 2m in number, the slacks (±(A u + C z + b), w). If xᵀ[A, C; D, M]x ≥ 0 for all free u and z ≥ 0, its matrix is copositive.
    #[must_use]
    pub fn split(&self) -> Lcp {
        let m = self.free;
        let (n, size) = (self.len(), self.len() + 2 * self.free);
        let place = |i: usize| {
            if i < m {
                (i, 1.0)
            } else if i < 2 * m {
                (i - m, -1.0)
            } else {
                (i - m, 1.0)
            }
        };
        debug_assert_eq!(size, n + 2 * m);
        let matrix = DMatrix::from_fn(size, size, |i, j| {
            let ((i, a), (j, b)) = (place(i), place(j));
            a * b * self.matrix[(i, j)]
        });
        let vector = DVector::from_fn(size, |i, _| place(i).1 * self.vector[place(i).0]);
        Lcp { m: matrix, q: vector }
    }

    /// Solves the problem with the default [`Settings`].
    #[must_use]
    pub fn solve(&self) -> MixedOutcome {
        self.solve_with(&Settings::default())
    }

    /// Solves the problem: by elimination, and if that ends without a solution, in its split form. The covering vector
    /// of the settings is not used.
    #[must_use]
    pub fn solve_with(&self, settings: &Settings) -> MixedOutcome {
        let settings = Settings { covering: None, ..settings.clone() };
        let reduction = Reduction::of(&self.matrix, &self.vector, self.free);
        if let Some(reduced) = &reduction.problem
            && let Outcome::Solved(solution) = reduced.solve_with(&settings)
        {
            let alpha = (0..self.len()).filter(|i| solution.basis.contains(*i) != reduction.swapped[*i]);
            let basis = Basis::from_indices(self.len(), alpha);
            let point = reduction.point(&solution);
            if let Ok(solution) = self.conclude(point, &basis, &reduction, solution.pivots, &settings) {
                return MixedOutcome::Solved(solution);
            }
        }
        match self.split().solve_with(&settings) {
            Outcome::Solved(solution) => {
                let m = self.free;
                let alpha = (0..self.len()).filter(|i| solution.basis.contains(2 * m + i));
                let basis = Basis::from_indices(self.len(), alpha);
                let z = &solution.z;
                let point =
                    DVector::from_fn(m + self.len(), |i, _| if i < m { z[i] - z[m + i] } else { z[m + i] });
                match self.conclude(point, &basis, &reduction, solution.pivots, &settings) {
                    Ok(solution) => MixedOutcome::Solved(solution),
                    Err(residuals) => MixedOutcome::Inaccurate(residuals),
                }
            }
            outcome => MixedOutcome::Unsolved {
                outcome: Box::new(outcome),
                undetermined: reduction.undetermined,
                dependent: reduction.dependent,
            },
        }
    }

    /// The better of the point given and the point of its basis computed from the data, if it is good enough.
    fn conclude(
        &self,
        point: DVector<f64>,
        basis: &Basis,
        reduction: &Reduction,
        pivots: usize,
        settings: &Settings,
    ) -> Result<MixedSolution, MixedResiduals> {
        let m = self.free;
        let (mut residuals, mut w) = self.evaluate(&point);
        let mut point = point;
        let determined = (0..m).filter(|i| !reduction.undetermined.contains(i));
        let indices: Vec<usize> = determined.chain(basis.iter().map(|i| m + i)).collect();
        if reduction.dependent.is_empty()
            && let Some(values) = principal::solve(&self.matrix, &self.vector, &indices)
        {
            let mut fresh = DVector::zeros(point.len());
            for (i, value) in indices.iter().zip(&values) {
                fresh[*i] = if *i < m { *value } else { value.max(0.0) };
            }
            let (fresh_residuals, fresh_w) = self.evaluate(&fresh);
            if residuals.max().is_nan() || fresh_residuals.max() <= residuals.max() {
                (residuals, w, point) = (fresh_residuals, fresh_w, fresh);
            }
        }
        if residuals.max().is_nan() || residuals.max() > settings.residual_tolerance {
            return Err(residuals);
        }
        let w = DVector::from_fn(self.len(), |i, _| if basis.contains(i) { 0.0 } else { w[m + i].max(0.0) });
        Ok(MixedSolution {
            u: point.rows(0, m).into_owned(),
            z: point.rows(m, self.len()).into_owned(),
            w,
            basis: basis.clone(),
            residuals,
            undetermined: reduction.undetermined.clone(),
            dependent: reduction.dependent.clone(),
            pivots,
        })
    }

    /// How well u and z solve the problem; infinite for vectors of another length.
    #[must_use]
    pub fn residuals(&self, u: &DVector<f64>, z: &DVector<f64>) -> MixedResiduals {
        if u.len() != self.free || z.len() != self.len() {
            return MixedResiduals { equality: f64::INFINITY, complementarity: Residuals::UNUSABLE };
        }
        let point =
            DVector::from_fn(self.vector.len(), |i, _| if i < self.free { u[i] } else { z[i - self.free] });
        self.evaluate(&point).0
    }

    fn evaluate(&self, point: &DVector<f64>) -> (MixedResiduals, DVector<f64>) {
        let size = point.len();
        let mut w = DVector::zeros(size);
        let mut terms = vec![0.0; size];
        slack_and_terms(&self.matrix, self.vector.as_slice(), point.as_slice(), w.as_mut_slice(), &mut terms);
        let mut equality = 0.0_f64;
        for i in 0..self.free {
            if w[i] != 0.0 {
                let miss = w[i].abs() / terms[i];
                equality = if miss.is_nan() { f64::INFINITY } else { equality.max(miss) };
            }
        }
        // Without the free part, whose signs do not matter.
        let only = |v: &DVector<f64>| DVector::from_fn(size, |i, _| if i < self.free { 0.0 } else { v[i] });
        let complementarity =
            residuals_from(&self.matrix, only(point).as_slice(), only(&w).as_slice(), &terms);
        (MixedResiduals { equality, complementarity }, w)
    }
}
