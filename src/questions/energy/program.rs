//! A convex quadratic program and the linear complementarity problem of its optimality conditions.
//!
//! ```text
//! minimise Gᵀx + ½ xᵀH x     subject to  A x = C,  B x >= D
//!
//! 0 = H x - Aᵀy - Bᵀλ + G
//! 0 = A x - C                                     x, y free
//! 0 <= λ  ⟂  B x - D >= 0
//! ```
//!
//! For a positive semidefinite H the two problems are equivalent. Lemke's method was made for the second (Lemke 1965) and cannot fail on it: it finds
//! a minimum or a ray, and a ray means that there is no minimum.

use crate::numerics::{IntoList, matrix_of, vector_of};
use nalgebra::{DMatrix, DVector};

use crate::lcp::{LcpError, MixedLcp, MixedSolution, Outcome, Residuals};
use crate::numerics::tolerances::FEW_ROUNDINGS;
use crate::prelude::*;

/// The program `minimise Gᵀx + ½ xᵀH x subject to A x = C, B x >= D`, with the letters of the paper (section 5.1).
///
/// H must be symmetric and positive semidefinite; this is not checked. A program without equalities has an A with no rows and n columns. Memory and
/// pivots are those for dense matrices of n + m + k rows.
#[derive(Debug, Clone, PartialEq)]
pub struct QuadraticProgram {
    /// G, linear cost (n).
    pub g: DVector<f64>,
    /// H, quadratic cost (n × n).
    pub h: DMatrix<f64>,
    /// A, equality rows (m × n).
    pub a: DMatrix<f64>,
    /// C, their right-hand sides (m).
    pub c: DVector<f64>,
    /// B, inequality rows (k × n).
    pub b: DMatrix<f64>,
    /// D, their right-hand sides (k).
    pub d: DVector<f64>,
}

/// How solving a [`QuadraticProgram`] ends.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum QpOutcome {
    /// A minimum.
    Minimum(QpMinimum),
    /// The optimality conditions were not solved. With a positive semidefinite H [`Infeasible`](Outcome::Infeasible) means that the constraints
    /// contradict each other or that the cost is unbounded below.
    NoMinimum(Box<Outcome<MixedSolution>>),
}

impl QpOutcome {
    /// The minimum, if there is one.
    #[must_use]
    pub fn minimum(&self) -> Option<&QpMinimum> {
        match self {
            Self::Minimum(minimum) => Some(minimum),
            Self::NoMinimum(_) => None,
        }
    }
}

/// A minimum of a [`QuadraticProgram`] with its multipliers.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct QpMinimum {
    /// x (n).
    pub x: DVector<f64>,
    /// y, multipliers of the equality rows (m): cost per unit of C.
    pub equality_multipliers: DVector<f64>,
    /// λ >= 0, multipliers of the inequality rows (k): cost per unit of D. Positive only where the row binds.
    pub multipliers: DVector<f64>,
    /// B x - D >= 0 (k).
    pub slacks: DVector<f64>,
    /// `Gᵀx + ½ xᵀH x` at x.
    pub value: f64,
    /// How well the optimality conditions are satisfied, relative to the sizes of their terms.
    pub residuals: Residuals,
    /// Pivots of Lemke's method.
    pub pivots: usize,
}

impl QuadraticProgram {
    /// The optimality conditions: free variables (x, y), n + m in number, and k complementary pairs (λ, B x - D).
    ///
    /// ```text
    /// 0 = H x - Aᵀy - Bᵀλ + G
    /// 0 = A x - C
    /// 0 <= λ  ⟂  B x - D >= 0
    /// ```
    ///
    /// For a positive semidefinite H they are equivalent to the program, and Lemke's method was made for them (Lemke 1965). In exact arithmetic it
    /// ends at a minimum, or on a ray, which means that there is no minimum.
    ///
    /// # Errors
    /// [`LcpError::BlockShape`] if H, A or B does not fit G, C and D. [`LcpError::MatrixEntry`] or
    /// [`LcpError::VectorEntry`] for a number that is not finite; its place is that in the matrices of [`MixedLcp`].
    pub fn optimality_conditions(&self) -> Result<MixedLcp, LcpError> {
        let (n, m, k) = (self.g.len(), self.c.len(), self.d.len());
        let shapes =
            [("H", self.h.shape(), (n, n)), ("A", self.a.shape(), (m, n)), ("B", self.b.shape(), (k, n))];
        for (what, (rows, columns), (needed_rows, needed_columns)) in shapes {
            if (rows, columns) != (needed_rows, needed_columns) {
                return Err(LcpError::BlockShape { what, rows, columns, needed_rows, needed_columns });
            }
        }
        let mut free = DMatrix::zeros(n + m, n + m);
        free.view_mut((0, 0), (n, n)).copy_from(&self.h);
        free.view_mut((0, n), (n, m)).copy_from(&-self.a.transpose());
        free.view_mut((n, 0), (m, n)).copy_from(&self.a);
        let mut pull = DMatrix::zeros(n + m, k);
        pull.view_mut((0, 0), (n, k)).copy_from(&-self.b.transpose());
        let mut rows = DMatrix::zeros(k, n + m);
        rows.view_mut((0, 0), (k, n)).copy_from(&self.b);
        let constant = vector_of(n + m, &|i| if i < n { self.g[i] } else { -self.c[i - n] });
        MixedLcp::new(&free, &pull, &rows, &DMatrix::zeros(k, k), &constant, &-&self.d)
    }

