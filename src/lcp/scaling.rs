//! Balancing of the rows and columns of the matrix M of a problem 0 ≤ z ⟂ w = M z + q ≥ 0.
//!
//! Row i is multiplied by 2^ρ_i and column j by 2^γ_j. The exponents solve the least-squares problem min Σ (log₂|M_ij| + ρ_i + γ_j)² over the nonzero
//! entries (A. R. Curtis and J. K. Reid, *On the automatic scaling of matrices for Gaussian elimination*, 1972). The scaled matrix 2^ρ_i M_ij 2^γ_j
//! does not change when rows or columns of M are multiplied by positive numbers. The path of a solver that works on the scaled matrix is therefore
//! independent of units.
//!
//! Scaling by the largest entries has no such property: its result depends on the initial scaling. If M has zeros, q is included as one more column.
//! If q were left out, uncoupled blocks of M would each keep an undetermined factor.
//!
//! The data are multiplied only by powers of two, which causes no rounding and preserves ties. Each ρ_i is therefore rounded to an integer. The
//! factor that row i lacks as a result becomes entry i of the covering vector d, which need not consist of powers of two.
//!
//! Ties are also the reason for solving the least-squares problem to rounding. Equal rows must get equal entries of the covering vector d. If the
//! entries were only nearly equal, ties would turn into ill-conditioned near-ties.

use super::logarithms::Logarithms;
use super::memory::refill;
use super::pattern::Pattern;
use super::tolerances::BALANCED_EXPONENTS;
use crate::numerics::{IntoList, dot, matrix_of, vector_of};
use crate::prelude::*;
use nalgebra::{DMatrix, DVector};

/// Factors of rows and columns, all powers of two: the balanced M_ij is row_i M_ij column_j.
#[derive(Debug, Clone, Default)]
pub(super) struct Scaling {
    pub(super) row: Vec<f64>,
    pub(super) column: Vec<f64>,
    /// The quotient row_i / 2^ρ_i, from 1/√2 to √2: the effect of rounding the exponent ρ_i to an integer.
    pub(super) row_unit: Vec<f64>,
    rho: Vec<f64>,
    gamma: Vec<f64>,
    rows: Logarithms,
    columns: Logarithms,
    /// Row indices of the nonzero entries of [M, q], column after column, if there are fewer than n²/4 of them; if there are more, testing every
    /// entry is faster than a list. The list is a scratch buffer.
    pattern: Vec<u32>,
    residual: Vec<f64>,
    direction: Vec<f64>,
    image: Vec<f64>,
}

impl Scaling {
    /// Balances the n × n matrix m, stored by columns, and q.
    pub(super) fn balance(&mut self, n: usize, m: &[f64], q: &[f64]) {
        Logarithms::of(n, m, &mut self.rows, &mut self.columns);
        refill(&mut self.rho, n, 0.0);
        refill(&mut self.gamma, n, 0.0);
        if self.columns.count.iter().all(|count| *count == n as f64) {
            // If M has no zeros, the solution is γ_j = −mean_i log₂|M_ij|, then ρ_i = −mean_j (log₂|M_ij| + γ_j).
            for (gamma, sum) in self.gamma.iter_mut().zip(&self.columns.sum) {
                *gamma = -sum / n as f64;
            }
            let total: f64 = self.gamma.iter().sum();
            for (rho, sum) in self.rho.iter_mut().zip(&self.rows.sum) {
                *rho = -(sum + total) / n as f64;
            }
        } else {
            self.solve_for_pattern(n, m, q);
        }
        self.round();
    }

    /// Solves the least-squares problem of the balancing exponents ρ (rows) and γ (columns) over the nonzero entries of [M, q].
    fn solve_for_pattern(&mut self, n: usize, m: &[f64], q: &[f64]) {
        Logarithms::append(q, &mut self.rows, &mut self.columns);
        let mut list = core::mem::take(&mut self.pattern);
        let pattern = Pattern::of(n, m, q, &self.columns.count, &mut list);
        self.descend(&pattern);
        pattern.for_each(&self.columns.count, &mut |j, count, column| {
            if j < n {
                self.gamma[j] = -(self.columns.sum[j] + column.sum(&self.rho)) / count;
            }
        });
        self.pattern = list;
    }

