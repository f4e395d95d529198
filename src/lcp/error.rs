//! Malformed input.

use thiserror::Error;

/// What can be wrong with the numbers a problem is made of.
///
/// "There is no solution" is not among them: that is an answer, see [`Outcome`](super::Outcome).
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum LcpError {
    /// M must have as many columns as rows.
    #[error(
        "the matrix of a complementarity problem must be square, but it has {rows} rows and {columns} columns"
    )]
    NotSquare {
        /// Rows of the matrix given.
        rows: usize,
        /// Columns of the matrix given.
        columns: usize,
    },
    /// A vector must have one entry per row of M.
    #[error("{what} has {given} entries, but the problem has {needed} rows")]
    Length {
        /// Which vector.
        what: &'static str,
        /// Its length.
        given: usize,
        /// The length it must have.
        needed: usize,
    },
    /// A block of a mixed problem must fit the others.
    #[error(
        "block {what} has {rows} rows and {columns} columns, but must have {needed_rows} and {needed_columns}"
    )]
    BlockShape {
        /// Which block.
        what: &'static str,
        /// Its rows.
        rows: usize,
        /// Its columns.
        columns: usize,
        /// The rows it must have.
        needed_rows: usize,
        /// The columns it must have.
        needed_columns: usize,
    },
    /// An entry of a matrix is infinite or not a number.
    #[error("entry ({row}, {column}) of {what} is {value}, not a finite number")]
    MatrixEntry {
        /// Which matrix.
        what: &'static str,
        /// Row of the entry, counted from 0.
        row: usize,
        /// Column of the entry, counted from 0.
        column: usize,
        /// The entry.
        value: f64,
    },
    /// An entry of a vector is infinite or not a number.
    #[error("entry {row} of {what} is {value}, not a finite number")]
    VectorEntry {
        /// Which vector.
        what: &'static str,
        /// Row of the entry, counted from 0.
        row: usize,
        /// The entry.
        value: f64,
    },
}
