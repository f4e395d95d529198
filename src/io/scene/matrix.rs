//! Matrices as lists of rows.

use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};

use crate::numerics::{matrix_of, numbered};
use crate::serial::{Given, Number};

/// The rows of a matrix.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(transparent)]
pub(super) struct Rows(Vec<Vec<Number<Given>>>);

impl Rows {
    pub(super) fn of(matrix: &DMatrix<f64>) -> Self {
        let row = |i: usize| numbered(matrix.ncols(), &|j| Number::new(matrix[(i, j)]));
        Self(numbered(matrix.nrows(), &row))
    }

    /// The matrix; `field` names it in messages.
    pub(super) fn matrix(&self, field: &str) -> Result<DMatrix<f64>, String> {
        let columns = self.0.first().map_or(0, Vec::len);
        if let Some(i) = self.0.iter().position(|row| row.len() != columns) {
            return Err(format!(
                "{field}: row {i} has {} numbers, must be {columns} as in row 0",
                self.0[i].len()
            ));
        }
        Ok(matrix_of(self.0.len(), columns, &|i, j| self.0[i][j].0))
    }
}
