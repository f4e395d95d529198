//! A square band matrix and its LU factors with partial pivoting.
//!
//! With entries up to b positions from the diagonal, row exchanges fill up to 2b positions to the right. LU factors of n rows cost 2 n b²
//! multiplications in place of n³/3. The solution for one right-hand side costs 3 n b in place of n².

use super::add_times::{add_times, scale};
use super::tolerances::BAND_PIVOT;
use crate::numerics::{amax, dot, mapped};
use crate::prelude::*;

/// A square matrix whose nonzero entries are at most `half_bandwidth` positions from the diagonal.
#[derive(Debug, Clone)]
pub(crate) struct Band {
    half_bandwidth: usize,
    /// The columns, each from `2 half_bandwidth` rows above the diagonal to `half_bandwidth` rows below it. The upper part has room for the fill-in
    /// of row exchanges.
    entries: Vec<f64>,
    count: usize,
}

impl Band {
    pub(crate) fn zeros(count: usize, half_bandwidth: usize) -> Self {
        Self { half_bandwidth, entries: vec![0.0; count * (3 * half_bandwidth + 1)], count }
    }

    /// Adds x to the entry in row i and column j.
    #[inline]
    pub(crate) fn add(&mut self, i: usize, j: usize, x: f64) {
        self.entries[j * (3 * self.half_bandwidth + 1) + 2 * self.half_bandwidth + i - j] += x;
    }

    /// The entry in row i and column j; zero outside the band.
    pub(crate) fn entry(&self, i: usize, j: usize) -> f64 {
        let is_near = i.abs_diff(j) <= self.half_bandwidth;
        if is_near {
            self.entries[j * (3 * self.half_bandwidth + 1) + 2 * self.half_bandwidth + i - j]
        } else {
            0.0
        }
    }

    pub(crate) fn entries_mut(&mut self) -> &mut [f64] {
        &mut self.entries
    }

    pub(crate) fn amax(&self) -> f64 {
        amax(&self.entries)
    }

    /// Subtracts the product of the matrix and x from a vector.
    pub(crate) fn subtract_product(&self, x: &[f64], from: &mut [f64]) {
        let height = 3 * self.half_bandwidth + 1;
        for (j, (column, x)) in self.entries.chunks_exact(height).zip(x).enumerate() {
            let first = j.saturating_sub(self.half_bandwidth);
            let column = &column[2 * self.half_bandwidth + first - j..];
            add_times(&mut from[first..self.count.min(j + self.half_bandwidth + 1)], column, -x);
        }
    }

    /// The LU factors. A column without a pivot is replaced by a unit column, so that the factored matrix is regular, see
    /// [`BandFactors::is_singular`]. `None` if a pivot is not finite.
    pub(crate) fn factors(mut self) -> Option<BandFactors> {
        let Self { half_bandwidth, count, .. } = self;
        let height = 3 * half_bandwidth + 1;
        let entries = &mut self.entries[..];
        let least = BAND_PIVOT * amax(entries);
        let (mut pivots, mut without_pivot) = (Vec::with_capacity(count), Vec::new());
        // The rightmost column that any row reaches after the row exchanges up to now.
        let mut last = 0;
        for k in 0..count {
            let below = half_bandwidth.min(count - 1 - k);
            let (before, behind) = entries.split_at_mut((k + 1) * height);
            let column = &mut before[k * height + 2 * half_bandwidth..][..=below];
            let mut pivot = 0;
            for i in 1..=below {
                if column[i].abs() > column[pivot].abs() {
                    pivot = i;
                }
            }
            if !column[pivot].is_finite() {
                return None;
            }
            if column[pivot].abs() <= least {
                pivot = 0;
                column.fill(0.0);
                column[0] = 1.0;
                without_pivot.push(k);
            }
            pivots.push(pivot);
            last = last.max((k + pivot + half_bandwidth).min(count - 1));
            column.swap(0, pivot);
            let reciprocal = 1.0 / column[0];
            scale(&mut column[1..], reciprocal);
            let column = &column[1..];
            for (j, other) in (k + 1..=last).zip(behind.chunks_exact_mut(height)) {
                let other = &mut other[2 * half_bandwidth + k - j..][..=below];
                other.swap(0, pivot);
                let top = other[0];
                if top != 0.0 {
                    add_times(&mut other[1..], column, -top);
                }
            }
        }
        Some(BandFactors { band: self, pivots, without_pivot })
    }
}

#[derive(Debug, Clone)]
pub(crate) struct BandFactors {
    /// U on and above the diagonal, L below it.
    band: Band,
    /// For each row k, the distance to the row below that was exchanged with it as pivot row; 0 without an exchange.
    pivots: Vec<usize>,
    /// Indices of the columns without a pivot. If `A x = b` has a solution, [`Self::solve`] returns the solution with zeros in these components.
    without_pivot: Vec<usize>,
}

impl BandFactors {
    /// Whether some column of the factored matrix had no pivot.
    pub(crate) fn is_singular(&self) -> bool {
        !self.without_pivot.is_empty()
    }

    /// Vectors x with `A x = 0` for the factored matrix A, one per column without a pivot.
    pub(crate) fn null_vectors(&self) -> Vec<Vec<f64>> {
        self.each_without_pivot(Self::back_substitute)
    }

    /// Vectors z with `Aᵀz = 0` for the factored matrix A, one per column without a pivot.
    pub(crate) fn left_null_vectors(&self) -> Vec<Vec<f64>> {
        self.each_without_pivot(Self::solve_transposed)
    }

