//! Errors in the input of a complementarity problem: matrices or vectors with the wrong number of rows, columns or entries, and entries that are not
//! finite.

use nalgebra::{DMatrix, DVector};
use thiserror::Error;

/// Faults in the input of a problem.
///
/// That no solution exists is not an error but an answer ([`Outcome`](super::Outcome)).
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum LcpError {
    /// The matrix M is not square.
    #[error(
        "the matrix of a complementarity problem must be square, but it has {rows} rows and {columns} columns"
    )]
    NotSquare {
        /// Number of rows of the given matrix.
        rows: usize,
        /// Number of columns of the given matrix.
        columns: usize,
    },
    /// The number of entries of a row of M differs from the number of rows.
    #[error("row {row} of M has {given} entries, but must have {needed}")]
    RowLength {
        /// The row, counted from 0.
        row: usize,
        /// Length of this row.
        given: usize,
        /// The required length.
        needed: usize,
    },
    /// A vector does not have the required number of entries, such as q without one entry for each row of M.
    #[error("{what} has {given} entries, but the problem has {needed} rows")]
    Length {
        /// Name of the vector, for example q.
        what: &'static str,
        /// Length of this vector.
        given: usize,
        /// The required length.
        needed: usize,
    },
    /// A matrix does not have the required numbers of rows and columns, such as the matrix W of a [frictional contact problem](crate::friction).
    #[error(
        "block {what} has {rows} rows and {columns} columns, but must have {needed_rows} and {needed_columns}"
    )]
    BlockShape {
        /// Name of the matrix.
        what: &'static str,
        /// Number of rows of this matrix.
        rows: usize,
        /// Number of columns of this matrix.
        columns: usize,
        /// The required number of rows.
        needed_rows: usize,
        /// The required number of columns.
        needed_columns: usize,
    },
    /// An entry of a matrix is infinite or not a number.
    #[error("entry ({row}, {column}) of {what} is {value}, not a finite number")]
    MatrixEntry {
        /// Name of the matrix.
        what: &'static str,
        /// Row of the entry, counted from 0.
        row: usize,
        /// Column of the entry, counted from 0.
        column: usize,
        /// The value of the entry.
        value: f64,
    },
    /// An entry of a vector is infinite or not a number.
    #[error("entry {row} of {what} is {value}, not a finite number")]
    VectorEntry {
        /// Name of the vector.
        what: &'static str,
        /// Row of the entry, counted from 0.
        row: usize,
        /// The value of the entry.
        value: f64,
    },
}

impl LcpError {
    /// Checks that a matrix is square and all its entries are finite; `what` names the matrix in the error.
    pub(super) fn check_square(what: &'static str, m: &DMatrix<f64>) -> Result<(), Self> {
        let (rows, columns) = m.shape();
        if rows != columns {
            return Err(Self::NotSquare { rows, columns });
        }
        Self::check_entries(what, m)
    }

    /// Checks that a matrix has the shape (rows, columns) and all its entries are finite; `what` names the matrix in the error.
    pub(crate) fn check_block(
        what: &'static str,
        block: &DMatrix<f64>,
        (needed_rows, needed_columns): (usize, usize),
    ) -> Result<(), Self> {
        let (rows, columns) = block.shape();
        if (rows, columns) != (needed_rows, needed_columns) {
            return Err(Self::BlockShape { what, rows, columns, needed_rows, needed_columns });
        }
        Self::check_entries(what, block)
    }

    /// Checks that a vector has `needed` entries, all of them finite; `what` names the vector in the error.
    pub(crate) fn check_vector(what: &'static str, v: &DVector<f64>, needed: usize) -> Result<(), Self> {
        if v.len() != needed {
            return Err(Self::Length { what, given: v.len(), needed });
        }
        match v.as_slice().iter().position(|x| !x.is_finite()) {
            Some(row) => Err(Self::VectorEntry { what, row, value: v[row] }),
            None => Ok(()),
        }
    }

    fn check_entries(what: &'static str, m: &DMatrix<f64>) -> Result<(), Self> {
        // nalgebra stores matrices column by column.
        match m.as_slice().iter().position(|x| !x.is_finite()) {
            Some(at) => {
                let (row, column) = (at % m.nrows(), at / m.nrows());
                Err(Self::MatrixEntry { what, row, column, value: m[at] })
            }
            None => Ok(()),
        }
    }
}
