//! A linear system with one row and one column more than the balance of the object: that of a pivot.
//!
//! ```text
//! T y  + c₀ z₀ = …      balance
//! gᵀy  + γ  z₀ = …      the pair that is out of the basis
//! ```
//!
//! T alone may be singular on the way, the bordered matrix of an exact basis is not.

use nalgebra::{SMatrix, SVector};

/// A pivot below this part of the largest entry counts as zero: less is rounding of the sums that T is made of.
const SINGULAR: f64 = 0.0;

/// One row of a bordered matrix.
#[derive(Debug, Clone, Copy)]
struct Row<const D: usize> {
    body: [f64; D],
    last: f64,
}

/// LU factors with partial pivoting of a bordered matrix with d + 1 rows.
#[derive(Debug, Clone)]
pub(crate) struct Bordered<const D: usize> {
    rows: [Row<D>; D],
    /// The row below them.
    border: Row<D>,
    /// Where the rows come from, the border being D.
    order: [usize; D],
    order_of_border: usize,
}

impl<const D: usize> Bordered<D> {
    /// `None` if the matrix is singular.
    pub(crate) fn new(
        stiffness: &SMatrix<f64, D, D>,
        cover: &SVector<f64, D>,
        gradient: &SVector<f64, D>,
        corner: f64,
    ) -> Option<Self> {
        let largest =
            [stiffness.amax(), cover.amax(), gradient.amax()].into_iter().fold(corner.abs(), f64::max);
        let row = |i: usize| Row { body: std::array::from_fn(|j| stiffness[(i, j)]), last: cover[i] };
        let mut factor = Self {
            rows: std::array::from_fn(row),
            border: Row { body: std::array::from_fn(|j| gradient[j]), last: corner },
            order: std::array::from_fn(|i| i),
            order_of_border: D,
        };
        for k in 0..D {
            factor.eliminate(k, SINGULAR * largest)?;
        }
        let pivot = factor.border.last;
        if is_zero(pivot, SINGULAR * largest) {
            return None;
        }
        factor.border.last = 1.0 / pivot;
        Some(factor)
    }

    /// Makes column k zero below its pivot, which is the largest entry there.
    fn eliminate(&mut self, k: usize, zero: f64) -> Option<()> {
        let Self { rows, border, order, order_of_border } = self;
        let (mut pivot, mut most) = (k, rows[k].body[k].abs());
        for i in k + 1..D {
            if rows[i].body[k].abs() > most {
                (pivot, most) = (i, rows[i].body[k].abs());
            }
        }
        if border.body[k].abs() > most {
            std::mem::swap(&mut rows[k], border);
            std::mem::swap(&mut order[k], order_of_border);
        } else {
            rows.swap(k, pivot);
            order.swap(k, pivot);
        }
        if is_zero(rows[k].body[k], zero) {
            return None;
        }
        let inverse = 1.0 / rows[k].body[k];
        // Only needed to divide by.
        rows[k].body[k] = inverse;
        let row = rows[k];
        for below in rows[k + 1..].iter_mut().chain(std::iter::once(border)) {
            let factor = below.body[k] * inverse;
            below.body[k] = factor;
            for j in k + 1..D {
                below.body[j] -= factor * row.body[j];
            }
            below.last -= factor * row.last;
        }
        Some(())
    }

    /// The least pivot over the largest.
    pub(crate) fn least_pivot(&self) -> f64 {
        let inverses = (0..D).map(|k| self.rows[k].body[k]).chain(std::iter::once(self.border.last));
        let pivots = inverses.map(|inverse| 1.0 / inverse.abs());
        let [least, largest] = [f64::min, f64::max].map(|pick| pivots.clone().reduce(pick).unwrap_or(0.0));
        least / largest
    }

    pub(crate) fn solve(&self, balance: &SVector<f64, D>, last: f64) -> (SVector<f64, D>, f64) {
        self.solve_each([(balance, last)])[0]
    }

    /// Solutions for several right-hand sides.
    pub(crate) fn solve_each<const R: usize>(
        &self,
        sides: [(&SVector<f64, D>, f64); R],
    ) -> [(SVector<f64, D>, f64); R] {
        let given = |from: usize| sides.map(|(balance, last)| if from == D { last } else { balance[from] });
        let mut x: [[f64; R]; D] = std::array::from_fn(|i| given(self.order[i]));
        let mut z = given(self.order_of_border);
        for j in 0..D {
            let known = x[j];
            for i in j + 1..D {
                for r in 0..R {
                    x[i][r] -= self.rows[i].body[j] * known[r];
                }
            }
            for r in 0..R {
                z[r] -= self.border.body[j] * known[r];
            }
        }
        for r in 0..R {
            z[r] *= self.border.last;
        }
        for i in 0..D {
            for r in 0..R {
                x[i][r] -= self.rows[i].last * z[r];
            }
        }
        for j in (0..D).rev() {
            for r in 0..R {
                x[j][r] *= self.rows[j].body[j];
            }
            let known = x[j];
            for i in 0..j {
                for r in 0..R {
                    x[i][r] -= self.rows[i].body[j] * known[r];
                }
            }
        }
        std::array::from_fn(|r| (SVector::from_fn(|i, _| x[i][r]), z[r]))
    }
}

/// Whether a pivot is too small; so is one that is no number.
fn is_zero(pivot: f64, zero: f64) -> bool {
    pivot.abs().partial_cmp(&zero) != Some(std::cmp::Ordering::Greater)
}
