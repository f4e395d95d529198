//! Farkas vectors (y ≥ 0 with Mᵀy ≤ 0 and qᵀy < 0) that a person can check: few nonzero entries, few digits.
//!
//! Lemke's path or a linear program ends in some vector that proves a contradiction, usually one of many. A single contradictory row, or two rows
//! that contradict each other, are easier to understand. If the entries of the vector have few digits, the proof also does not depend on how the
//! entries of a computed vector were rounded.

use super::problem::Lcp;
use super::tolerances::MOST_PAIRED_ROWS;
#[cfg(not(feature = "std"))]
use crate::numerics::FloatFunctions;
use crate::numerics::{increasing, mapped, vector_of};
use nalgebra::DVector;

/// Numbers of binary digits to which the entries of a Farkas vector are rounded, in the order in which they are tried.
const BINARY_DIGITS: [i32; 4] = [1, 3, 8, 20];

impl Lcp {
    /// A Farkas vector with one or two nonzero entries, if one is found. Pairs of rows are only tried if M has at most [`MOST_PAIRED_ROWS`] rows.
    pub(super) fn few_rows(&self) -> Option<DVector<f64>> {
        let n = self.len();
        if let Some(row) = (0..n).find(|row| self.has_certain_sign(*row, 1.0, 0..n)) {
            return Some(vector_of(n, &|i| if i == row { 1.0 } else { 0.0 }));
        }
        if n > MOST_PAIRED_ROWS {
            return None;
        }
        // In a contradiction at least one of the two rows has q < 0, here row i.
        for i in 0..n {
            for k in 0..n {
                if self.q[i] < 0.0 && k != i {
                    let found = self.two_rows(i, k);
                    if found.is_some() {
                        return found;
                    }
                }
            }
        }
        None
    }

    /// A Farkas vector y whose nonzero entries are y_i and y_k. The ratio y_k / y_i must lie between bounds, one from each column of M and one
    /// from q. `None` if no ratio that is tried gives an exact proof.
    fn two_rows(&self, i: usize, k: usize) -> Option<DVector<f64>> {
        let n = self.len();
        // Each bound of the ratio y_k / y_i is stored as a pair (y_i, y_k) of two matrix entries. Products of y with M that must cancel then
        // cancel exactly.
        let (mut least, mut most) = ((1.0, 0.0), (0.0, 1.0));
        let ratio = |(y_i, y_k): (f64, f64)| y_k / y_i;
        for j in 0..=n {
            let column = |row: usize| if j < n { self.m[(row, j)] } else { self.q[row] };
            let (a, b) = (column(i), column(k));
            let bound = (b.abs(), a.abs());
            if a > 0.0 && b >= 0.0 || a >= 0.0 && b > 0.0 {
                return None;
            } else if a > 0.0 && ratio(bound) > ratio(least) {
                least = bound;
            } else if b > 0.0 && ratio(bound) < ratio(most) {
                most = bound;
            }
        }
        let between = match (ratio(least), ratio(most)) {
            (least, most) if most == f64::INFINITY => 2.0 * if least > 0.0 { least } else { 1.0 },
            (least, most) if least > 0.0 => (least * most).sqrt(),
            (_, most) => 0.5 * most,
        };
        let of = |(y_i, y_k): (f64, f64)| {
            vector_of(n, &|row| {
                if row == i {
                    y_i
                } else if row == k {
                    y_k
                } else {
                    0.0
                }
            })
        };
        let mut tried = mapped(&BINARY_DIGITS, &|digits| (1.0, rounded(between, *digits)));
        tried.extend([(1.0, between), least, most]);
        for entries in tried {
            let y = of(entries);
            if self.proves_infeasible(&y) {
                return Some(y);
            }
        }
        None
    }

    /// A simpler Farkas vector than y. Entries that the proof does not need are zero, and the others have as few binary digits as the proof allows.
    /// With more than [`MOST_PAIRED_ROWS`] rows y is returned unchanged.
    pub(super) fn plainer(&self, mut y: DVector<f64>) -> DVector<f64> {
        if self.len() > MOST_PAIRED_ROWS {
            return y;
        }
        for i in increasing(y.as_slice()) {
            if y[i] == 0.0 {
                continue;
            }
            let entry = core::mem::replace(&mut y[i], 0.0);
            if !self.proves_infeasible(&y) {
                y[i] = entry;
            }
        }
        let coarse = BINARY_DIGITS.into_iter().map(|digits| y.map(|y| rounded(y, digits)));
        coarse.into_iter().find(|y| self.proves_infeasible(y)).unwrap_or(y)
    }
}

/// The number x rounded to `digits` binary digits. Adding and subtracting a number 2^(53 − digits) times as large drops all further digits.
fn rounded(x: f64, digits: i32) -> f64 {
    let far = x * 2.0_f64.powi(53 - digits);
    let rounded = (x + far) - far;
    if rounded.is_finite() { rounded } else { x }
}