    /// Computes the row exponents ρ by conjugate gradients from ρ = 0. The column exponents γ are eliminated: γ_j = −mean_i (log₂|M_ij| + ρ_i).
    fn descend(&mut self, pattern: &Pattern) {
        let n = self.rho.len();
        // The conjugate gradients start with the residual at ρ = 0 of the equations for the row exponents ρ.
        self.residual.clear();
        self.rows.sum.iter().map(|sum| -sum).append_to(&mut self.residual);
        pattern.for_each(&self.columns.count, &mut |j, count, column| {
            column.add(self.columns.sum[j] / count, &mut self.residual);
        });
        refill(&mut self.direction, n, 0.0);
        refill(&mut self.image, n, 0.0);
        let mut before = 0.0;
        // Problems of contacts need about ten steps of conjugate gradients. Long chains of contacts need more, but the later steps change
        // little.
        for _ in 0..24 {
            // The preconditioner divides the residual of each row by the number of nonzero entries of the row.
            let mut size = 0.0;
            let mut worst = 0.0_f64;
            for (r, count) in self.residual.iter().zip(&self.rows.count) {
                if *count > 0.0 {
                    size += r * r / count;
                    worst = worst.max((r / count).abs());
                }
            }
            if worst < BALANCED_EXPONENTS || !size.is_finite() {
                break;
            }
            let ratio = if before > 0.0 { size / before } else { 0.0 };
            before = size;
            for ((d, r), count) in self.direction.iter_mut().zip(&self.residual).zip(&self.rows.count) {
                *d = if *count > 0.0 { r / count } else { 0.0 } + ratio * *d;
            }
            for ((image, d), count) in self.image.iter_mut().zip(&self.direction).zip(&self.rows.count) {
                *image = d * count;
            }
            pattern.for_each(&self.columns.count, &mut |_, count, column| {
                column.add(-column.sum(&self.direction) / count, &mut self.image);
            });
            let curvature: f64 = dot(&self.direction, &self.image);
            if curvature.is_nan() || curvature <= 0.0 {
                break;
            }
            let step = size / curvature;
            for i in 0..n {
                self.rho[i] += step * self.direction[i];
                self.residual[i] -= step * self.image[i];
            }
        }
    }

    /// The quotient 2^γ_j / column_j, from 1/√2 to √2: the effect on the balanced z_j of rounding the exponent γ_j to an integer.
    pub(super) fn column_unit(&self, j: usize) -> f64 {
        (self.gamma[j] - self.gamma[j].round()).exp2()
    }

    /// M and q with balanced rows and columns.
    pub(super) fn balanced(&self, m: &DMatrix<f64>, q: &DVector<f64>) -> (DMatrix<f64>, DVector<f64>) {
        let (row, column) = (&self.row, &self.column);
        (
            matrix_of(row.len(), column.len(), &|i, j| m[(i, j)] * row[i] * column[j]),
            vector_of(row.len(), &|i| q[i] * row[i]),
        )
    }

    fn round(&mut self) {
        self.row.clear();
        self.column.clear();
        self.row_unit.clear();
        for rho in &self.rho {
            let rounded = rho.round();
            self.row.push(power_of_two(rounded));
            self.row_unit.push((rounded - rho).exp2());
        }
        self.gamma.iter().map(|gamma| power_of_two(gamma.round())).append_to(&mut self.column);
    }
}

/// 2^k for an integer k, clamped to the range of normal numbers.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn power_of_two(k: f64) -> f64 {
    f64::from_bits(((k.clamp(-1022.0, 1023.0) + 1023.0) as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::Scaling;

    #[test]
    #[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap)] // small indices
    fn the_balanced_matrix_does_not_depend_on_the_units_of_rows_and_columns() {
        let n = 7;
        let entry = |i: usize, j: usize| {
            if (3 * i + 5 * j) % 4 == 1 { 0.0 } else { ((i * 17 + j * 31) % 23) as f64 - 11.5 }
        };
        let factor = |i: usize| 10.0_f64.powi((i as i32 * 7) % 25 - 12);
        let plain: Vec<f64> = (0..n * n).map(|k| entry(k % n, k / n)).collect();
        let rescaled: Vec<f64> =
            (0..n * n).map(|k| entry(k % n, k / n) * factor(k % n) / factor(k / n + 3)).collect();
        let (mut a, mut b) = (Scaling::default(), Scaling::default());
        let q: Vec<f64> = (0..n).map(|i| i as f64 - 2.0).collect();
        let rescaled_q: Vec<f64> = (0..n).map(|i| q[i] * factor(i) * 1e-7).collect();
        a.balance(n, &plain, &q);
        b.balance(n, &rescaled, &rescaled_q);
        for j in 0..n {
            for i in 0..n {
                let first = plain[j * n + i] * (a.rho[i] + a.gamma[j]).exp2();
                let second = rescaled[j * n + i] * (b.rho[i] + b.gamma[j]).exp2();
                assert!(
                    (first - second).abs() <= 1e-12 * first.abs(),
                    "({i}, {j}): {first} against {second}"
                );
            }
        }
    }

    #[test]
    fn a_full_matrix_of_rank_one_is_balanced_to_ones() {
        let n = 600;
        let m: Vec<f64> = (0..n * n).map(|k| (1.0 + (k % n) as f64) * 1.7 / (1.0 + (k / n) as f64)).collect();
        let mut scaling = Scaling::default();
        scaling.balance(n, &m, &[]);
        for k in (0..n * n).step_by(97) {
            let balanced = m[k] * (scaling.rho[k % n] + scaling.gamma[k / n]).exp2();
            assert!((balanced - 1.0).abs() < 1e-9, "{balanced}");
        }
    }
}
