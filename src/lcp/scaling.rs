//! Balancing rows and columns.
//!
//! The factors solve the least-squares problem min Σ (log₂|M_ij| + ρ_i + γ_j)² over the entries that are not zero
//! (Curtis & Reid, *On the automatic scaling of matrices for Gaussian elimination*, 1972). Its scaled matrix
//! 2^ρ_i M_ij 2^γ_j does not change when rows or columns of M are multiplied by positive numbers, so neither does the path
//! of a solver that works on it. Scaling by the largest entries has no such property: it depends on the start.
//!
//! The data are multiplied by powers of two only, which adds no rounding error and leaves ties ties. The part of ρ_i
//! lost in rounding it to an integer is kept in the covering vector, where it costs nothing.

/// Row and column factors: scaled M_ij = row_i M_ij column_j, all factors powers of two.
#[derive(Debug, Clone, Default)]
pub(crate) struct Scaling {
    pub(crate) row: Vec<f64>,
    pub(crate) column: Vec<f64>,
    /// What one unit of the exactly balanced row i measures in the rounded one: row_i / 2^ρ_i.
    pub(crate) row_unit: Vec<f64>,
    rho: Vec<f64>,
    gamma: Vec<f64>,
    rows: Logarithms,
    columns: Logarithms,
    /// The rows of the entries that are not zero, column after column; only filled if some are zero.
    pattern: Vec<u32>,
    sum: Vec<f64>,
}

/// Σ log₂|M_ij| and the number of terms, for each row or column.
#[derive(Debug, Clone, Default)]
struct Logarithms {
    sum: Vec<f64>,
    count: Vec<f64>,
    /// Exponents in the lower half, number of entries in the upper.
    exponents: Vec<u64>,
    mantissas: Vec<f64>,
}

/// Changes of the exponents below this no longer matter: the path feels them as a change of d by 2^(1/1000).
const SETTLED: f64 = 1e-3;
/// Full patterns settle in one sweep, the sparse ones of contact problems in about ten.
const SWEEPS: usize = 40;
/// So many mantissas, each below 2, can be multiplied before the product must be put away.
const PRODUCT: usize = 512;

impl Scaling {
    /// Balances the n × n matrix m, stored by columns.
    pub(crate) fn balance(&mut self, n: usize, m: &[f64]) {
        self.sum_logarithms(n, m);
        for vector in [&mut self.rho, &mut self.gamma, &mut self.sum] {
            vector.clear();
            vector.resize(n, 0.0);
        }
        let full = self.columns.count.iter().all(|count| *count == n as f64);
        if full {
            // One sweep is exact: γ_j = −mean_i, then ρ_i = −mean_j of what is left.
            for (gamma, sum) in self.gamma.iter_mut().zip(&self.columns.sum) {
                *gamma = -sum / n as f64;
            }
            let total: f64 = self.gamma.iter().sum();
            for (rho, sum) in self.rho.iter_mut().zip(&self.rows.sum) {
                *rho = -(sum + total) / n as f64;
            }
        } else {
            self.pattern.clear();
            for column in m.chunks_exact(n.max(1)) {
                self.pattern.extend((0_u32..).zip(column).filter(|(_, m)| counts(**m)).map(|(i, _)| i));
            }
            for _ in 0..SWEEPS {
                if self.sweep() < SETTLED {
                    break;
                }
            }
        }
        self.round();
    }

    /// The sums over rows and columns. A logarithm is taken of a product of mantissas only, not of each entry.
    fn sum_logarithms(&mut self, n: usize, m: &[f64]) {
        self.rows.reset(n);
        self.columns.reset(n);
        for (j, column) in m.chunks_exact(n.max(1)).enumerate() {
            for start in (0..n).step_by(PRODUCT) {
                let end = n.min(start + PRODUCT);
                let (exponents, product) = accumulate(
                    &column[start..end],
                    &mut self.rows.exponents[start..end],
                    &mut self.rows.mantissas[start..end],
                );
                self.columns.exponents[j] += exponents;
                self.columns.mantissas[j] = product;
                self.columns.put_away(j);
            }
            if j % PRODUCT == PRODUCT - 1 {
                (0..n).for_each(|i| self.rows.put_away(i));
            }
        }
        self.rows.finish();
        self.columns.finish();
    }

