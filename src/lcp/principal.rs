//! The point z of a complementary basis, by factorisation of the principal block M_αα of the basis. The problem is 0 ≤ z ⟂ w = M z + q ≥ 0. α is the
//! set of the i with z_i basic.

use super::problem::Lcp;
use super::scaling::Scaling;
use crate::numerics::tolerances::FEW_ROUNDINGS;
use crate::numerics::{matrix_of, vector_of};
use nalgebra::{DMatrix, DVector};

/// Solves M_αα z_α = −q_α by pivoted LU, with refinement, after rows and columns of the block are scaled by powers of two, so that its entries lie
/// near 1. `None` if the block is singular to working precision.
pub(super) fn solve(lcp: &Lcp, alpha: &[usize]) -> Option<DVector<f64>> {
    let size = alpha.len();
    let block = matrix_of(size, size, &|i, j| lcp.m[(alpha[i], alpha[j])]);
    solve_block(block, &vector_of(size, &|i| -lcp.q[alpha[i]]))
}

/// Solves a square system by pivoted LU, with refinement, after rows and columns are scaled by powers of two, so that entries lie near 1. `None` if
/// the matrix is singular to working precision.
pub(super) fn solve_block(mut block: DMatrix<f64>, rhs: &DVector<f64>) -> Option<DVector<f64>> {
    let size = rhs.len();
    if size == 0 {
        return Some(DVector::zeros(0));
    }
    let mut scaling = Scaling::default();
    // The block is balanced: rows and columns are scaled so that its entries lie near 1. A right-hand side of zeros has no influence on this scaling.
    // If the given right-hand side were included, it would move the entries of the block away from 1.
    scaling.balance(size, block.as_slice(), &vec![0.0; size]);
    for j in 0..size {
        for i in 0..size {
            block[(i, j)] *= scaling.row[i] * scaling.column[j];
        }
    }
    let rhs = vector_of(size, &|i| rhs[i] * scaling.row[i]);
    // Complete pivoting identifies singular blocks more reliably. For larger blocks partial pivoting is used, since it is several times faster.
    let y = if size <= 32 {
        let lu = block.clone().full_piv_lu();
        is_regular(&lu.lu_internal().diagonal()).then_some(())?;
        refined(&block, &rhs, |b| lu.solve(b))
    } else {
        let lu = block.clone().lu();
        is_regular(&lu.lu_internal().diagonal()).then_some(())?;
        refined(&block, &rhs, |b| lu.solve(b))
    }?;
    Some(vector_of(size, &|j| y[j] * scaling.column[j]))
}

fn is_regular(diagonal: &DVector<f64>) -> bool {
    // Entries of the balanced block are near 1, so pivots are compared with 1.
    diagonal.iter().all(|u| u.abs() > FEW_ROUNDINGS)
}

fn refined(
    block: &DMatrix<f64>,
    rhs: &DVector<f64>,
    solve: impl Fn(&DVector<f64>) -> Option<DVector<f64>>,
) -> Option<DVector<f64>> {
    let mut y = solve(rhs)?;
    // The first refinement step removes the error of the factorisation, the second the error that remains in ill-conditioned blocks.
    for _ in 0..2 {
        y += solve(&(rhs - block * &y))?;
    }
    Some(y)
}
