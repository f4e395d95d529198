//! Proofs that no z ≥ 0 has M z + q ≥ 0, by Farkas' lemma, without rounding.
//!
//! A vector y ≥ 0 with Mᵀy ≤ 0 and qᵀy < 0 is such a proof: z ≥ 0 and M z + q ≥ 0 would imply yᵀ(M z + q) ≥ 0. The y at the end of a path
//! or of a linear program carries rounding, which spoils it where (Mᵀy)_j must vanish. The exact y usually has the ratios of small whole numbers,
//! and these are tried in its place. Where (Mᵀy)_j may be negative, a linear program with a margin keeps it so.

use core::cmp::Ordering;

use super::outcome::{Certificate, Outcome, Unsolved};
use super::problem::Lcp;
use super::tolerances::{BOUND_ROUNDING, LARGEST_WHOLE, ZERO_VALUE, sum_rounding};
use crate::numerics::{ExactSum, times_power_of_two};
#[cfg(not(feature = "std"))]
use crate::prelude::*;
use nalgebra::DVector;

impl Lcp {
    /// Whether y proves that no z ≥ 0 has M z + q ≥ 0: y ≥ 0, Mᵀy ≤ 0 and qᵀy < 0 (Farkas' lemma).
    ///
    /// All sums are made without rounding, so the result is exact for the M and q given.
    ///
    /// A y of another length than n proves nothing, nor does one with a negative entry or one that
    /// is not finite.
    #[must_use]
    pub fn proves_infeasible(&self, y: &DVector<f64>) -> bool {
        self.contradicts(y, |_| false, |_| Domain::NotNegative)
    }

    /// Whether y proves that some constraints contradict each other: rows of M z + q that vanish or are not negative, and unknowns
    /// of the three kinds of [`Domain`]. Then y_i ≥ 0 in rows that are not negative, (Mᵀy)_j ≤ 0 for z_j ≥ 0, (Mᵀy)_j = 0 for free z_j, and qᵀy < 0.
    pub(super) fn contradicts(
        &self,
        y: &DVector<f64>,
        vanishes: impl Fn(usize) -> bool,
        domain: impl Fn(usize) -> Domain,
    ) -> bool {
        y.len() == self.len()
            && y.iter().enumerate().all(|(i, y)| y.is_finite() && (*y >= 0.0 || vanishes(i)))
            && self.q_times(y).sign() == Ordering::Less
            && self.columns().enumerate().all(|(j, column)| match domain(j) {
                Domain::Zero => true,
                Domain::NotNegative => times(column, y).sign() != Ordering::Greater,
                Domain::Free => times(column, y).sign() == Ordering::Equal,
            })
    }

    /// A lower bound on Σ z_j for every z ≥ 0 with M z + q ≥ 0, from y ≥ 0 with qᵀy < 0:
    ///
    /// ```text
    /// Σ z_j ≥ −qᵀy / max_j (Mᵀy)_j
    /// ```
    ///
    /// Infinite if y proves that there is no such z, zero if y proves nothing. All sums are made without rounding; the bound is
    /// rounded downwards.
    ///
    /// ```
    /// use grasp_lcp::lcp::Lcp;
    /// use nalgebra::{DMatrix, DVector};
    ///
    /// // w = 1e-15 z - 1: feasible, for z from 1e15 on.
    /// let problem = Lcp::new(DMatrix::from_element(1, 1, 1e-15), DVector::from_element(1, -1.0))?;
    /// let y = DVector::from_element(1, 1.0);
    /// assert!(!problem.proves_infeasible(&y));
    /// let least = problem.least_feasible(&y);
    /// assert!(least <= 1e15 && least > 0.999e15);
    /// # Ok::<(), grasp_lcp::lcp::LcpError>(())
    /// ```
    #[must_use]
    pub fn least_feasible(&self, y: &DVector<f64>) -> f64 {
        let (descent, k) = self.q_times(y).leading();
        if !self.may_prove(y) || descent >= 0.0 {
            return 0.0;
        }
        let against = |column| {
            let (sum, l) = times(column, y).leading();
            if sum <= 0.0 { f64::INFINITY } else { times_power_of_two(-descent / sum, k - l) }
        };
        self.columns().map(against).fold(f64::INFINITY, f64::min) * (1.0 - BOUND_ROUNDING)
    }

