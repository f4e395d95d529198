//! Small linear systems by LU with complete pivoting: rank, kernels, and the part of a right-hand side outside the range.

use super::tolerances::LINEARLY_DEPENDENT;
use crate::numerics::{Indices, IntoList, Reals, Square, Vector};
use crate::prelude::*;

/// Complete-pivoting LU of the block of the first `rows` rows and `cols` columns of a square matrix.
#[derive(Debug, Clone)]
pub(crate) struct CompletePivoting {
    lu: Square,
    row_order: Indices,
    col_order: Indices,
    rows: usize,
    cols: usize,
    rank: usize,
}

impl CompletePivoting {
    pub(crate) fn new(mut a: Square, rows: usize, cols: usize) -> Self {
        let d = a.size().count();
        let mut row_order = a.size().in_order();
        let mut col_order = row_order.clone();
        let mut rank = 0;
        let mut largest = 0.0_f64;
        while rank < rows.min(cols) {
            let k = rank;
            let (mut pi, mut pj, mut most) = (k, k, 0.0);
            for j in k..cols {
                for (i, entry) in a.column_slice(j)[..rows].iter().enumerate().skip(k) {
                    let size = entry.abs();
                    // Among entries of equal magnitude the pivot is the one in the first row, and there in the first column. The loops run column by
                    // column.
                    if size > most || size == most && (i, j) < (pi, pj) {
                        (pi, pj, most) = (i, j, size);
                    }
                }
            }
            largest = largest.max(most);
            if most <= LINEARLY_DEPENDENT * largest {
                break;
            }
            a.swap_rows(k, pi);
            a.swap_columns(k, pj);
            row_order.as_mut().swap(k, pi);
            col_order.as_mut().swap(k, pj);
            let (before, behind) = a.as_mut_slice().split_at_mut((k + 1) * d);
            let column = &mut before[k * d..][..rows];
            let pivot = column[k];
            column[k + 1..].iter_mut().for_each(|x| *x /= pivot);
            for other in behind.chunks_exact_mut(d).take(cols - (k + 1)) {
                let along = other[k];
                for i in k + 1..rows {
                    other[i] -= column[i] * along;
                }
            }
            rank += 1;
        }
        Self { lu: a, row_order, col_order, rows, cols, rank }
    }

    /// A solution x of `A x = b` for the factored matrix A. Components that are not determined are zero. Also returns the largest component of
    /// the part of b outside the range of A.
    pub(crate) fn solve(&self, b: &Vector) -> (Vector, f64) {
        let mut components = Vector::all_zero(self.lu.size());
        let (d, lu, order) = (self.lu.size().count(), self.lu.as_slice(), self.row_order.as_ref());
        let y = components.as_mut_slice();
        for i in 0..self.rows {
            let known: f64 = (0..i.min(self.rank)).map(|j| lu[j * d + i] * y[j]).added();
            y[i] = b[order[i]] - known;
        }
        let unreached = (self.rank..self.rows).map(|i| y[i].abs()).most();
        (self.back_substitute(&components), unreached)
    }

    /// A basis of the kernel {x : A x = 0} of the factored matrix A.
    pub(crate) fn kernel(&self) -> Vec<Vector> {
        (self.rank..self.cols)
            .map(|free| {
                let mut y = Vector::zeros();
                for i in 0..self.rank {
                    y[i] = -self.lu[(i, free)];
                }
                let mut x = self.back_substitute(&y);
                x[self.col_order.as_ref()[free]] = 1.0;
                x
            })
            .list()
    }

    /// A basis of the left kernel {z : Aᵀ z = 0} of the factored matrix A.
    pub(crate) fn left_kernel(&self) -> Vec<Vector> {
        // With P A Q = L U, `Aᵀ z = 0` requires that the first `rank` components of `(P z)ᵀ L` vanish. These equations are solved from the last row
        // of L upwards.
        (self.rank..self.rows)
            .map(|free| {
                let mut y = Vector::zeros();
                y[free] = 1.0;
                for j in (0..self.rank).rev() {
                    y[j] = -(j + 1..self.rows).map(|i| y[i] * self.lu[(i, j)]).added();
                }
                let mut z = Vector::zeros();
                for i in 0..self.rows {
                    z[self.row_order.as_ref()[i]] = y[i];
                }
                z
            })
            .list()
    }

    /// Largest row sum of |A⁻¹| for the factored matrix A, at least 1: the factor by which an error of the right-hand side may grow.
    pub(crate) fn growth(&self) -> f64 {
        let mut sums = Vector::zeros();
        for e in 0..self.rank {
            let mut unit = Vector::zeros();
            unit[self.row_order.as_ref()[e]] = 1.0;
            let (x, _) = self.solve(&unit);
            for i in 0..self.lu.size().count() {
                sums[i] += x[i].abs();
            }
        }
        sums.iter().copied().fold(1.0, f64::max)
    }

    fn back_substitute(&self, y: &Vector) -> Vector {
        let size = self.lu.size();
        let (mut s, mut x) = (Vector::all_zero(size), Vector::all_zero(size));
        let (d, lu, order) = (self.lu.size().count(), self.lu.as_slice(), self.col_order.as_ref());
        let (s, found) = (s.as_mut_slice(), x.as_mut_slice());
        for i in (0..self.rank).rev() {
            let known: f64 = (i + 1..self.rank).map(|j| lu[j * d + i] * s[j]).added();
            s[i] = (y[i] - known) / lu[i * d + i];
            found[order[i]] = s[i];
        }
        x
    }
}
