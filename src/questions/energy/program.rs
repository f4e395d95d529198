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
//! For a positive semidefinite H the two problems are equivalent. Lemke's method was made for the second one (Lemke 1965). Except for rounding it
//! cannot fail: it finds a minimum or a ray, and a ray means that there is no minimum.

use crate::numerics::{IntoList, matrix_of, vector_of};
use nalgebra::{DMatrix, DVector};

use crate::lcp::{Lcp, LcpError, Outcome, Solution, optimality_conditions};
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
    /// `Gᵀx + ½ xᵀH x` at x.
    pub value: f64,
}

impl QuadraticProgram {
    /// The optimality conditions as a complementarity problem for (x⁺, x⁻, λ, y⁺, y⁻), in which x = x⁺ - x⁻ and y = y⁺ - y⁻.
    ///
    /// For a positive semidefinite H they are equivalent to the program, and Lemke's method was made for them (Lemke 1965). In exact arithmetic it
    /// ends at a minimum, or on a ray, which means that there is no minimum.
    ///
    /// # Errors
    /// [`LcpError::BlockShape`] if H, A or B does not fit G, C and D. [`LcpError::MatrixEntry`] or [`LcpError::VectorEntry`] for a number that is not
    /// finite.
    pub fn optimality_conditions(&self) -> Result<Lcp, LcpError> {
        let (n, m, k) = (self.g.len(), self.c.len(), self.d.len());
        for (what, block, shape) in [("H", &self.h, (n, n)), ("A", &self.a, (m, n)), ("B", &self.b, (k, n))] {
            LcpError::check_block(what, block, shape)?;
        }
        let column = |j: usize| if j < n { (j, 1.0) } else { (j - n, -1.0) };
        let h = matrix_of(2 * n, 2 * n, &|i, j| {
            let ((i, a), (j, b)) = (column(i), column(j));
            a * b * self.h[(i, j)]
        });
        let g = vector_of(2 * n, &|j| column(j).1 * self.g[column(j).0]);
        // Each equality is written as two inequalities.
        let row = |i: usize| match i {
            i if i < k => (&self.b, &self.d, i, 1.0),
            i if i < k + m => (&self.a, &self.c, i - k, 1.0),
            i => (&self.a, &self.c, i - k - m, -1.0),
        };
        let rows = matrix_of(k + 2 * m, 2 * n, &|i, j| {
            let ((matrix, _, i, a), (j, b)) = (row(i), column(j));
            a * b * matrix[(i, j)]
        });
        let right = vector_of(k + 2 * m, &|i| {
            let (_, right, i, a) = row(i);
            -a * right[i]
        });
        optimality_conditions(Some(&h), &g, &rows, &right)
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
    /// let minimum = program.solve()?.expect("H is positive definite");
    /// assert!((&minimum.x - DVector::from_vec(vec![0.5, 1.5])).amax() < 1e-15);
    /// assert!((minimum.multipliers[0] - 1.0).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::lcp::LcpError>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::optimality_conditions`].
    pub fn solve(&self) -> Result<Option<QpMinimum>, LcpError> {
        let (n, m, k) = (self.g.len(), self.c.len(), self.d.len());
        let conditions = self.optimality_conditions()?;
        let Outcome::Solved(Solution { z, .. }) = conditions.solve() else { return Ok(None) };
        let free = |first: usize, len: usize| vector_of(len, &|i| z[first + i] - z[first + len + i]);
        let found = self.minimum(free(0, n), free(2 * n + k, m), z.rows(2 * n, k).into_owned());
        let Some(refined) = self.refined(&found) else { return Ok(Some(found)) };
        let split = |v: &DVector<f64>, i: usize| if i < v.len() { v[i] } else { -v[i - v.len()] }.max(0.0);
        let point = vector_of(z.len(), &|i| match i {
            i if i < 2 * n => split(&refined.x, i),
            i if i < 2 * n + k => refined.multipliers[i - 2 * n],
            i => split(&refined.equality_multipliers, i - 2 * n - k),
        });
        let better = conditions.residuals(&point).max() <= conditions.residuals(&z).max().max(FEW_ROUNDINGS);
        Ok(Some(if better { refined } else { found }))
    }

    fn minimum(&self, x: DVector<f64>, y: DVector<f64>, multipliers: DVector<f64>) -> QpMinimum {
        QpMinimum { value: self.value(&x), x, equality_multipliers: y, multipliers }
    }

    /// The solution recomputed from its binding rows with iterative refinement. Each condition is then satisfied to the rounding of its own terms
    /// (Skeel 1980): forces balance to the last digits even beside springs a million times stiffer. `None` where the binding rows do not determine
    /// the solution.
    fn refined(&self, found: &QpMinimum) -> Option<QpMinimum> {
        let (n, m) = (self.g.len(), self.c.len());
        let binding: Vec<usize> = (0..self.d.len()).filter(|row| found.multipliers[*row] > 0.0).list();
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
        // Rows and columns are scaled to like size, so that the choice of pivots does not depend on units.
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
            i if i < n => found.x[i],
            i if i < n + m => found.equality_multipliers[i - n],
            i => found.multipliers[binding[i - n - m]],
        });
        let largest = point.amax();
        // Two steps of refinement remove the error of the factorisation; a third costs almost nothing.
        for _ in 0..3 {
            let left = (&right - &matrix * &point).component_mul(&scale);
            point += factor.solve(&left)?.component_mul(&scale);
        }
        // If nothing resists some motion, the matrix is singular, and rounding would carry the solution far along it. Then the solution is not
        // refined.
        if !point.iter().all(|x| x.abs() <= 2.0 * largest) {
            return None;
        }
        let mut z = DVector::zeros(self.d.len());
        for (place, &row) in binding.iter().enumerate() {
            z[row] = point[n + m + place].max(0.0);
        }
        Some(self.minimum(point.rows(0, n).into_owned(), point.rows(n, m).into_owned(), z))
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
