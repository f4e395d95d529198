//! Oracles in exact rational arithmetic, independent of the library.
// Every test file uses its own part, and all casts are of small integers.
#![allow(dead_code, clippy::cast_possible_truncation, clippy::cast_possible_wrap, clippy::cast_sign_loss)]
#![allow(clippy::doc_markdown)]

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// An integer problem.
#[derive(Debug, Clone)]
pub(crate) struct Integers {
    pub(crate) n: usize,
    /// M by rows.
    pub(crate) m: Vec<i64>,
    pub(crate) q: Vec<i64>,
}

pub(crate) fn rational(x: i64) -> BigRational {
    BigRational::from_integer(BigInt::from(x))
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

    /// Whether the problem has a solution at all: for every α, is { z_α ≥ 0, (Mz + q)_α = 0, (Mz + q)_ᾱ ≥ 0 } empty?
    /// Decided by Fourier–Motzkin elimination, so singular blocks need no special care.
    pub(crate) fn is_solvable(&self) -> bool {
        (0..1_u32 << self.n).any(|alpha| self.piece_is_solvable(alpha))
    }

    fn piece_is_solvable(&self, alpha: u32) -> bool {
        let support: Vec<usize> = (0..self.n).filter(|i| alpha >> i & 1 == 1).collect();
        let k = support.len();
        // Rows (a, b) stand for a·z + b ≥ 0.
        let mut rows: Vec<Vec<BigRational>> = Vec::new();
        for i in 0..self.n {
            let mut row: Vec<BigRational> =
                support.iter().map(|j| rational(self.m[i * self.n + j])).collect();
            row.push(rational(self.q[i]));
            if alpha >> i & 1 == 1 {
                rows.push(row.iter().map(|x| -x.clone()).collect());
            }
            rows.push(row);
        }
        for j in 0..k {
            let mut row = vec![BigRational::zero(); k + 1];
            row[j] = rational(1);
            rows.push(row);
        }
        for v in 0..k {
            let (mut next, mut lower, mut upper) = (Vec::new(), Vec::new(), Vec::new());
            for row in rows {
                if row[v].is_zero() {
                    next.push(row);
                } else {
                    let size = row[v].abs();
                    let row: Vec<BigRational> = row.iter().map(|x| x / &size).collect();
                    if row[v].is_positive() { lower.push(row) } else { upper.push(row) }
                }
            }
            for low in &lower {
                for high in &upper {
                    next.push(low.iter().zip(high).map(|(a, b)| a + b).collect());
                }
            }
            next.sort();
            next.dedup();
            rows = next;
        }
        rows.iter().all(|row| !row[k].is_negative())
    }

    /// Whether the basis α stands for a solution: the exact point of a regular M_αα, or `None` if it is singular.
    pub(crate) fn exact_point(&self, alpha: &[usize]) -> Option<Vec<BigRational>> {
        let k = alpha.len();
        let mut a: Vec<Vec<BigRational>> = alpha
            .iter()
            .map(|i| {
                let mut row: Vec<BigRational> =
                    alpha.iter().map(|j| rational(self.m[i * self.n + j])).collect();
                row.push(rational(-self.q[*i]));
                row
            })
            .collect();
        for c in 0..k {
            let pivot = (c..k).find(|r| !a[*r][c].is_zero())?;
            a.swap(c, pivot);
            let head = a[c].clone();
            for r in 0..k {
                if r != c && !a[r][c].is_zero() {
                    let f = &a[r][c] / &head[c];
                    for (x, h) in a[r].iter_mut().zip(&head) {
                        *x -= &f * h;
                    }
                }
            }
        }
        let mut z = vec![BigRational::zero(); self.n];
        for (c, i) in alpha.iter().enumerate() {
            z[*i] = &a[c][k] / &a[c][c];
        }
        Some(z)
    }

    /// Whether z solves the problem exactly.
    pub(crate) fn is_solution(&self, z: &[BigRational]) -> bool {
        (0..self.n).all(|i| {
            let mut w = rational(self.q[i]);
            for j in 0..self.n {
                w += rational(self.m[i * self.n + j]) * &z[j];
            }
            !z[i].is_negative() && !w.is_negative() && (z[i].is_zero() || w.is_zero())
        })
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
