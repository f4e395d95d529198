//! Dot products over slices, in an order that does not depend on zeros among the terms.

use super::size::WHOLE;
use crate::numerics::add_times;

#[inline]
pub(super) fn exactly<const N: usize>(list: &[f64]) -> Option<&[f64; N]> {
    list.try_into().ok()
}

/// The dot product over the common length, in four interleaved sums, so that no addition waits for the previous one.
#[inline]
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let end = a.len().min(b.len());
    let ((a, a_rest), (b, b_rest)) = (a[..end].as_chunks::<4>(), b[..end].as_chunks::<4>());
    let mut sums = [0.0; 4];
    for (a, b) in a.iter().zip(b) {
        for lane in 0..4 {
            sums[lane] += a[lane] * b[lane];
        }
    }
    let mut rest = 0.0;
    for (a, b) in a_rest.iter().zip(b_rest) {
        rest += a * b;
    }
    (sums[0] + sums[2]) + (sums[1] + sums[3]) + rest
}

/// The dot product of two arrays of six numbers; pairs of products are added independently.
#[inline(always)]
pub(super) fn dot_whole(a: &[f64; WHOLE], b: &[f64; WHOLE]) -> f64 {
    ((a[0] * b[0] + a[2] * b[2]) + (a[1] * b[1] + a[3] * b[3])) + (a[4] * b[4] + a[5] * b[5])
}

/// The four interleaved sums of the dot product [`dot`], to which terms are added one by one, each with its index.
pub(super) struct SumLanes {
    sums: [f64; 4],
    rest: f64,
    /// The greatest multiple of four that does not exceed the number of terms. Terms from this index on are added to the field `rest`.
    whole: usize,
}

impl SumLanes {
    pub(super) fn of(count: usize) -> Self {
        Self { sums: [0.0; 4], rest: 0.0, whole: count / 4 * 4 }
    }

    #[inline]
    pub(super) fn add(&mut self, k: usize, term: f64) {
        *(if k < self.whole { &mut self.sums[k % 4] } else { &mut self.rest }) += term;
    }

    #[inline]
    pub(super) fn sum(self) -> f64 {
        let Self { sums, rest, .. } = self;
        (sums[0] + sums[2]) + (sums[1] + sums[3]) + rest
    }
}

/// Adds the product of a matrix, given column by column, and the vector `times` to `to`.
#[inline]
pub(super) fn add_combined(columns: &[f64], times: &[f64], to: &mut [f64]) {
    let rows = to.len().max(1);
    for (column, times) in columns.chunks_exact(rows).zip(times) {
        // Many components of the vector `times` are zero, so this test saves time.
        if *times != 0.0 {
            add_times(to, column, *times);
        }
    }
}

/// Adds the product of a matrix of N columns of N numbers and the vector `times` to `to`, with loops of fixed length.
#[inline]
pub(super) fn add_fixed<const N: usize>(columns: &[f64], times: &[f64; N], to: &mut [f64; N]) {
    let (columns, _) = columns.as_chunks::<N>();
    for (column, times) in columns.iter().zip(times) {
        for k in 0..N {
            to[k] += column[k] * times;
        }
    }
}