    /// Computes the minimum and its multipliers by Lemke's method on [`Self::optimality_conditions`].
    ///
    /// ```
    /// use grasp_lcp::energy::QuadraticProgram;
    /// use nalgebra::{DMatrix, DVector};
    ///
    /// // The point of the line x₁ + x₂ = 2 with x₂ >= 1.5 next to the origin.
    /// let program = QuadraticProgram {
    ///     g: DVector::zeros(2),
    ///     h: DMatrix::identity(2, 2),
    ///     a: DMatrix::from_row_slice(1, 2, &[1.0, 1.0]),
    ///     c: DVector::from_vec(vec![2.0]),
    ///     b: DMatrix::from_row_slice(1, 2, &[0.0, 1.0]),
    ///     d: DVector::from_vec(vec![1.5]),
    /// };
    /// let outcome = program.solve()?;
    /// let minimum = outcome.minimum().expect("H is positive definite");
    /// assert!((&minimum.x - DVector::from_vec(vec![0.5, 1.5])).amax() < 1e-15);
    /// assert!((minimum.multipliers[0] - 1.0).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::lcp::LcpError>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::optimality_conditions`].
    pub fn solve(&self) -> Result<QpOutcome, LcpError> {
        let n = self.g.len();
        let conditions = self.optimality_conditions()?;
        Ok(match conditions.solve() {
            Outcome::Solved(mut solution) => {
                let determined = solution.undetermined.is_empty() && solution.dependent.is_empty();
                if let Some((u, z)) = self.refined(&solution).filter(|_| determined) {
                    let residuals = conditions.residuals(&u, &z);
                    if residuals.max() <= solution.residuals.max().max(FEW_ROUNDINGS) {
                        (solution.u, solution.z, solution.residuals) = (u, z, residuals);
                    }
                }
                let x = solution.u.rows(0, n).into_owned();
                QpOutcome::Minimum(QpMinimum {
                    value: self.value(&x),
                    equality_multipliers: solution.u.rows(n, self.c.len()).into_owned(),
                    multipliers: solution.z,
                    slacks: solution.w,
                    residuals: solution.residuals,
                    pivots: solution.pivots,
                    x,
                })
            }
            other => QpOutcome::NoMinimum(Box::new(other)),
        })
    }

    /// The solution recomputed from its binding rows with iterative refinement. Each condition is then satisfied to the rounding of its own terms
    /// (Skeel 1980): forces balance to the last digits beside springs a million times stiffer. `None` where the binding rows do not determine the
    /// point.
    fn refined(&self, solution: &MixedSolution) -> Option<(DVector<f64>, DVector<f64>)> {
        let (n, m) = (self.g.len(), self.c.len());
        let binding: Vec<usize> = solution.basis.iter().list();
        let size = n + m + binding.len();
        let mut matrix = DMatrix::zeros(size, size);
        matrix.view_mut((0, 0), (n, n)).copy_from(&self.h);
        for i in 0..m + binding.len() {
            let row = if i < m { self.a.row(i) } else { self.b.row(binding[i - m]) };
            matrix.view_mut((n + i, 0), (1, n)).copy_from(&row);
            matrix.view_mut((0, n + i), (n, 1)).copy_from(&-row.transpose());
        }
        let right = vector_of(size, &|i| match i {
            i if i < n => -self.g[i],
            i if i < n + m => self.c[i - n],
            i => self.d[binding[i - n - m]],
        });
        // Scaling makes rows and columns equally large, so that pivots are not chosen by their units.
        let mut scale = DVector::from_element(size, 1.0);
        for _ in 0..3 {
            for i in 0..size {
                let largest =
                    (0..size).map(|j| (matrix[(i, j)] * scale[i] * scale[j]).abs()).fold(0.0, f64::max);
                if largest > 0.0 {
                    scale[i] /= largest.sqrt();
                }
            }
        }
        let scaled = matrix_of(size, size, &|i, j| matrix[(i, j)] * scale[i] * scale[j]);
        let factor = scaled.lu();
        let mut point = vector_of(size, &|i| match i {
            i if i < n + m => solution.u[i],
            i => solution.z[binding[i - n - m]],
        });
        let largest = point.amax();
        // Two steps of refinement remove the error of a factorisation, one more costs almost nothing.
        for _ in 0..3 {
            let left = (&right - &matrix * &point).component_mul(&scale);
            point += factor.solve(&left)?.component_mul(&scale);
        }
        // Motions that nothing resists make the matrix singular: rounding would drive the point along them.
        if !point.iter().all(|x| x.abs() <= 2.0 * largest) {
            return None;
        }
        let mut z = DVector::zeros(self.d.len());
        for (place, &row) in binding.iter().enumerate() {
            z[row] = point[n + m + place].max(0.0);
        }
        Some((point.rows(0, n + m).into_owned(), z))
    }

    /// The cost `Gᵀx + ½ xᵀH x` at any x (n entries), feasible or not.
    ///
    /// # Panics
    /// If x has another length than G, or H has another size.
    #[must_use]
    pub fn value(&self, x: &DVector<f64>) -> f64 {
        self.g.dot(x) + 0.5 * x.dot(&(&self.h * x))
    }
}
