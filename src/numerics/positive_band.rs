//! A symmetric positive definite band matrix and its Cholesky factors.
//!
//! With entries up to b positions from the diagonal, n rows cost ½ n b² multiplications, a quarter of the cost for an unsymmetric band.

use super::add_times::add_times;
use super::tolerances::POSITIVE_PIVOT;
use crate::numerics::{IntoList, dot};
use crate::prelude::*;

/// The lower half of a band matrix with entries up to `half_bandwidth` positions from the diagonal, or of its Cholesky factor.
#[derive(Debug, Clone)]
pub(crate) struct PositiveBand {
    /// The columns, each from the diagonal downwards.
    entries: Vec<f64>,
    height: usize,
}

impl PositiveBand {
    pub(crate) fn zeros(count: usize, half_bandwidth: usize) -> Self {
        Self { entries: vec![0.0; count * (half_bandwidth + 1)], height: half_bandwidth + 1 }
    }

    pub(crate) fn clear(&mut self) {
        self.entries.fill(0.0);
    }

    /// Adds x to the entry in row i and column j, on or below the diagonal.
    #[inline]
    pub(crate) fn add(&mut self, i: usize, j: usize, x: f64) {
        self.entries[j * self.height + i - j] += x;
    }

    /// Replaces the matrix A by its Cholesky factor L, with A = L Lᵀ. `None` if A is not positive definite beyond rounding: some pivot is at most
    /// [`POSITIVE_PIVOT`], 1e-12, of its diagonal entry.
    pub(crate) fn factor(&mut self) -> Option<()> {
        let height = self.height;
        let least: Vec<f64> =
            self.entries.chunks_exact(height).map(|column| POSITIVE_PIVOT * column[0]).list();
        for (j, least) in least.into_iter().enumerate() {
            let (before, behind) = self.entries.split_at_mut((j + 1) * height);
            let column = &mut before[j * height..];
            if column[0].is_nan() || column[0] <= least {
                return None;
            }
            let root = column[0].sqrt();
            column[0] = root;
            let below = &mut column[1..];
            for x in below.iter_mut() {
                *x /= root;
            }
            for (k, other) in behind.chunks_exact_mut(height).take(height - 1).enumerate() {
                let factor = below[k];
                if factor != 0.0 {
                    add_times(other, &below[k..], -factor);
                }
            }
        }
        Some(())
    }

    /// Replaces the right-hand side b in `x` by the solution of `L Lᵀ x = b` with the Cholesky factor L.
    pub(crate) fn solve(&self, x: &mut [f64]) {
        for (k, column) in self.entries.chunks_exact(self.height).enumerate() {
            x[k] /= column[0];
            let known = x[k];
            add_times(&mut x[k + 1..], &column[1..], -known);
        }
        for (k, column) in self.entries.chunks_exact(self.height).enumerate().rev() {
            let known: f64 = dot(&x[k + 1..], &column[1..]);
            x[k] = (x[k] - known) / column[0];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::generic;

    #[test]
    fn solves() {
        let (count, half_bandwidth) = (30, 4);
        let (mut band, mut full) =
            (PositiveBand::zeros(count, half_bandwidth), vec![vec![0.0; count]; count]);
        for i in 0..count {
            for j in i.saturating_sub(half_bandwidth)..=i {
                let x = if i == j { 8.0 } else { generic(count * i + j) - 1.0 };
                band.add(i, j, x);
                (full[i][j], full[j][i]) = (x, x);
            }
        }
        let x: Vec<f64> = (0..count).map(|k| (k as f64).cos()).collect();
        let mut b: Vec<f64> = full.iter().map(|row| row.iter().zip(&x).map(|(a, x)| a * x).sum()).collect();
        band.factor().expect("is positive definite");
        band.solve(&mut b);
        let off = b.iter().zip(&x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-13, "{off:e}");
    }

    #[test]
    fn what_is_not_positive_definite_has_no_factors() {
        let mut band = PositiveBand::zeros(2, 1);
        for (i, j) in [(0, 0), (1, 0), (1, 1)] {
            band.add(i, j, 1.0);
        }
        assert!(band.factor().is_none());
    }
}