    /// One pass over a pattern with zeros: each γ_j, then each ρ_i, as minus the mean over its entries. Returns the
    /// largest change.
    fn sweep(&mut self) -> f64 {
        let mut change = 0.0_f64;
        let mut rest = self.pattern.as_slice();
        self.sum.fill(0.0);
        for ((gamma, count), logarithms) in
            self.gamma.iter_mut().zip(&self.columns.count).zip(&self.columns.sum)
        {
            if *count == 0.0 {
                continue;
            }
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a count of at most n entries
            let (here, next) = rest.split_at((*count as usize).min(rest.len()));
            rest = next;
            let rho: f64 = here.iter().map(|i| self.rho[*i as usize]).sum();
            let new = -(logarithms + rho) / count;
            change = change.max((new - *gamma).abs());
            *gamma = new;
            for i in here {
                self.sum[*i as usize] += new;
            }
        }
        for (i, rho) in self.rho.iter_mut().enumerate() {
            if self.rows.count[i] > 0.0 {
                let new = -(self.rows.sum[i] + self.sum[i]) / self.rows.count[i];
                change = change.max((new - *rho).abs());
                *rho = new;
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
            self.row.push(rounded.exp2());
            self.row_unit.push((rounded - rho).exp2());
        }
        self.column.extend(self.gamma.iter().map(|gamma| gamma.round().exp2()));
    }
}

const MANTISSA: u64 = (1 << 52) - 1;
const ONE: u64 = 1023 << 52;

/// Whether an entry takes part: not zero, and not so small that it has no full mantissa.
fn counts(m: f64) -> bool {
    (m.to_bits() >> 52) & 0x7ff != 0
}

/// Adds the exponents and multiplies the mantissas of a column to those of its rows; returns those of the column.
fn accumulate(column: &[f64], exponents: &mut [u64], mantissas: &mut [f64]) -> (u64, f64) {
    let mut sum = [0_u64; 4];
    let mut product = [1.0_f64; 4];
    let parts = |m: f64| {
        let exponent = (m.to_bits() >> 52) & 0x7ff;
        // (exponent + 2047) >> 11 is 0 for exponent 0 and 1 for all others.
        (exponent + (((exponent + 2047) >> 11) << 32), f64::from_bits(m.to_bits() & MANTISSA | ONE))
    };
    let mut columns = column.chunks_exact(4);
    let mut rows = exponents.chunks_exact_mut(4);
    let mut products = mantissas.chunks_exact_mut(4);
    for ((m, row), mantissa) in (&mut columns).zip(&mut rows).zip(&mut products) {
        for lane in 0..4 {
            let (e, f) = parts(m[lane]);
            sum[lane] += e;
            product[lane] *= f;
            row[lane] += e;
            mantissa[lane] *= f;
        }
    }
    let tail = columns.remainder().iter().zip(rows.into_remainder()).zip(products.into_remainder());
    for ((m, row), mantissa) in tail {
        let (e, f) = parts(*m);
        sum[0] += e;
        product[0] *= f;
        *row += e;
        *mantissa *= f;
    }
    (sum.iter().sum(), (product[0] * product[1]) * (product[2] * product[3]))
}

impl Logarithms {
    fn reset(&mut self, n: usize) {
        self.exponents.clear();
        self.exponents.resize(n, 0);
        self.mantissas.clear();
        self.mantissas.resize(n, 1.0);
        for vector in [&mut self.sum, &mut self.count] {
            vector.clear();
            vector.resize(n, 0.0);
        }
    }

    /// Turns a product of mantissas into its logarithm before it overflows.
    fn put_away(&mut self, i: usize) {
        self.sum[i] += self.mantissas[i].log2();
        self.mantissas[i] = 1.0;
    }

    fn finish(&mut self) {
        for i in 0..self.sum.len() {
            self.put_away(i);
            let count = (self.exponents[i] >> 32) as f64;
            self.count[i] = count;
            self.sum[i] += (self.exponents[i] & 0xffff_ffff) as f64 - 1023.0 * count;
        }
    }
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
        a.balance(n, &plain);
        b.balance(n, &rescaled);
        for j in 0..n {
            for i in 0..n {
                let first = plain[j * n + i] * (a.rho[i] + a.gamma[j]).exp2();
                let second = rescaled[j * n + i] * (b.rho[i] + b.gamma[j]).exp2();
                assert!((first - second).abs() <= 0.01 * first.abs(), "({i}, {j}): {first} against {second}");
            }
        }
    }

    #[test]
    fn a_full_matrix_of_rank_one_is_balanced_to_ones() {
        let n = 600;
        let m: Vec<f64> = (0..n * n).map(|k| (1.0 + (k % n) as f64) * 1.7 / (1.0 + (k / n) as f64)).collect();
        let mut scaling = Scaling::default();
        scaling.balance(n, &m);
        for k in (0..n * n).step_by(97) {
            let balanced = m[k] * (scaling.rho[k % n] + scaling.gamma[k / n]).exp2();
            assert!((balanced - 1.0).abs() < 1e-9, "{balanced}");
        }
    }
}
