//! Singular values, and eigenvalues of symmetric matrices, by Jacobi's rotations of columns.
//!
//! Columns are rotated in pairs until all are orthogonal (Hestenes). The columns then are the left singular vectors times the singular values. The
//! product of all rotations is the matrix of right singular vectors. Small singular values keep their relative accuracy. One function serves matrices
//! of every shape.

use super::reals::Reals;
use nalgebra::{DMatrix, DVector};

use super::increasing::increasing;
use super::mapped::{mapped, numbered};
use super::tolerances::FEW_ROUNDINGS;
#[cfg(not(feature = "std"))]
use super::without_std::FloatFunctions;
use crate::prelude::*;

/// The singular value decomposition `M = U diag(values) Vᵀ` of a matrix M, from the largest value to the smallest. It has as many values and right
/// vectors as M has columns.
#[derive(Debug, Clone)]
pub(crate) struct Singular {
    pub(crate) values: Vec<f64>,
    /// The left singular vectors times their singular values, U diag(values).
    scaled_left: DMatrix<f64>,
    /// The right singular vectors V, as columns.
    pub(crate) right: DMatrix<f64>,
}

impl Singular {
    pub(crate) fn new(matrix: &DMatrix<f64>) -> Self {
        let columns = matrix.ncols();
        let mut turned = matrix.clone();
        let mut right = DMatrix::identity(columns, columns);
        // Rotations converge quadratically within some ten sweeps; the limit stops the sweeps for matrices with NaN or infinite entries.
        for _ in 0..60 {
            let mut all_orthogonal = true;
            for i in 1..columns {
                for j in 0..i {
                    if let Some(tangent) = rotation(&turned, i, j) {
                        all_orthogonal = false;
                        rotate(&mut turned, i, j, tangent);
                        rotate(&mut right, i, j, tangent);
                    }
                }
            }
            if all_orthogonal {
                break;
            }
        }
        let lengths: Vec<f64> = numbered(columns, &|j| turned.column(j).norm());
        let order = increasing(&mapped(&lengths, &|length| -length));
        Self {
            values: numbered(columns, &|k| lengths[order[k]]),
            scaled_left: turned.select_columns(&order),
            right: right.select_columns(&order),
        }
    }

    /// Components of a vector along the unit left singular vectors; zero where the singular value is zero.
    pub(crate) fn along(&self, vector: &DVector<f64>) -> Vec<f64> {
        numbered(self.values.len(), &|k| {
            if self.values[k] > 0.0 {
                self.scaled_left.column(k).dot(&vector.column(0)) / self.values[k]
            } else {
                0.0
            }
        })
    }

    /// The least-squares solution x of `M x = vector`, of least norm, for the decomposed matrix M; singular values up to `least` count as zero.
    pub(crate) fn solve(&self, vector: &DVector<f64>, least: f64) -> DVector<f64> {
        let mut solution = DVector::zeros(self.values.len());
        for (k, part) in self.along(vector).into_iter().enumerate() {
            if self.values[k] > least {
                solution.axpy(part / self.values[k], &self.right.column(k), 1.0);
            }
        }
        solution
    }

    /// The shortest x with `Mᵀ x = b`, and the y with `x = M y`, for the decomposed matrix M, whose columns must be independent.
    pub(crate) fn of_transpose(&self, b: &DVector<f64>) -> (DVector<f64>, DVector<f64>) {
        let mut y = self.right.tr_mul(b);
        let mut x = DVector::zeros(self.scaled_left.nrows());
        for (k, part) in y.iter_mut().enumerate() {
            *part /= self.values[k] * self.values[k];
            x.axpy(*part, &self.scaled_left.column(k), 1.0);
        }
        (x, &self.right * y)
    }
}

/// The tangent of the angle by which columns i and j are rotated to become orthogonal; `None` if they are orthogonal already.
fn rotation(columns: &DMatrix<f64>, i: usize, j: usize) -> Option<f64> {
    let (a, b) = (columns.column(i), columns.column(j));
    let (a2, b2, ab) = (a.norm_squared(), b.norm_squared(), a.dot(&b));
    // The expected rounding error of a dot product grows with the square root of its length.
    let clear = ab.abs() > FEW_ROUNDINGS * (columns.nrows() as f64 * a2 * b2).sqrt();
    if !clear {
        return None;
    }
    let zeta = (b2 - a2) / (2.0 * ab);
    Some(if zeta.is_infinite() { 0.5 / zeta } else { zeta.signum() / (zeta.abs() + zeta.hypot(1.0)) })
}

fn rotate(columns: &mut DMatrix<f64>, i: usize, j: usize, tangent: f64) {
    let cosine = tangent.hypot(1.0).recip();
    let sine = cosine * tangent;
    for row in 0..columns.nrows() {
        let (a, b) = (columns[(row, i)], columns[(row, j)]);
        columns[(row, i)] = cosine * a - sine * b;
        columns[(row, j)] = sine * a + cosine * b;
    }
}

/// The eigenvalues of a symmetric matrix, from the largest to the smallest, and unit eigenvectors as columns in the same order.
pub(crate) fn symmetric_eigen(matrix: &DMatrix<f64>) -> (Vec<f64>, DMatrix<f64>) {
    // No eigenvalue exceeds the largest sum of absolute values along a row. With this sum added to the diagonal no eigenvalue is negative, so
    // that eigenvalues are singular values.
    let shift = matrix.row_iter().map(|row| row.lp_norm(1)).most();
    let mut moved = matrix.clone();
    for k in 0..matrix.nrows() {
        moved[(k, k)] += shift;
    }
    let parts = Singular::new(&moved);
    (numbered(parts.values.len(), &|k| parts.values[k] - shift), parts.right)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The decomposition gives the matrix back, with orthonormal right vectors and falling values, for tall, wide and singular matrices.
    #[test]
    fn factors_give_the_matrix_back() {
        for (rows, columns) in [(1, 1), (5, 3), (3, 5), (6, 6)] {
            let matrix = DMatrix::from_fn(rows, columns, |i, j| {
                ((i * 7 + j * j) as f64).sin() * 0.1_f64.powf(j as f64)
            });
            let found = Singular::new(&matrix);
            let back = &found.scaled_left * found.right.transpose();
            assert!((back - &matrix).amax() < 1e-14);
            let unit = found.right.tr_mul(&found.right);
            assert!((unit - DMatrix::identity(columns, columns)).amax() < 1e-14);
            assert!(found.values.is_sorted_by(|a, b| a >= b));
            let x = found.solve(&(&matrix * DVector::from_element(columns, 1.0)), 1e-13 * found.values[0]);
            assert!((&matrix * x - matrix.column_sum()).amax() < 1e-13);
        }
    }

    /// Eigenvalues of [[2, 1], [1, −3]]: −½ ± √29/2.
    #[test]
    fn eigenvalues_of_both_signs() {
        let matrix = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, -3.0]);
        let (values, vectors) = symmetric_eigen(&matrix);
        let half = 29_f64.sqrt() / 2.0;
        assert!((values[0] - (half - 0.5)).abs() < 1e-14 && (values[1] + half + 0.5).abs() < 1e-14);
        assert!((&matrix * vectors.column(1) - vectors.column(1) * values[1]).amax() < 1e-14);
    }
}
