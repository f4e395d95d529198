//! A compliance matrix over the contacts of a finger, split into springs of its pads and displacements that couple them.
//!
//! The law of a contact is explicit, and has one answer, as long as its own springs stand along its axes. So a part of the compliance goes to the pads,
//! axis by axis, and the rest becomes coordinates with unit springs:
//!
//! ```text
//! S = diag C,    D = ½ λ_min(S^-½ C S^-½) S,    C = D + V Vᵀ
//! ```
//!
//! Half of the least eigenvalue and not all of it: with all of it V loses rank, and where it does is up to rounding.

use nalgebra::{DMatrix, DVector};

use super::positive::{NotPositive, checked, least_eigenvalue, squares};
use crate::prelude::*;

/// A compliance whose least scaled eigenvalue is below this is singular up to rounding: along some direction the contacts would be rigid.
const REGULAR: f64 = 1e-12;

/// The compliances of the pads, and the columns of V.
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
    let scaled = DMatrix::from_fn(size, size, |i, j| compliance[(i, j)] / (root[i] * root[j]));
    let least = least_eigenvalue(&scaled);
    if least <= REGULAR {
        return Err(NotPositive::Eigenvalue(least_eigenvalue(compliance)));
    }
    let pads = whole * (0.5 * least);
    let mut rest = compliance.clone();
    for i in 0..size {
        rest[(i, i)] -= pads[i];
    }
    Ok((pads, squares(&rest, size)?))
}
