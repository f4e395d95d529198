//! The rows of a quadratic program, collected one by one with their meaning.

use crate::numerics::matrix_of;
use nalgebra::{DMatrix, DVector};

use crate::prelude::*;

/// Rows of a linear system in `columns` unknowns, each with its right-hand side and its meaning.
pub(super) struct ProgramRows<Says> {
    columns: usize,
    says: Vec<Says>,
    rows: Vec<DVector<f64>>,
    right: Vec<f64>,
}

impl<Says> ProgramRows<Says> {
    pub(super) fn new(columns: usize) -> Self {
        Self { columns, says: Vec::new(), rows: Vec::new(), right: Vec::new() }
    }

    pub(super) fn push(&mut self, says: Says, row: DVector<f64>, right: f64) {
        self.says.push(says);
        self.rows.push(row);
        self.right.push(right);
    }

    /// Appends a row given by its non-zero entries, each with its column.
    pub(super) fn push_terms(
        &mut self,
        says: Says,
        terms: impl IntoIterator<Item = (usize, f64)>,
        right: f64,
    ) {
        let mut row = DVector::zeros(self.columns);
        terms.into_iter().for_each(|(column, value)| row[column] += value);
        self.push(says, row, right);
    }

    /// The meanings of the rows, their matrix, and their right-hand sides.
    pub(super) fn finish(self) -> (Vec<Says>, DMatrix<f64>, DVector<f64>) {
        let matrix = matrix_of(self.rows.len(), self.columns, &|i, j| self.rows[i][j]);
        (self.says, matrix, DVector::from_vec(self.right))
    }
}
