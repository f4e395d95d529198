//! Balancing rows and columns.
//!
//! The factors solve the least-squares problem min Σ (log₂|M_ij| + ρ_i + γ_j)² over the entries that are not zero
//! (Curtis & Reid, *On the automatic scaling of matrices for Gaussian elimination*, 1972). Its scaled matrix
//! 2^ρ_i M_ij 2^γ_j does not change when rows or columns of M are multiplied by positive numbers, so neither does the path
//! of a solver that works on it. Scaling by the largest entries has no such property: it depends on the start. If M has
//! zeros, q takes part as one more column, since otherwise blocks of M that are not coupled would each keep a free factor.
//!
//! The data are multiplied by powers of two only, which adds no rounding error and leaves ties ties. The part of ρ_i
//! lost in rounding it to an integer is kept in the covering vector, where it costs nothing. For the same reason
//! the problem is solved to rounding: rows that are alike must get entries of d that are equal, not nearly equal, or ties
//! would turn into badly conditioned near-ties.

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
    /// The rows of the entries that take part, column after column.
    pattern: Vec<u32>,
    residual: Vec<f64>,
    direction: Vec<f64>,
    image: Vec<f64>,
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

/// Exponents are settled when their equations hold to this.
const SETTLED: f64 = 1e-13;
/// A bound on the conjugate-gradient steps for patterns with zeros: contact problems take about ten; on chains the ends
/// are felt more slowly, but then no longer matter.
const STEPS: usize = 24;
/// So many mantissas, each below 2, can be multiplied before the product must be put away.
const PRODUCT: usize = 512;

