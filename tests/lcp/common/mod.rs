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

mod exact;
pub(crate) mod published;

pub(crate) use exact::Exact;

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

/// A small deterministic generator, so that failures can be repeated.
pub(crate) struct Random(pub(crate) u64);
impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }
    /// An integer between low and high, both included.
    pub(crate) fn integer(&mut self, low: i64, high: i64) -> i64 {
        low + (self.next() % (high - low + 1) as u64) as i64
    }
    pub(crate) fn uniform(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }
    pub(crate) fn normal(&mut self) -> f64 {
        (-2.0 * (1.0 - self.uniform()).ln()).sqrt() * (std::f64::consts::TAU * self.uniform()).cos()
    }
}
