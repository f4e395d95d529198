//! Balancing rows and columns.
//!
//! The factors solve the least-squares problem min Σ (log₂|M_ij| + ρ_i + γ_j)² over the entries that are not zero
//! (Curtis & Reid, *On the automatic scaling of matrices for Gaussian elimination*, 1972). Its scaled matrix
//! 2^ρ_i M_ij 2^γ_j does not change when rows or columns of M are multiplied by positive numbers, so neither does the path
//! of a solver that works on it. Scaling by the largest entries has no such property: it depends on the start.
//!
//! The data are multiplied by powers of two only, which adds no rounding error and leaves ties ties. The part of ρ_i
//! lost in rounding it to an integer is kept in the covering vector, where it costs nothing.

/// Row and column exponents: scaled M_ij = 2^(row_i + column_j) M_ij.
#[derive(Debug, Clone, Default)]
pub(crate) struct Scaling {
    pub(crate) row: Vec<i32>,
    pub(crate) column: Vec<i32>,
    /// What one unit of the exactly balanced row i measures in the rounded one: 2^(row_i − ρ_i).
    pub(crate) row_unit: Vec<f64>,
    rho: Vec<f64>,
    gamma: Vec<f64>,
    row_count: Vec<f64>,
}

/// Changes of the exponents below this no longer matter: the path feels them as a change of d by 2^(1/1000).
const SETTLED: f64 = 1e-3;
/// Full patterns settle in one sweep, the sparse ones of contact problems in about ten.
const SWEEPS: usize = 40;

impl Scaling {
    /// Balances the n × n matrix m, stored by columns.
    pub(crate) fn balance(&mut self, n: usize, m: &[f64]) {
        for vector in [&mut self.rho, &mut self.gamma, &mut self.row_count] {
            vector.clear();
            vector.resize(n, 0.0);
        }
        for sweep in 0..SWEEPS {
            let change = self.sweep(n, m);
            if sweep > 0 && change < SETTLED {
                break;
            }
        }
        self.round();
    }

    /// One pass: each γ_j, then each ρ_i, as minus the mean over its entries. Returns the largest change.
    fn sweep(&mut self, n: usize, m: &[f64]) -> f64 {
        let mut change = 0.0_f64;
        let mut row_sum = vec![0.0; n];
        self.row_count.fill(0.0);
        for (j, column) in m.chunks_exact(n.max(1)).enumerate() {
            let mut sum = 0.0;
            let mut count = 0.0;
            for (i, entry) in column.iter().enumerate() {
                if *entry != 0.0 {
                    sum += entry.abs().log2() + self.rho[i];
                    count += 1.0;
                }
            }
            if count > 0.0 {
                change = change.max((sum / count + self.gamma[j]).abs());
                self.gamma[j] = -sum / count;
            }
            for (i, entry) in column.iter().enumerate() {
                if *entry != 0.0 {
                    row_sum[i] += entry.abs().log2() + self.gamma[j];
                    self.row_count[i] += 1.0;
                }
            }
        }
        for i in 0..n {
            if self.row_count[i] > 0.0 {
                let rho = -row_sum[i] / self.row_count[i];
                change = change.max((rho - self.rho[i]).abs());
                self.rho[i] = rho;
            }
        }
        change
    }

    fn round(&mut self) {
        self.row.clear();
        self.column.clear();
        self.row_unit.clear();
        for rho in &self.rho {
            let rounded = rho.round();
            self.row.push(exponent(rounded));
            self.row_unit.push((rounded - rho).exp2());
        }
        self.column.extend(self.gamma.iter().map(|gamma| exponent(gamma.round())));
    }
}

/// A rounded exponent as an integer; logarithms of finite numbers stay far inside the range.
#[allow(clippy::cast_possible_truncation)]
fn exponent(rounded: f64) -> i32 {
    rounded.clamp(-4000.0, 4000.0) as i32
}

/// 2^k; infinite or zero beyond the range of the exponent, like any product that leaves it.
pub(crate) fn power_of_two(k: i32) -> f64 {
    f64::from(k).exp2()
}
