//! Splits the compliance matrix of a finger's contacts into springs of the single contacts and coordinates that couple them.
//!
//! The response of a contact to a displacement is explicit and unique only if the contact has springs of its own along its axes. Therefore a diagonal
//! part D of the compliance matrix C becomes the contacts' springs. The rest, V Vᵀ, becomes further coordinates of the hand: one for each column of
//! V, each with a spring of unit stiffness. With the least eigenvalue λ_min of the matrix in brackets,
//!
//! ```text
//! S = diag C,    D = ½ λ_min(S^-½ C S^-½) S,    C = D + V Vᵀ
//! ```
//!
//! Only half of the least eigenvalue becomes springs of contacts. If the whole eigenvalue did, the matrix V Vᵀ would lose rank, and rounding would
//! decide which column of V vanishes.

use crate::numerics::matrix_of;
use nalgebra::{DMatrix, DVector};

use super::positive::{NotPositive, checked, least_eigenvalue, squares};
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::prelude::*;

/// Splits a compliance matrix as `D + V Vᵀ`, and returns the diagonal of D, m/N, and the columns of V. `size` is the required number of rows.
pub(super) fn split(
    compliance: &DMatrix<f64>,
    size: usize,
) -> Result<(DVector<f64>, Vec<DVector<f64>>), NotPositive> {
    checked(compliance, size)?;
    let whole = compliance.diagonal();
    if whole.iter().any(|s| *s <= 0.0) {
        return Err(NotPositive::Eigenvalue(least_eigenvalue(compliance)));
    }
    let root = whole.map(f64::sqrt);
    let scaled = matrix_of(size, size, &|i, j| compliance[(i, j)] / (root[i] * root[j]));
    let least = least_eigenvalue(&scaled);
    // If the least eigenvalue of the compliance matrix, after scaling to unit diagonal, is at most `SOLVED_ROUNDING`, it is zero up to rounding. The
    // contacts are then rigid along some direction.
    if least <= SOLVED_ROUNDING {
        return Err(NotPositive::Eigenvalue(least_eigenvalue(compliance)));
    }
    let pads = whole * (0.5 * least);
    let mut rest = compliance.clone();
    for i in 0..size {
        rest[(i, i)] -= pads[i];
    }
    Ok((pads, squares(&rest, size)?))
}