    /// The proof that a vector with rounding contains, as computed or [`cleaned`]: exact, or else but for rounding.
    pub(super) fn farkas_proof(&self, y: &DVector<f64>) -> Option<Unsolved> {
        let certificate = |y| Certificate { y, pivots: 0 };
        if let Some(y) = cleaned(y).find(|y| self.proves_infeasible(y)) {
            return Some(Outcome::Infeasible(certificate(y)));
        }
        // The first two vectors keep the computed entries; the others are rounded to whole numbers.
        let nearly = cleaned(y).take(2).find(|y| self.nearly_proves(y));
        nearly.map(|y| Outcome::NearlyInfeasible(certificate(y)))
    }

    /// Whether y is a Farkas vector but for rounding: (Mᵀy)_j at most 8 (n + 2) ε times the sizes of its terms, ε = 2⁻⁵².
    fn nearly_proves(&self, y: &DVector<f64>) -> bool {
        let rounding = sum_rounding(self.len());
        let sums = |column: &[f64]| {
            let mut sums = (0.0, 0.0, true);
            for (m, y) in column.iter().zip(y) {
                let term: f64 = m * y;
                // A product that underflows has lost more than relative rounding.
                let kept = *m == 0.0 || *y == 0.0 || term.is_normal();
                sums = (sums.0 + term, sums.1 + term.abs(), sums.2 && kept);
            }
            sums
        };
        let (sum, terms, kept) = sums(self.q.as_slice());
        self.may_prove(y)
            && kept
            && terms.is_finite()
            && sum < -rounding * terms
            && self.columns().all(|column| {
                let (sum, terms, kept) = sums(column);
                kept && terms.is_finite() && sum <= rounding * terms
            })
    }

    /// Whether every z ≥ 0 with entries in these columns alone leaves row i negative (sign 1) or positive (sign −1).
    /// It does if q_i has that sign and no entry of the row has the other.
    pub(super) fn is_hopeless(
        &self,
        row: usize,
        sign: f64,
        mut columns: impl Iterator<Item = usize>,
    ) -> bool {
        sign * self.q[row] < 0.0 && columns.all(|j| sign * self.m[(row, j)] <= 0.0)
    }

    fn may_prove(&self, y: &DVector<f64>) -> bool {
        y.len() == self.len() && y.iter().all(|y| y.is_finite() && *y >= 0.0)
    }

    fn columns(&self) -> impl Iterator<Item = &[f64]> {
        self.m.as_slice().chunks_exact(self.len().max(1))
    }

    fn q_times(&self, y: &DVector<f64>) -> ExactSum {
        times(self.q.as_slice(), y)
    }
}

/// The values allowed for an unknown.
#[derive(Debug, Clone, Copy)]
pub(super) enum Domain {
    /// Anywhere.
    Free,
    /// z_j ≥ 0.
    NotNegative,
    /// z_j = 0.
    Zero,
}

fn times(column: &[f64], y: &DVector<f64>) -> ExactSum {
    ExactSum::of_products(column.iter().copied().zip(y.iter().copied()))
}

/// A vector as computed; then without the entries that are noise beside the largest; then the vectors of whole numbers with its ratios, for
/// larger and larger rounding.
pub(super) fn cleaned(y: &DVector<f64>) -> impl Iterator<Item = DVector<f64>> {
    let noise = ZERO_VALUE * y.amax();
    let mut all = vec![y.clone(), y.map(|y| if y.abs() <= noise { 0.0 } else { y })];
    // The rounding of the path is not known beforehand, so the smallest that leads to a proof is used.
    for rounding in [1e-14, 1e-11, 1e-8] {
        all.extend(whole_within(y, rounding));
    }
    all.into_iter()
}

/// The vector of whole numbers with these ratios, if there is one. Entries are made whole one after the other, each by the least
/// denominator beyond that of the entries before.
fn whole_within(y: &DVector<f64>, rounding: f64) -> Option<DVector<f64>> {
    let largest = y.amax();
    let mut denominator = 1.0;
    for y in y.iter().map(|y| y.abs()).filter(|y| *y > ZERO_VALUE * largest) {
        denominator *= denominator_of(y / largest * denominator, rounding)?;
        if denominator > LARGEST_WHOLE {
            return None;
        }
    }
    Some(y.map(|y| (y / largest * denominator).round()))
}

/// The denominator, in lowest terms, of the fraction that equals x within `rounding`: by its continued fraction.
fn denominator_of(x: f64, rounding: f64) -> Option<f64> {
    let (mut rest, mut before, mut denominator) = (x, 0.0, 1.0);
    while denominator <= LARGEST_WHOLE {
        let scaled = x * denominator;
        if (scaled - scaled.round()).abs() <= rounding * scaled {
            return Some(denominator);
        }
        rest = 1.0 / (rest - rest.floor());
        (before, denominator) = (denominator, rest.floor() * denominator + before);
    }
    None
}
