//! A linear system with one row and one column more than the balance of the object: that of a pivot.
//!
//! ```text
//! T y  + c₀ z₀ = …      balance
//! gᵀy  + γ  z₀ = …      the pair that is out of the basis
//! ```
//!
//! T alone may be singular on the way, the bordered matrix of an exact basis is not.

use nalgebra::{SMatrix, SVector};

/// d + 1 in space.
const MOST: usize = 7;
/// A pivot below this part of the largest entry counts as zero: less is rounding of the sums that T is made of.
const SINGULAR: f64 = 0.0;

/// LU factors with partial pivoting of a bordered matrix with d + 1 rows.
#[derive(Debug, Clone)]
pub(crate) struct Bordered<const D: usize> {
    lu: [[f64; MOST]; MOST],
    order: [usize; MOST],
}

impl<const D: usize> Bordered<D> {
    /// `None` if the matrix is singular.
    pub(crate) fn new(
        stiffness: &SMatrix<f64, D, D>,
        cover: &SVector<f64, D>,
        gradient: &SVector<f64, D>,
        corner: f64,
    ) -> Option<Self> {
        let mut lu = [[0.0; MOST]; MOST];
        let mut largest = corner.abs();
        for i in 0..D {
            for j in 0..D {
                lu[i][j] = stiffness[(i, j)];
                largest = largest.max(lu[i][j].abs());
            }
            lu[i][D] = cover[i];
            lu[D][i] = gradient[i];
            largest = largest.max(cover[i].abs()).max(gradient[i].abs());
        }
        lu[D][D] = corner;
        let mut order = std::array::from_fn(|i| i);
        for k in 0..=D {
            let mut pivot = k;
            for i in k + 1..=D {
                if lu[i][k].abs() > lu[pivot][k].abs() {
                    pivot = i;
                }
            }
            // Also for a matrix with entries that are not finite.
            if lu[pivot][k].abs().partial_cmp(&(SINGULAR * largest)) != Some(std::cmp::Ordering::Greater) {
                return None;
            }
            lu.swap(k, pivot);
            order.swap(k, pivot);
            let inverse = 1.0 / lu[k][k];
            // Only needed to divide by.
            lu[k][k] = inverse;
            let row = lu[k];
            for below in &mut lu[k + 1..=D] {
                let factor = below[k] * inverse;
                below[k] = factor;
                for j in k + 1..=D {
                    below[j] -= factor * row[j];
                }
            }
        }
        Some(Self { lu, order })
    }

    /// The least pivot over the largest.
    pub(crate) fn least_pivot(&self) -> f64 {
        let pivots = (0..=D).map(|k| 1.0 / self.lu[k][k].abs());
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
        let mut x = [[0.0; R]; MOST];
        for i in 0..=D {
            let from = self.order[i];
            for (r, (balance, last)) in sides.iter().enumerate() {
                x[i][r] = if from == D { *last } else { balance[from] };
            }
        }
        for j in 0..=D {
            let known = x[j];
            for i in j + 1..=D {
                for r in 0..R {
                    x[i][r] -= self.lu[i][j] * known[r];
                }
            }
        }
        for j in (0..=D).rev() {
            for r in 0..R {
                x[j][r] *= self.lu[j][j];
            }
            let known = x[j];
            for i in 0..j {
                for r in 0..R {
                    x[i][r] -= self.lu[i][j] * known[r];
                }
            }
        }
        std::array::from_fn(|r| (SVector::from_fn(|i, _| x[i][r]), x[D][r]))
    }
}
