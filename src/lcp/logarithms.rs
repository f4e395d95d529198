//! Sums of the binary logarithms of the magnitudes of a matrix's entries, at the cost of a few integer additions per entry.

use super::memory::refill;
use super::pattern::is_nonzero;
use crate::prelude::*;

/// The number of mantissas, each below 2, that are multiplied before a logarithm of the product is taken.
///
/// If the number were above 1023, the product could overflow. If it were smaller, more logarithms would be needed.
const MULTIPLIED: usize = 512;

/// For each row, or for each column, Σ log₂|M_ij| over its entries that are neither zero nor subnormal, and the number of these entries. A subnormal
/// entry is not counted, but adds its mantissa's logarithm, less than 1, to the sum.
#[derive(Debug, Clone, Default)]
pub(super) struct Logarithms {
    pub(super) sum: Vec<f64>,
    pub(super) count: Vec<f64>,
    /// For each row or column, two numbers in one. The lower 32 bits hold the sum of the biased binary exponents of its entries, the upper 32 bits
    /// the number of entries.
    exponents: Vec<u64>,
    mantissas: Vec<f64>,
}

impl Logarithms {
    /// The sums over the rows and over the columns of the n × n matrix m, stored by columns. Logarithms are taken only of products of mantissas,
    /// since taking a logarithm of every entry is slow.
    pub(super) fn of(n: usize, m: &[f64], rows: &mut Self, columns: &mut Self) {
        rows.reset(n);
        columns.reset(n);
        for (j, column) in m.chunks_exact(n.max(1)).enumerate() {
            for start in (0..n).step_by(MULTIPLIED) {
                let end = n.min(start + MULTIPLIED);
                let (exponents, product) = accumulate(
                    &column[start..end],
                    &mut rows.exponents[start..end],
                    &mut rows.mantissas[start..end],
                );
                columns.exponents[j] += exponents;
                columns.mantissas[j] = product;
                columns.put_away(j);
            }
            if j % MULTIPLIED == MULTIPLIED - 1 {
                (0..n).for_each(|i| rows.put_away(i));
            }
        }
        rows.finish();
        columns.finish();
    }

    /// Adds the binary logarithms of the entries of q, as one more column beside M, to the sums of their rows. The sum over q becomes the last entry
    /// of `columns`.
    pub(super) fn append(q: &[f64], rows: &mut Self, columns: &mut Self) {
        let (mut sum, mut count) = (0.0, 0.0);
        for (i, q) in q.iter().enumerate().filter(|(_, q)| is_nonzero(**q)) {
            let logarithm = q.abs().log2();
            sum += logarithm;
            count += 1.0;
            rows.sum[i] += logarithm;
            rows.count[i] += 1.0;
        }
        columns.sum.push(sum);
        columns.count.push(count);
    }

    fn reset(&mut self, n: usize) {
        refill(&mut self.exponents, n, 0);
        refill(&mut self.mantissas, n, 1.0);
        refill(&mut self.sum, n, 0.0);
        refill(&mut self.count, n, 0.0);
    }

    /// Adds the logarithm of the product of mantissas of row i to the sum of this row, and sets the product to 1. Called before the product can
    /// overflow.
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

/// For the entries of one column: adds their binary exponents to the sums of their rows, and multiplies the mantissa products of their rows by
/// their mantissas. Returns the exponent sum and the mantissa product of the column.
fn accumulate(column: &[f64], exponents: &mut [u64], mantissas: &mut [f64]) -> (u64, f64) {
    let mut sum = [0_u64; 4];
    let mut product = [1.0_f64; 4];
    let parts = |m: f64| {
        let exponent = (m.to_bits() >> 52) & 0x7ff;
        // (exponent + 2047) >> 11 is 0 for exponent 0 and 1 for all others, so the upper 32 bits count the entries that are neither zero nor
        // subnormal.
        (
            exponent + (((exponent + 2047) >> 11) << 32),
            f64::from_bits(m.to_bits() & ((1 << 52) - 1) | (1023 << 52)),
        )
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
