//! Iteration over the nonzero entries of [M, q]: the matrix M of a problem, with its vector q as one more column. Subnormal entries count as zero.

use crate::numerics::Reals;
use crate::prelude::*;

/// The nonzero entries of [M, q], column by column: a list of their rows, or the whole columns, whose entries are tested one by one.
pub(super) enum Pattern<'a> {
    Listed(&'a [u32]),
    InPlace { n: usize, m: &'a [f64], q: &'a [f64] },
}

/// The nonzero entries of one column: a list of their rows, or the whole column, whose entries are tested.
pub(super) enum Column<'a> {
    Listed(&'a [u32]),
    InPlace(&'a [f64]),
}

impl<'a> Pattern<'a> {
    /// The nonzero entries of [M, q]; M has n rows and is stored by columns. `nonzero` is the number of nonzero entries in each column.
    ///
    /// If less than a quarter of the entries are nonzero, their rows are written to `list`. If more entries are nonzero, testing every entry is
    /// faster than using a list.
    pub(super) fn of(n: usize, m: &'a [f64], q: &'a [f64], nonzero: &[f64], list: &'a mut Vec<u32>) -> Self {
        let total: f64 = nonzero.iter().sum();
        if 4.0 * total >= (n * n) as f64 {
            return Self::InPlace { n, m, q };
        }
        list.clear();
        list.reserve(n * n / 4 + n);
        for column in m.chunks_exact(n).chain(core::iter::once(q)) {
            list.extend((0_u32..).zip(column).filter(|(_, m)| is_nonzero(**m)).map(|(i, _)| i));
        }
        Self::Listed(list)
    }

    /// Calls `visit` for each column of [M, q] that has nonzero entries: with the column's index (counted from 0; n for q), the number of its nonzero
    /// entries, and the column.
    pub(super) fn for_each(&self, counts: &[f64], visit: &mut dyn FnMut(usize, f64, &Column)) {
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
                let columns = m.chunks_exact(*n).chain(core::iter::once(*q));
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
    /// The sum of the entries `rho` over the rows in which the column has a nonzero entry.
    pub(super) fn sum(&self, rho: &[f64]) -> f64 {
        match self {
            Self::Listed(list) => list.iter().map(|i| rho[*i as usize]).added(),
            Self::InPlace(column) => sum_where(column, rho),
        }
    }

    /// Adds `what` to `to[i]` for each row i in which the column has a nonzero entry.
    pub(super) fn add(&self, what: f64, to: &mut [f64]) {
        match self {
            Self::Listed(list) => list.iter().for_each(|i| to[*i as usize] += what),
            Self::InPlace(column) => add_where(column, what, to),
        }
    }
}

/// Whether an entry is neither zero nor subnormal.
pub(super) fn is_nonzero(m: f64) -> bool {
    m.abs() >= f64::MIN_POSITIVE
}

/// The sum of the entries `rho` over the rows in which `column` has a nonzero entry.
fn sum_where(column: &[f64], rho: &[f64]) -> f64 {
    let mut lanes = [0.0; 4];
    let mut columns = column.chunks_exact(4);
    let mut rhos = rho.chunks_exact(4);
    for (m, rho) in (&mut columns).zip(&mut rhos) {
        for lane in 0..4 {
            lanes[lane] += if is_nonzero(m[lane]) { rho[lane] } else { 0.0 };
        }
    }
    for (m, rho) in columns.remainder().iter().zip(rhos.remainder()) {
        lanes[0] += if is_nonzero(*m) { *rho } else { 0.0 };
    }
    (lanes[0] + lanes[1]) + (lanes[2] + lanes[3])
}

/// Adds `what` to `to[i]` for each row i in which `column` has a nonzero entry.
fn add_where(column: &[f64], what: f64, to: &mut [f64]) {
    for (to, m) in to.iter_mut().zip(column) {
        *to += if is_nonzero(*m) { what } else { 0.0 };
    }
}
