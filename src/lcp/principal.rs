//! The point of a complementary basis, by a fresh factorisation of its principal block.

use super::scaling::Scaling;
use nalgebra::{DMatrix, DVector};

/// Solves M_αα z_α = −q_α by LU with pivoting of the balanced block, with two steps of refinement; `None` if
/// the block is singular to working precision.
pub(crate) fn solve(m: &DMatrix<f64>, q: &DVector<f64>, alpha: &[usize]) -> Option<DVector<f64>> {
    let k = alpha.len();
    if k == 0 {
        return Some(DVector::zeros(0));
    }
    let mut block = DMatrix::from_fn(k, k, |i, j| m[(alpha[i], alpha[j])]);
    let rhs = DVector::from_fn(k, |i, _| -q[alpha[i]]);
    let mut scaling = Scaling::default();
    scaling.balance(k, block.as_slice(), rhs.as_slice());
    for j in 0..k {
        for i in 0..k {
            block[(i, j)] *= scaling.row[i] * scaling.column[j];
        }
    }
    let rhs = DVector::from_fn(k, |i, _| rhs[i] * scaling.row[i]);
    let y = if k <= COMPLETE {
        let lu = block.clone().full_piv_lu();
        regular(&lu.lu_internal().diagonal()).then_some(())?;
        refined(&block, &rhs, |b| lu.solve(b))
    } else {
        let lu = block.clone().lu();
        regular(&lu.lu_internal().diagonal()).then_some(())?;
        refined(&block, &rhs, |b| lu.solve(b))
    }?;
    Some(DVector::from_fn(k, |j, _| y[j] * scaling.column[j]))
}

/// Up to this size pivoting is complete, which tells singular blocks apart more surely; beyond it only partial, which is
/// several times faster.
const COMPLETE: usize = 32;

fn regular(diagonal: &DVector<f64>) -> bool {
    diagonal.iter().all(|u| u.abs() > SINGULAR)
}

/// The solution with two steps of refinement.
fn refined(
    block: &DMatrix<f64>,
    rhs: &DVector<f64>,
    solve: impl Fn(&DVector<f64>) -> Option<DVector<f64>>,
) -> Option<DVector<f64>> {
    let mut y = solve(rhs)?;
    for _ in 0..2 {
        y += solve(&(rhs - block * &y))?;
    }
    Some(y)
}

/// The entries of the balanced block are near 1; a pivot below this is noise.
const SINGULAR: f64 = 1e-15;
