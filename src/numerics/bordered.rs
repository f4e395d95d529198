//! A linear system with one row and one column more than the balance of the object: that of a pivot.
//!
//! ```text
//! T y  + c₀ z₀ = …      balance
//! gᵀy  + γ  z₀ = …      the pair that is out of the basis
//! ```
//!
//! T alone may be singular on the way, the bordered matrix of an exact basis is not.

use nalgebra::{SMatrix, SVector};

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

impl<const D: usize> Default for Bordered<D> {
    /// Those of no matrix yet.
    fn default() -> Self {
        let row = Row { body: [0.0; D], last: 0.0 };
        Self { rows: [row; D], border: row, order: [0; D], order_of_border: 0 }
    }
}

impl<const D: usize> Bordered<D> {
    /// `None` if the matrix is singular.
    pub(crate) fn new(
        stiffness: &SMatrix<f64, D, D>,
        cover: &SVector<f64, D>,
        gradient: &SVector<f64, D>,
        corner: f64,
    ) -> Option<Self> {
        let mut factors = Self::default();
        factors.assign(stiffness, cover, gradient, corner)?;
        Some(factors)
    }

    /// The factors of another matrix, in the same memory. `None` if it is singular: then they are those of none.
    pub(crate) fn assign(
        &mut self,
        stiffness: &SMatrix<f64, D, D>,
        cover: &SVector<f64, D>,
        gradient: &SVector<f64, D>,
        corner: f64,
    ) -> Option<()> {
        for (i, row) in self.rows.iter_mut().enumerate() {
            *row = Row { body: std::array::from_fn(|j| stiffness[(i, j)]), last: cover[i] };
        }
        self.border = Row { body: std::array::from_fn(|j| gradient[j]), last: corner };
        (self.order, self.order_of_border) = (std::array::from_fn(|i| i), D);
        for k in 0..D {
            self.eliminate(k)?;
        }
        self.border.last = inverse(self.border.last)?;
        Some(())
    }

    /// Makes column k zero below its pivot, which is the largest entry there.
    fn eliminate(&mut self, k: usize) -> Option<()> {
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
        } else if pivot != k {
            rows.swap(k, pivot);
            order.swap(k, pivot);
        }
        let inverse = inverse(rows[k].body[k])?;
        // Only needed to divide by.
        rows[k].body[k] = inverse;
        // With zeros up to the pivot every row is one loop of fixed length, which is faster.
        let row = std::array::from_fn::<_, D, _>(|j| if j > k { rows[k].body[j] } else { 0.0 });
        let last = rows[k].last;
        for below in rows[k + 1..].iter_mut().chain(std::iter::once(border)) {
            let factor = below.body[k] * inverse;
            for j in 0..D {
                below.body[j] -= factor * row[j];
            }
            below.body[k] = factor;
            below.last -= factor * last;
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

/// One over a pivot; `None` where that is no number, or hardly one.
fn inverse(pivot: f64) -> Option<f64> {
    pivot.is_normal().then(|| 1.0 / pivot)
}
