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

use grasp_lcp::lcp::{Lcp, LcpError, Outcome, Solution};
use nalgebra::{DMatrix, DVector};

/// The program `minimise Gᵀx + ½ xᵀH x subject to A x = C, B x >= D`, with the letters of the paper (section 5.1).
///
/// H must be symmetric and positive semidefinite; this is not checked. A program without equalities has an A with no rows and n columns. Memory and
/// pivots are the same as for dense matrices of n + m + k rows.
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
pub struct QpMinimum {
    /// The minimiser x (n numbers).
    pub x: DVector<f64>,
    /// Multipliers y of the equality rows (m numbers): cost per unit of C.
    pub equality_multipliers: DVector<f64>,
    /// Multipliers λ >= 0 of the inequality rows (k numbers): cost per unit of D. Positive only for rows that bind.
    pub multipliers: DVector<f64>,
    /// The cost `Gᵀx + ½ xᵀH x` at the minimum.
    pub value: f64,
}

impl QuadraticProgram {
    /// The optimality conditions as a complementarity problem for (x⁺, x⁻, λ, y⁺, y⁻), in which x = x⁺ - x⁻ and y = y⁺ - y⁻. Each equality is two
    /// inequalities.
    fn optimality_conditions(&self) -> Result<Lcp, LcpError> {
        let (n, m, k) = (self.g.len(), self.c.len(), self.d.len());
        let mut split = DMatrix::zeros(n, 2 * n);
        split.view_mut((0, 0), (n, n)).fill_with_identity();
        split.view_mut((0, n), (n, n)).copy_from(&-DMatrix::<f64>::identity(n, n));
        let mut rows = DMatrix::zeros(k + 2 * m, n);
        rows.view_mut((0, 0), (k, n)).copy_from(&self.b);
        rows.view_mut((k, 0), (m, n)).copy_from(&self.a);
        rows.view_mut((k + m, 0), (m, n)).copy_from(&-&self.a);
        let rows = rows * &split;
        let size = 2 * n + k + 2 * m;
        let mut matrix = DMatrix::zeros(size, size);
        matrix.view_mut((0, 0), (2 * n, 2 * n)).copy_from(&(split.transpose() * &self.h * &split));
        matrix.view_mut((2 * n, 0), rows.shape()).copy_from(&rows);
        matrix.view_mut((0, 2 * n), (2 * n, k + 2 * m)).copy_from(&-rows.transpose());
        let right = self.d.iter().chain(&self.c).map(|d| -d).chain(self.c.iter().copied());
        let vector = (split.transpose() * &self.g).iter().copied().chain(right).collect();
        Lcp::new(matrix, DVector::from_vec(vector))
    }

    /// Computes the minimum and its multipliers by Lemke's method on the optimality conditions.
    pub fn solve(&self) -> Result<Option<QpMinimum>, LcpError> {
        let (n, m, k) = (self.g.len(), self.c.len(), self.d.len());
        let conditions = self.optimality_conditions()?;
        let Outcome::Solved(Solution { z, .. }) = conditions.solve() else { return Ok(None) };
        let free = |first: usize, len: usize| DVector::from_fn(len, |i, _| z[first + i] - z[first + len + i]);
        let found = self.minimum(free(0, n), free(2 * n + k, m), z.rows(2 * n, k).into_owned());
        let Some(refined) = self.refined(&found) else { return Ok(Some(found)) };
        let split = |v: &DVector<f64>, i: usize| if i < v.len() { v[i] } else { -v[i - v.len()] }.max(0.0);
        let point = DVector::from_fn(z.len(), |i, _| match i {
            i if i < 2 * n => split(&refined.x, i),
            i if i < 2 * n + k => refined.multipliers[i - 2 * n],
            i => split(&refined.equality_multipliers, i - 2 * n - k),
        });
        let better =
            conditions.residuals(&point).max() <= conditions.residuals(&z).max().max(4.0 * f64::EPSILON);
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
        let binding: Vec<usize> = (0..self.d.len()).filter(|row| found.multipliers[*row] > 0.0).collect();
        let size = n + m + binding.len();
        let mut matrix = DMatrix::zeros(size, size);
        matrix.view_mut((0, 0), (n, n)).copy_from(&self.h);
        for i in 0..m + binding.len() {
            let row = if i < m { self.a.row(i) } else { self.b.row(binding[i - m]) };
            matrix.view_mut((n + i, 0), (1, n)).copy_from(&row);
            matrix.view_mut((0, n + i), (n, 1)).copy_from(&-row.transpose());
        }
        let right = DVector::from_fn(size, |i, _| match i {
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
        let scaled = DMatrix::from_fn(size, size, |i, j| matrix[(i, j)] * scale[i] * scale[j]);
        let factor = scaled.lu();
        let mut point = DVector::from_fn(size, |i, _| match i {
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
    pub fn value(&self, x: &DVector<f64>) -> f64 {
        self.g.dot(x) + 0.5 * x.dot(&(&self.h * x))
    }
}
