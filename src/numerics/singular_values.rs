//! Singular values by one-sided Jacobi rotations: columns are turned in pairs until all are at right angles.
//!
//! Small singular values are as accurate as the columns allow, whatever their sizes. Right singular vectors form a basis of all unknowns, also where
//! there are fewer rows than columns.

use nalgebra::{DMatrix, DVector};

use super::increasing::increasing;
use crate::prelude::*;

/// Most rounds over all pairs of columns. Some ten suffice, since the angles converge quadratically.
const ROUNDS: usize = 60;

/// Square of the length up to which a column is the rounding of rounding, for a matrix with a largest entry of 1.
const NOTHING: f64 = f64::EPSILON * f64::EPSILON * f64::EPSILON * f64::EPSILON;

/// `A = U Σ Vᵀ`, the largest singular value first.
pub(crate) struct SingularValues {
    pub(crate) values: Vec<f64>,
    /// Left singular vectors as columns, each times its singular value.
    scaled_left: DMatrix<f64>,
    /// Right singular vectors as columns, one for each column of A.
    pub(crate) right: DMatrix<f64>,
}

impl SingularValues {
    pub(crate) fn of(matrix: &DMatrix<f64>) -> Self {
        let (rows, columns) = matrix.shape();
        let size = if rows * columns > 0 { matrix.amax() } else { 0.0 };
        let size = if size > 0.0 { size } else { 1.0 };
        // Squares of scaled entries do not overflow.
        let (mut turned, mut right) = (matrix / size, DMatrix::identity(columns, columns));
        for _ in 0..ROUNDS {
            let mut at_right_angles = true;
            for p in 0..columns {
                for q in p + 1..columns {
                    let (mut a, mut b, mut c) = (0.0, 0.0, 0.0);
                    for row in 0..rows {
                        let (x, y) = (turned[(row, p)], turned[(row, q)]);
                        (a, b, c) = (a + x * x, b + y * y, c + x * y);
                    }
                    if a.min(b) <= NOTHING || c.abs() <= f64::EPSILON * rows as f64 * (a * b).sqrt() {
                        continue;
                    }
                    at_right_angles = false;
                    let ratio = (b - a) / (2.0 * c);
                    let tangent = ratio.signum() / (ratio.abs() + ratio.hypot(1.0));
                    let cosine = tangent.hypot(1.0).recip();
                    for matrix in [&mut turned, &mut right] {
                        for row in 0..matrix.nrows() {
                            let (x, y) = (matrix[(row, p)], matrix[(row, q)]);
                            matrix[(row, p)] = cosine * (x - tangent * y);
                            matrix[(row, q)] = cosine * (y + tangent * x);
                        }
                    }
                }
            }
            if at_right_angles {
                break;
            }
        }
        turned *= size;
        let mut lengths = Vec::with_capacity(columns);
        for column in turned.column_iter() {
            lengths.push(-column.norm());
        }
        let order = increasing(&lengths);
        let values = order.iter().map(|k| -lengths[*k]).collect();
        Self { values, scaled_left: turned.select_columns(&order), right: right.select_columns(&order) }
    }

    /// The largest singular value; 0 of a matrix without columns.
    pub(crate) fn largest(&self) -> f64 {
        self.values.first().copied().unwrap_or(0.0)
    }

    /// Components of a vector along the left singular vectors; 0 where the singular value vanishes.
    pub(crate) fn along_left(&self, vector: &DVector<f64>) -> Vec<f64> {
        let mut along = Vec::with_capacity(self.values.len());
        for (column, value) in self.scaled_left.column_iter().zip(&self.values) {
            along.push(if *value > 0.0 { column.dot(vector) / value } else { 0.0 });
        }
        along
    }

    /// The shortest least-squares solution of `A x = b`, with singular values up to `least` taken as zero.
    pub(crate) fn solve(&self, b: &DVector<f64>, least: f64) -> DVector<f64> {
        let mut x = DVector::zeros(self.right.nrows());
        for ((along, value), right) in
            self.along_left(b).iter().zip(&self.values).zip(self.right.column_iter())
        {
            if *value > least {
                x += right * (along / value);
            }
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::Draw;

    /// Products of the factors give the matrix back, V is orthonormal, and a solution fulfils the normal equations; also with fewer rows than
    /// columns, dependent columns, and columns whose sizes differ by ten powers of ten.
    #[test]
    fn factors_of_any_shape() {
        let mut draw = Draw::new([7, 7, 7]);
        for (rows, columns) in [(1, 1), (3, 3), (2, 5), (6, 2), (9, 4), (0, 3), (4, 0)] {
            for graded in [1.0, 1e-10] {
                let mut matrix = DMatrix::from_fn(rows, columns, |_, _| draw.normal());
                for k in 0..columns {
                    matrix.column_mut(k).scale_mut(f64::powi(graded, k.min(1) as i32));
                }
                if columns > 2 {
                    let sum = matrix.column(0) + matrix.column(1);
                    matrix.set_column(2, &sum);
                }
                let found = SingularValues::of(&matrix);
                assert!(found.values.is_sorted_by(|a, b| a >= b));
                let back = &found.scaled_left * found.right.transpose() - &matrix;
                assert!(back.iter().all(|x| x.abs() < 1e-14), "{back}");
                let unit = found.right.tr_mul(&found.right) - DMatrix::identity(columns, columns);
                assert!(unit.iter().all(|x| x.abs() < 1e-14), "{unit}");
                let b = DVector::from_fn(rows, |_, _| draw.normal());
                let x = found.solve(&b, 1e-13 * found.largest());
                let left = matrix.tr_mul(&(&matrix * &x - &b));
                // Rounding of A x is relative to the sizes of A and x.
                assert!(left.norm() <= 1e-13 * (1.0 + x.norm()), "{left}");
            }
        }
    }
}
