//! Frictional contact problems (W, q, μ) that belong to no grasp.

use grasp_lcp::friction::{Error, FrictionProblem, Solution};
use grasp_lcp::lcp::Outcome;
use numpy::{PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::answers::json;
use crate::errors::wrong;
use crate::lcp::{misfit, of_list, of_rows};

/// Solves `u = W r + q` with Coulomb's law, for contacts of two or three components. Returns the outcome as JSON and as a sentence.
#[pyfunction]
pub(crate) fn solve_friction(
    py: Python<'_>,
    matrix: PyReadonlyArray2<'_, f64>,
    vector: PyReadonlyArray1<'_, f64>,
    friction: PyReadonlyArray1<'_, f64>,
) -> PyResult<(String, String)> {
    let (numbers, contacts) = (vector.len(), friction.len());
    let (matrix, vector) = (of_rows(matrix.as_array()), of_list(vector.as_array()));
    let friction = friction.as_array().iter().copied().collect();
    let outcome = match numbers {
        _ if numbers == 2 * contacts => {
            let problem = FrictionProblem::<2>::new(matrix, vector, friction).map_err(fault)?;
            py.detach(|| problem.solve())
        }
        _ if numbers == 3 * contacts => {
            let problem = FrictionProblem::<3>::new(matrix, vector, friction).map_err(fault)?;
            py.detach(|| problem.solve())
        }
        _ => {
            return Err(wrong(format_args!(
                "q: {numbers} numbers given, must be 2 or 3 for each of the {contacts} in mu"
            )));
        }
    };
    told(&outcome)
}

fn told(outcome: &Outcome<Solution>) -> PyResult<(String, String)> {
    Ok((json(outcome)?, outcome.to_string()))
}

fn fault(error: Error) -> PyErr {
    match error {
        Error::Numbers(error) => misfit(error),
        Error::Friction { contact, value } => {
            wrong(format_args!("mu[{contact}] is {value}, must be finite and not negative"))
        }
        other => wrong(other),
    }
}
