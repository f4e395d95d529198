//! Proofs by Farkas' lemma, without rounding, that no z ≥ 0 satisfies M z + q ≥ 0.
//!
//! A vector y ≥ 0 with Mᵀy ≤ 0 and qᵀy < 0 is such a proof: z ≥ 0 and M z + q ≥ 0 imply yᵀ(M z + q) ≥ 0, but yᵀ(M z + q) = (Mᵀy)ᵀz + qᵀy < 0. A
//! computed y, from a path or a linear program, is rounded, which invalidates the proof where (Mᵀy)_j must be exactly zero. The entries of the exact
//! y usually have the ratios of small integers, so integers are tried as entries. Where the exact (Mᵀy)_j may be negative, a linear program with a
//! margin δ requires (Mᵀy)_j ≤ −δ.

use core::cmp::Ordering;

use super::outcome::{Certificate, Outcome, Unsolved};
use super::problem::Lcp;
use super::tolerances::{BOUND_ROUNDING, LARGEST_WHOLE, ZERO_VALUE, sum_rounding};
use crate::numerics::{ExactSum, Reals, times_power_of_two};
#[cfg(not(feature = "std"))]
use crate::prelude::*;
use nalgebra::DVector;

impl Lcp {
    /// Whether y proves that no z ≥ 0 satisfies M z + q ≥ 0. By Farkas' lemma it does so if y ≥ 0, Mᵀy ≤ 0 and qᵀy < 0.
    ///
    /// All sums are exact, so the result is exact for the given M and q.
    ///
    /// A y of a length other than n proves nothing, nor does a y with an entry that is negative or not finite.
    #[must_use]
    pub fn proves_infeasible(&self, y: &DVector<f64>) -> bool {
        self.contradicts(y, &|_| false, &|_| Domain::NotNegative)
    }

    /// Whether y proves that constraints on M z + q and z contradict each other. Entry i of M z + q is required to be zero if `vanishes(i)`, else
    /// nonnegative. z_j is required to be zero or nonnegative, as `domain(j)` says. The proof needs qᵀy < 0, y_i ≥ 0 where entry i is required to be
    /// nonnegative, and (Mᵀy)_j ≤ 0 where z_j is required to be nonnegative.
    pub(super) fn contradicts(
        &self,
        y: &DVector<f64>,
        vanishes: &dyn Fn(usize) -> bool,
        domain: &dyn Fn(usize) -> Domain,
    ) -> bool {
        y.len() == self.len()
            && y.iter().enumerate().all(|(i, y)| y.is_finite() && (*y >= 0.0 || vanishes(i)))
            && self.q_times(y).sign() == Ordering::Less
            && self.columns().enumerate().all(|(j, column)| match domain(j) {
                Domain::Zero => true,
                Domain::NotNegative => times(column, y).sign() != Ordering::Greater,
            })
    }

    /// A lower bound on Σ z_j over all z ≥ 0 with M z + q ≥ 0, from y ≥ 0 with qᵀy < 0:
    ///
    /// ```text
    /// Σ z_j ≥ −qᵀy / max_j (Mᵀy)_j
    /// ```
    ///
    /// The bound is infinite if y proves that no such z exists, and zero if y proves nothing. All sums are exact; the bound is rounded
    /// downwards.
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
        self.columns().map(against).least() * (1.0 - BOUND_ROUNDING)
    }

    /// The outcome that the vector y proves, as computed or [`cleaned`] of rounding: infeasible if y is a Farkas vector without rounding,
    /// otherwise nearly infeasible. `None` if y is not even a Farkas vector up to rounding.
    pub(super) fn farkas_proof(&self, y: &DVector<f64>) -> Option<Unsolved> {
        let certificate = |y| Certificate { y, pivots: 0 };
        if let Some(y) = cleaned(y).find(|y| self.proves_infeasible(y)) {
            return Some(Outcome::Infeasible(certificate(y)));
        }
        // The first two vectors of `cleaned` have the computed entries, the others integers. Only computed entries are tried here: an integer vector
        // that is no exact Farkas vector proves nothing.
        let nearly = cleaned(y).take(2).find(|y| self.nearly_proves(y));
        nearly.map(|y| Outcome::NearlyInfeasible(certificate(y)))
    }

    /// Whether y ≥ 0 is a Farkas vector up to rounding. Let c = 8 (n + 2) ε, ε = 2⁻⁵². Each (Mᵀy)_j must be at most c Σ_i |M_ij y_i|, and qᵀy must be
    /// less than −c Σ_i |q_i y_i|.
    fn nearly_proves(&self, y: &DVector<f64>) -> bool {
        let rounding = sum_rounding(self.len());
        let sums = |column: &[f64]| {
            let mut sums = (0.0, 0.0, true);
            for (m, y) in column.iter().zip(y) {
                let term: f64 = m * y;
                // A product that underflows has lost more digits than rounding to relative accuracy ε. The bound on the error of the sum then does
                // not hold.
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

    /// Whether row i of M z + q is negative (sign 1) or positive (sign −1) for every z ≥ 0 whose nonzero entries are in the given columns. It is
    /// negative if q_i < 0 and no entry of row i of M in these columns is positive. It is positive if both hold with the opposite signs.
    pub(super) fn has_certain_sign(
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

/// A constraint on an unknown z_j. A Farkas vector proves that no z satisfies these constraints and those on M z + q.
#[derive(Debug, Clone, Copy)]
pub(super) enum Domain {
    /// z_j is required to be nonnegative: z_j ≥ 0.
    NotNegative,
    /// z_j is required to be zero: z_j = 0.
    Zero,
}

fn times(column: &[f64], y: &DVector<f64>) -> ExactSum {
    ExactSum::of_products(column.iter().copied().zip(y.iter().copied()))
}

/// Candidates for a Farkas vector: y as computed; y with entries set to zero that are noise compared with the largest entry; and integer vectors with
/// nearly the same ratios, for increasing errors of these ratios.
pub(super) fn cleaned(y: &DVector<f64>) -> impl Iterator<Item = DVector<f64>> {
    let noise = ZERO_VALUE * y.amax();
    let mut all = vec![y.clone(), y.map(|y| if y.abs() <= noise { 0.0 } else { y })];
    // The magnitude of the rounding errors in y is not known, so candidates are tried for increasing errors.
    for rounding in [1e-14, 1e-11, 1e-8] {
        all.extend(whole_within(y, rounding));
    }
    all.into_iter()
}

/// The integer vector whose entries have the ratios of the entries of y up to `rounding`; `None` if they exceed [`LARGEST_WHOLE`]. The common
/// denominator is built entry by entry, each time multiplied by the smallest factor that makes the entry an integer.
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

/// The denominator, in lowest terms, of a fraction that equals x within `rounding`, found by continued fractions. `None` if it exceeds
/// [`LARGEST_WHOLE`].
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
