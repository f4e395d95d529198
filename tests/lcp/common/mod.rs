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
    /// Decided by the simplex method, so singular blocks need no special care.
    pub(crate) fn is_solvable(&self) -> bool {
        (0..1_u32 << self.n).any(|alpha| self.has_point(alpha, alpha))
    }

    /// Whether { z ≥ 0, Mz + q ≥ 0 } is not empty.
    pub(crate) fn is_feasible(&self) -> bool {
        self.has_point((1 << self.n) - 1, 0)
    }

    /// Whether there are z ≥ 0 with support in `support`, (Mz + q)_i = 0 for i in `equal`, Mz + q ≥ 0.
    fn has_point(&self, support: u32, equal: u32) -> bool {
        let columns: Vec<usize> = (0..self.n).filter(|i| support >> i & 1 == 1).collect();
        let slacks: Vec<usize> = (0..self.n).filter(|i| equal >> i & 1 == 0).collect();
        let width = columns.len() + slacks.len();
        // Rows of M z − s = −q, with a right-hand side that is not negative; the artificial basis is implicit.
        let mut rows: Vec<Vec<BigRational>> = (0..self.n)
            .map(|i| {
                let mut row: Vec<BigRational> =
                    columns.iter().map(|j| rational(self.m[i * self.n + j])).collect();
                row.extend(slacks.iter().map(|s| rational(-i64::from(*s == i))));
                row.push(rational(-self.q[i]));
                if row[width].is_negative() { row.iter().map(|x| -x).collect() } else { row }
            })
            .collect();
        let mut basic: Vec<Option<usize>> = vec![None; self.n];
        loop {
            let infeasibility = |c: usize| -> BigRational {
                rows.iter().zip(&basic).filter(|(_, b)| b.is_none()).map(|(row, _)| row[c].clone()).sum()
            };
            if infeasibility(width).is_zero() {
                return true;
            }
            // Bland's rule: the first column that helps, the smallest basic index among the rows that block.
            let Some(enter) = (0..width).find(|c| infeasibility(*c).is_positive()) else { return false };
            let leave = (0..self.n)
                .filter(|r| rows[*r][enter].is_positive())
                .min_by_key(|r| (&rows[*r][width] / &rows[*r][enter], basic[*r].map_or(usize::MAX, |b| b)))
                .expect("the infeasibility is bounded below");
            let scale = rows[leave][enter].clone();
            rows[leave].iter_mut().for_each(|x| *x /= &scale);
            let head = rows[leave].clone();
            for r in (0..self.n).filter(|r| *r != leave) {
                let f = rows[r][enter].clone();
                if !f.is_zero() {
                    rows[r].iter_mut().zip(&head).for_each(|(x, h)| *x -= &f * h);
                }
            }
            basic[leave] = Some(enter);
        }
    }

    /// The distinct solutions at regular bases.
    pub(crate) fn regular_solutions(&self) -> Vec<Vec<BigRational>> {
        let mut points = Vec::new();
        for bits in 0..1_u32 << self.n {
            let alpha: Vec<usize> = (0..self.n).filter(|i| bits >> i & 1 == 1).collect();
            if let Some(z) = self.exact_point(&alpha)
                && self.is_solution(&z)
            {
                points.push(z);
            }
        }
        points.sort();
        points.dedup();
        points
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