    fn each_without_pivot(&self, solve: fn(&Self, &mut [f64])) -> Vec<Vec<f64>> {
        let from = |k: &usize| {
            let mut x = vec![0.0; self.band.count];
            x[*k] = 1.0;
            solve(self, &mut x);
            x
        };
        mapped(&self.without_pivot, &from)
    }

    /// The stored column k of the factors, starting `above` rows above the diagonal.
    fn column(&self, k: usize, above: usize) -> &[f64] {
        let half_bandwidth = self.band.half_bandwidth;
        let height = 3 * half_bandwidth + 1;
        &self.band.entries[k * height..(k + 1) * height][2 * half_bandwidth - above..]
    }

    /// Replaces the right-hand side b in `x` by the solution of `A x = b` for the factored matrix A.
    pub(crate) fn solve(&self, x: &mut [f64]) {
        let (count, half_bandwidth) = (self.band.count, self.band.half_bandwidth);
        for (k, pivot) in self.pivots.iter().enumerate() {
            x.swap(k, k + pivot);
            let (known, below) = (x[k], half_bandwidth.min(count - 1 - k));
            // A zero in the right-hand side changes no later row. The right-hand side of a single contact's force has many zeros.
            if known != 0.0 {
                add_times(&mut x[k + 1..=k + below], &self.column(k, 0)[1..], -known);
            }
        }
        self.back_substitute(x);
    }

    /// Replaces the right-hand side b in `x` by the solution of `U x = b` with the upper triangular factor U.
    fn back_substitute(&self, x: &mut [f64]) {
        for k in (0..self.band.count).rev() {
            let above = (2 * self.band.half_bandwidth).min(k);
            let column = self.column(k, above);
            x[k] /= column[above];
            let known = x[k];
            add_times(&mut x[k - above..k], column, -known);
        }
    }

    /// Replaces the right-hand side b in `x` by the solution of `Aᵀx = b` for the factored matrix A.
    pub(crate) fn solve_transposed(&self, x: &mut [f64]) {
        let (count, half_bandwidth) = (self.band.count, self.band.half_bandwidth);
        for k in 0..count {
            let above = (2 * half_bandwidth).min(k);
            let column = self.column(k, above);
            let known: f64 = dot(&x[k - above..k], column);
            x[k] = (x[k] - known) / column[above];
        }
        for k in (0..count).rev() {
            let below = half_bandwidth.min(count - 1 - k);
            let factors = &self.column(k, 0)[1..];
            let known: f64 = dot(&x[k + 1..=k + below], factors);
            x[k] -= known;
            x.swap(k, k + self.pivots[k]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::generic;

    /// A band with a small diagonal, so that rows are exchanged.
    fn random_band(count: usize, half_bandwidth: usize) -> (Band, Vec<Vec<f64>>) {
        let (mut band, mut full) = (Band::zeros(count, half_bandwidth), vec![vec![0.0; count]; count]);
        for (i, row) in full.iter_mut().enumerate() {
            for j in i.saturating_sub(half_bandwidth)..count.min(i + half_bandwidth + 1) {
                row[j] = (generic(count * i + j) - 1.0) * if i == j { 0.1 } else { 1.0 };
                band.add(i, j, row[j]);
            }
        }
        (band, full)
    }

    #[test]
    fn solves_both_ways() {
        let (band, full) = random_band(40, 4);
        let factors = band.factors().expect("is regular");
        let x: Vec<f64> = (0..40).map(|k| f64::from(k).sin()).collect();
        let times = |entry: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
            (0..40).map(|i| (0..40).map(|j| entry(i, j) * x[j]).sum()).collect()
        };
        let (mut b, mut c) = (times(&|i, j| full[i][j]), times(&|i, j| full[j][i]));
        factors.solve(&mut b);
        factors.solve_transposed(&mut c);
        for found in [b, c] {
            let off = found.iter().zip(&x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-11, "{off:e}");
        }
    }

    #[test]
    fn what_is_singular_has_null_vectors() {
        let (mut band, mut full) = random_band(20, 3);
        // The band of row 10 covers the columns 7 to 13. Rows 8 and 9 lose their entries in other columns, and row 10 becomes their sum: the matrix
        // is singular.
        for j in 5..14 {
            let sum = full[8][j] + full[9][j];
            if (7..14).contains(&j) {
                band.add(10, j, sum - full[10][j]);
                full[10][j] = sum;
            } else {
                [8, 9].into_iter().filter(|i| full[*i][j] != 0.0).for_each(|i| band.add(i, j, -full[i][j]));
                (full[8][j], full[9][j]) = (0.0, 0.0);
            }
        }
        let factors = band.factors().expect("is finite");
        assert!(factors.is_singular());
        let ([x], [z]) = (&factors.null_vectors()[..], &factors.left_null_vectors()[..]) else {
            panic!("one each")
        };
        for k in 0..20 {
            let [row, column]: [f64; 2] =
                [(0..20).map(|j| full[k][j] * x[j]).sum(), (0..20).map(|i| full[i][k] * z[i]).sum()];
            assert!(row.abs().max(column.abs()) < 1e-12, "{row:e} {column:e}");
        }
        assert!((z[8] + z[10]).abs() < 1e-12 && (z[9] + z[10]).abs() < 1e-12, "{z:?}");
    }
}
