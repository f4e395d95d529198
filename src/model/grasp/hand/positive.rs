//! Factorisation of symmetric positive semidefinite matrices.

use nalgebra::{DMatrix, DVector};

use crate::grasp::tolerances::NEGATIVE_REMAINDER;
use crate::numerics::tolerances::{LINEARLY_DEPENDENT, NEGLIGIBLE};
use crate::numerics::{any_index, chosen, symmetric_eigen};
use crate::prelude::*;

/// The reason why a matrix is not symmetric positive semidefinite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum NotPositive {
    /// The matrix does not have `size` rows and columns.
    Shape { rows: usize, columns: usize, size: usize },
    /// An entry of the matrix, which is not finite or too large.
    Entry(f64),
    /// The largest difference between two entries that should be equal by symmetry.
    Asymmetry(f64),
    /// The least eigenvalue, which is negative.
    Eigenvalue(f64),
}

/// Columns l with `M = Σ l lᵀ` for a positive semidefinite matrix M, as many as its rank. They are computed by Cholesky factorisation with diagonal
/// pivoting, which leaves a remainder of M after each column. The pivot is the diagonal entry with the largest remainder relative to its original
/// value. Entries of very different magnitudes thus keep their relative accuracy.
pub(super) fn squares(matrix: &DMatrix<f64>, size: usize) -> Result<Vec<DVector<f64>>, NotPositive> {
    checked(matrix, size)?;
    let whole = matrix.diagonal();
    let mut rest = (matrix + matrix.transpose()) * 0.5;
    let mut columns = Vec::new();
    let mut left: Vec<usize> = chosen(size, &|&j| whole[j] > 0.0);
    if any_index(size, &|j| whole[j] < 0.0 || (whole[j] == 0.0 && matrix.column(j).amax() > 0.0)) {
        return Err(NotPositive::Eigenvalue(least_eigenvalue(matrix)));
    }
    while !left.is_empty() {
        let share = |j: usize| rest[(j, j)] / whole[j];
        let (place, pivot) = left
            .iter()
            .enumerate()
            .map(|(place, &j)| (place, j))
            .max_by(|a, b| share(a.1).total_cmp(&share(b.1)))
            .unwrap_or((0, left[0]));
        if left.iter().any(|&j| share(j) < -NEGATIVE_REMAINDER) {
            return Err(NotPositive::Eigenvalue(least_eigenvalue(matrix)));
        }
        // A remainder up to the fraction `LINEARLY_DEPENDENT` of the original diagonal entry counts as zero; rounding leaves about 1e-15.
        if share(pivot) <= LINEARLY_DEPENDENT {
            break;
        }
        left.swap_remove(place);
        let root = rest[(pivot, pivot)].sqrt();
        let mut column = DVector::zeros(size);
        column[pivot] = root;
        for &j in &left {
            column[j] = rest[(j, pivot)] / root;
        }
        for &i in &left {
            for &j in &left {
                rest[(i, j)] -= column[i] * column[j];
            }
        }
        columns.push(column);
    }
    // The diagonal of the block that remains counts as zero. For a semidefinite M all entries of this block must then be zero.
    let beside = |i: usize, j: usize| rest[(i, j)].abs() / (whole[i] * whole[j]).sqrt();
    if left.iter().any(|&i| left.iter().any(|&j| beside(i, j) > NEGATIVE_REMAINDER)) {
        return Err(NotPositive::Eigenvalue(least_eigenvalue(matrix)));
    }
    Ok(columns)
}

/// Returns an error for a matrix with the wrong number of rows or columns, with entries that are not finite or too large, or that is not symmetric.
pub(super) fn checked(matrix: &DMatrix<f64>, size: usize) -> Result<(), NotPositive> {
    if matrix.shape() != (size, size) {
        return Err(NotPositive::Shape { rows: matrix.nrows(), columns: matrix.ncols(), size });
    }
    if let Some(&entry) = matrix.as_slice().iter().find(|x| !crate::error::is_moderate(**x)) {
        return Err(NotPositive::Entry(entry));
    }
    let mut worst = 0.0_f64;
    for i in 0..size {
        for j in 0..i {
            let difference = (matrix[(i, j)] - matrix[(j, i)]).abs();
            let size = (matrix[(i, i)].abs() * matrix[(j, j)].abs()).sqrt();
            // Two mirrored entries count as unequal if they differ by more than the fraction `NEGLIGIBLE` of the geometric mean of their diagonal
            // entries.
            if difference > NEGLIGIBLE * size {
                worst = worst.max(difference);
            }
        }
    }
    if worst > 0.0 { Err(NotPositive::Asymmetry(worst)) } else { Ok(()) }
}

pub(super) fn least_eigenvalue(matrix: &DMatrix<f64>) -> f64 {
    let symmetric = (matrix + matrix.transpose()) * 0.5;
    symmetric_eigen(&symmetric).0.last().copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_squares_add_up() -> Result<(), NotPositive> {
        // Three directions of very different lengths in five dimensions.
        let columns: Vec<DVector<f64>> = [1e6, 1.0, 1e-5]
            .iter()
            .enumerate()
            .map(|(k, size)| DVector::from_fn(5, |i, _| size * (1.0 + (i * (k + 2)) as f64).sin()))
            .collect();
        let matrix = columns.iter().fold(DMatrix::zeros(5, 5), |sum, l| sum + l * l.transpose());
        let found = squares(&matrix, 5)?;
        let back = found.iter().fold(DMatrix::zeros(5, 5), |sum: DMatrix<f64>, l| sum + l * l.transpose());
        assert!((back - &matrix).amax() < 1e-15 * matrix.amax());
        assert!(found.len() <= 5);
        Ok(())
    }

    #[test]
    fn what_is_indefinite_is_told_by_its_eigenvalue() {
        let saddle = DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 2.0, 1.0]);
        let result = squares(&saddle, 2);
        assert!(
            matches!(result, Err(NotPositive::Eigenvalue(value)) if (value + 1.0).abs() < 1e-14),
            "{result:?}"
        );
        let zero_diagonal = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 1.0, 0.0]);
        assert!(matches!(squares(&zero_diagonal, 2), Err(NotPositive::Eigenvalue(_))));
        assert!(matches!(squares(&zero_diagonal, 3), Err(NotPositive::Shape { .. })));
        let skew = DMatrix::from_row_slice(2, 2, &[1.0, 0.5, 0.0, 1.0]);
        assert_eq!(squares(&skew, 2), Err(NotPositive::Asymmetry(0.5)));
    }
}