impl Scaling {
    /// Balances the n × n matrix m, stored by columns, and q.
    pub(crate) fn balance(&mut self, n: usize, m: &[f64], q: &[f64]) {
        self.sum_logarithms(n, m);
        for vector in [&mut self.rho, &mut self.gamma] {
            vector.clear();
            vector.resize(n, 0.0);
        }
        if self.columns.count.iter().all(|count| *count == n as f64) {
            // Full: γ_j = −mean_i, then ρ_i = −mean_j of what is left.
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

    /// The least-squares problem with γ eliminated, γ_j = −mean_i (log₂|M_ij| + ρ_i), by conjugate gradients for ρ.
    fn solve_for_pattern(&mut self, n: usize, m: &[f64], q: &[f64]) {
        let mut q_sum = 0.0;
        let mut q_count = 0.0;
        for (i, q) in q.iter().enumerate().filter(|(_, q)| counts(**q)) {
            let logarithm = q.abs().log2();
            q_sum += logarithm;
            q_count += 1.0;
            self.rows.sum[i] += logarithm;
            self.rows.count[i] += 1.0;
        }
        self.columns.sum.push(q_sum);
        self.columns.count.push(q_count);
        let total: f64 = self.columns.count.iter().sum();
        // Few entries are listed; many are faster to look at in place than to look up.
        let listed = 4.0 * total < (n * n) as f64;
        self.pattern.clear();
        if listed {
            for column in m.chunks_exact(n).chain(std::iter::once(q)) {
                self.pattern.extend((0_u32..).zip(column).filter(|(_, m)| counts(**m)).map(|(i, _)| i));
            }
        }
        let pattern = std::mem::take(&mut self.pattern);
        let source = if listed { Pattern::Listed(&pattern) } else { Pattern::InPlace { n, m, q } };

        // The residual at ρ = 0.
        self.residual.clear();
        self.residual.extend(self.rows.sum.iter().map(|sum| -sum));
        source.for_each(&self.columns.count, |j, count, column| {
            column.add(self.columns.sum[j] / count, &mut self.residual);
        });
        self.direction.clear();
        self.direction.resize(n, 0.0);
        self.image.clear();
        self.image.resize(n, 0.0);
        let mut before = 0.0;
        for _ in 0..STEPS {
            // Preconditioned by the counts.
            let mut size = 0.0;
            let mut worst = 0.0_f64;
            for (r, count) in self.residual.iter().zip(&self.rows.count) {
                if *count > 0.0 {
                    size += r * r / count;
                    worst = worst.max((r / count).abs());
                }
            }
            if worst < SETTLED || !size.is_finite() {
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
            source.for_each(&self.columns.count, |_, count, column| {
                column.add(-column.sum(&self.direction) / count, &mut self.image);
            });
            let curvature: f64 = self.direction.iter().zip(&self.image).map(|(d, a)| d * a).sum();
            if curvature.is_nan() || curvature <= 0.0 {
                break;
            }
            let step = size / curvature;
            for i in 0..n {
                self.rho[i] += step * self.direction[i];
                self.residual[i] -= step * self.image[i];
            }
        }
        source.for_each(&self.columns.count, |j, count, column| {
            if j < n {
                self.gamma[j] = -(self.columns.sum[j] + column.sum(&self.rho)) / count;
            }
        });
        self.pattern = pattern;
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

    /// What one unit of the exactly balanced z_j measures in the rounded one: 2^γ_j / column_j.
    pub(crate) fn column_unit(&self, j: usize) -> f64 {
        (self.gamma[j] - self.gamma[j].round()).exp2()
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
        self.column.extend(self.gamma.iter().map(|gamma| power_of_two(gamma.round())));
    }
}

/// 2^k for an integer k; kept within the normal numbers.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn power_of_two(k: f64) -> f64 {
    f64::from_bits(((k.clamp(-1022.0, 1023.0) + 1023.0) as u64) << 52)
}

/// Where the entries that take part are found.
enum Pattern<'a> {
    Listed(&'a [u32]),
    InPlace { n: usize, m: &'a [f64], q: &'a [f64] },
}

/// The entries of one column that take part.
enum Column<'a> {
    Listed(&'a [u32]),
    InPlace(&'a [f64]),
}

impl Pattern<'_> {
    /// Calls `visit` with the index, the count and the entries of each column of [M, q] that has any.
    fn for_each(&self, counts: &[f64], mut visit: impl FnMut(usize, f64, &Column)) {
        match self {
            Self::Listed(list) => {
                let mut rest = *list;
                for (j, count) in counts.iter().enumerate().filter(|(_, count)| **count > 0.0) {
                    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a count of entries
                    let (here, next) = rest.split_at((*count as usize).min(rest.len()));
                    rest = next;
                    visit(j, *count, &Column::Listed(here));
                }
            }
            Self::InPlace { n, m, q } => {
                let columns = m.chunks_exact(*n).chain(std::iter::once(*q));
                for (j, (column, count)) in
                    columns.zip(counts).enumerate().filter(|(_, (_, count))| **count > 0.0)
                {
                    visit(j, *count, &Column::InPlace(column));
                }
            }
        }
    }
}

impl Column<'_> {
    /// Σ ρ_i over the entries.
    fn sum(&self, rho: &[f64]) -> f64 {
        match self {
            Self::Listed(list) => list.iter().map(|i| rho[*i as usize]).sum(),
            Self::InPlace(column) => sum_where(column, rho),
        }
    }

    /// Adds a number to the rows of the entries.
    fn add(&self, what: f64, to: &mut [f64]) {
        match self {
            Self::Listed(list) => list.iter().for_each(|i| to[*i as usize] += what),
            Self::InPlace(column) => add_where(column, what, to),
        }
    }
}

const MANTISSA: u64 = (1 << 52) - 1;
const ONE: u64 = 1023 << 52;

/// Whether an entry takes part: not zero, and not so small that it has no full mantissa.
fn counts(m: f64) -> bool {
    m.abs() >= f64::MIN_POSITIVE
}

/// Σ ρ_i over the entries of a column that take part.
fn sum_where(column: &[f64], rho: &[f64]) -> f64 {
    let mut lanes = [0.0; 4];
    let mut columns = column.chunks_exact(4);
    let mut rhos = rho.chunks_exact(4);
    for (m, rho) in (&mut columns).zip(&mut rhos) {
        for lane in 0..4 {
            lanes[lane] += if counts(m[lane]) { rho[lane] } else { 0.0 };
        }
    }
    for (m, rho) in columns.remainder().iter().zip(rhos.remainder()) {
        lanes[0] += if counts(*m) { *rho } else { 0.0 };
    }
    (lanes[0] + lanes[1]) + (lanes[2] + lanes[3])
}

/// Adds a number to the rows whose entry takes part.
fn add_where(column: &[f64], what: f64, to: &mut [f64]) {
    for (to, m) in to.iter_mut().zip(column) {
        *to += if counts(*m) { what } else { 0.0 };
    }
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
