//! Linear complementarity problems that belong to no grasp.

use grasp_lcp::lcp::{Lcp, LcpError};
use grasp_lcp::nalgebra::{DMatrix, DVector};
use numpy::ndarray::{ArrayView1, ArrayView2};
use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::answers::json;
use crate::errors::wrong;

/// Solves `0 <= z ⟂ M z + q >= 0`. Returns the outcome as JSON and as a sentence.
#[pyfunction]
pub(crate) fn solve_lcp(
    py: Python<'_>,
    matrix: PyReadonlyArray2<'_, f64>,
    vector: PyReadonlyArray1<'_, f64>,
) -> PyResult<(String, String)> {
    let problem = Lcp::new(of_rows(matrix.as_array()), of_list(vector.as_array())).map_err(misfit)?;
    let outcome = py.detach(|| problem.solve());
    Ok((json(&outcome)?, outcome.to_string()))
}

pub(crate) fn of_rows(rows: ArrayView2<'_, f64>) -> DMatrix<f64> {
    DMatrix::from_fn(rows.nrows(), rows.ncols(), |i, j| rows[[i, j]])
}

pub(crate) fn of_list(list: ArrayView1<'_, f64>) -> DVector<f64> {
    DVector::from_fn(list.len(), |i, _| list[i])
}

/// The error as a `ValueError` that names the argument `M` or `q`.
pub(crate) fn misfit(error: LcpError) -> PyErr {
    match error {
        LcpError::NotSquare { rows, columns } => {
            wrong(format_args!("M: {rows} x {columns} given, must be square"))
        }
        LcpError::Length { what, given, needed } => {
            wrong(format_args!("{what}: {given} numbers given, must be {needed}"))
        }
        LcpError::MatrixEntry { what, row, column, value } => {
            wrong(format_args!("{what}[{row}, {column}] is {value}, must be finite"))
        }
        other => wrong(other),
    }
}
