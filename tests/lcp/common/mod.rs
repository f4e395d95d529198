//! Oracles in exact rational arithmetic, independent of the library.
// Every test file uses its own part, and all casts are of small integers.
#![allow(
    dead_code,
    clippy::missing_panics_doc,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss
)]
#![allow(clippy::doc_markdown)]

pub(crate) mod published;

pub(crate) use support::exact_lcp::Exact;
pub(crate) use support::samples::{assert_met, samples, seeded};
pub(crate) use support::splitmix::Random;

use num_bigint::BigInt;

/// An integer problem.
#[derive(Debug, Clone)]
pub(crate) struct Integers {
    pub(crate) n: usize,
    /// M by rows.
    pub(crate) m: Vec<i64>,
    pub(crate) q: Vec<i64>,
}

impl Integers {
    pub(crate) fn matrix(&self) -> nalgebra::DMatrix<f64> {
        nalgebra::DMatrix::from_fn(self.n, self.n, |i, j| self.m[i * self.n + j] as f64)
    }
    pub(crate) fn vector(&self) -> nalgebra::DVector<f64> {
        nalgebra::DVector::from_fn(self.n, |i, _| self.q[i] as f64)
    }
    pub(crate) fn problem(&self) -> grasp_lcp::lcp::Lcp {
        grasp_lcp::lcp::Lcp::new(self.matrix(), self.vector()).expect("integers are finite")
    }

    pub(crate) fn exact(&self) -> Exact {
        let row = |row: &[i64]| row.iter().copied().map(BigInt::from).collect();
        Exact { m: self.m.chunks(self.n.max(1)).map(row).collect(), q: row(&self.q) }
    }
}
