//! Factors `T = L D Lᵀ` of symmetric matrices, lane by lane.

use super::lanes::Packed;
use crate::numerics::tolerances::LINEARLY_DEPENDENT;

/// The factors of a matrix, with room for `R` rows.
#[derive(Debug, Clone, Copy)]
pub(super) struct LaneFactors<const R: usize, X: Packed> {
    /// L below the diagonal, and D⁻¹ on it; zero in place of 1/d where the pivot vanishes up to rounding.
    pub(super) entries: [[X; R]; R],
    /// Positive if some pivot vanishes up to rounding.
    pub(super) free: X,
}

impl<const R: usize, X: Packed> LaneFactors<R, X> {
    /// All zero.
    pub(super) fn none() -> Self {
        Self { entries: [[X::all(0.0); R]; R], free: X::all(0.0) }
    }

    /// Factorises in place the matrix of `rows` rows whose entries on and below the diagonal are stored. `last_is_free` means that the last pivot is
    /// known to vanish.
    #[inline(always)]
    pub(super) fn factorize(&mut self, rows: usize, last_is_free: bool) {
        let (zero, one) = (X::all(0.0), X::all(1.0));
        let t = &mut self.entries;
        let mut free = zero;
        for column in 0..rows {
            let whole = t[column][column];
            // Columns to the left hold L already.
            let mut scaled = [zero; R];
            let mut pivot = whole;
            for k in 0..column {
                // t[k][k] holds 1/d_k; L_ck d_k is stored above the diagonal.
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

    /// `T⁻¹ w`; rows whose pivot vanishes contribute zero.
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

    /// `1/d` of a row.
    #[inline(always)]
    pub(super) fn one_over_pivot(&self, row: usize) -> X {
        self.entries[row][row]
    }
}
