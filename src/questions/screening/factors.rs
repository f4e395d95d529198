//! Factors `T = L D Lᵀ` of several symmetric matrices, one matrix in each lane of a vector.

use super::lanes::Packed;
use crate::numerics::tolerances::LINEARLY_DEPENDENT;

/// The factors L and D of several symmetric matrices `L D Lᵀ`, one in each lane of a vector, with room for `R` rows.
#[derive(Debug, Clone, Copy)]
pub(super) struct LaneFactors<const R: usize, X: Packed> {
    /// The triangular factor L below the diagonal, and the inverse of the diagonal factor D on it. If a pivot d of D vanishes up to rounding, the
    /// diagonal has zero in place of 1/d.
    pub(super) entries: [[X; R]; R],
    /// For each lane, positive if some pivot of the factorisation vanishes up to rounding; else zero.
    pub(super) free: X,
}

impl<const R: usize, X: Packed> LaneFactors<R, X> {
    /// Factors with all entries zero.
    pub(super) fn none() -> Self {
        Self { entries: [[X::all(0.0); R]; R], free: X::all(0.0) }
    }

    /// Factorises in place a matrix with `rows` rows whose entries on and below the diagonal are stored. If `last_is_free`, the last pivot is known
    /// to be zero up to rounding and is set to zero.
    #[inline(always)]
    pub(super) fn factorize(&mut self, rows: usize, last_is_free: bool) {
        let (zero, one) = (X::all(0.0), X::all(1.0));
        let t = &mut self.entries;
        let mut free = zero;
        for column in 0..rows {
            let whole = t[column][column];
            // The columns to the left of `column` hold L already.
            let mut scaled = [zero; R];
            let mut pivot = whole;
            for k in 0..column {
                // Here t[k][k] holds 1/d_k, and the entry above the diagonal holds L_ck d_k for column c.
                scaled[k] = t[k][column];
                pivot -= t[column][k] * scaled[k];
            }
            let is_known = last_is_free && column + 1 == rows;
            let bound = if is_known { X::all(f64::INFINITY) } else { X::all(LINEARLY_DEPENDENT) * whole };
            let inverse = pivot.above(bound, one / pivot, zero);
            free += pivot.above(bound, zero, one);
            t[column][column] = inverse;
            for row in column + 1..rows {
                let mut rest = t[row][column];
                for k in 0..column {
                    rest -= t[row][k] * scaled[k];
                }
                t[column][row] = rest;
                t[row][column] = rest * inverse;
            }
        }
        self.free = free;
    }

    /// The solution `T⁻¹ w` with the factorised matrix T. For a row whose pivot vanishes, the entry of D⁻¹ is zero.
    #[inline(always)]
    pub(super) fn solve(&self, rows: usize, w: &[X; R]) -> [X; R] {
        let f = &self.entries;
        let mut q = *w;
        for row in 1..rows {
            for column in 0..row {
                q[row] -= f[row][column] * q[column];
            }
        }
        for row in 0..rows {
            q[row] = q[row] * f[row][row];
        }
        for row in (0..rows).rev() {
            for below in row + 1..rows {
                q[row] -= f[below][row] * q[below];
            }
        }
        q
    }

    /// The inverse 1/d of the pivot d of row `row`; zero if the pivot vanishes up to rounding.
    #[inline(always)]
    pub(super) fn one_over_pivot(&self, row: usize) -> X {
        self.entries[row][row]
    }
}
