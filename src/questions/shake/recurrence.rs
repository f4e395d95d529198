//! Extrapolation of cycle states between cycles with the same events: the difference of two successive cycle states is a linear combination of
//! earlier differences. A cycle state consists of the contact forces and gaps between two cycles. Events are changes of contact states: contacts
//! slip, stick, open or close.
//!
//! An affine map with a matrix A leads from one cycle state to the next, `e_{n+1} = A e_n + b`, so that the differences `d_n = e_{n+1} - e_n` obey
//! `d_{n+1} = A d_n`. If m eigenmodes of A contribute, each difference is a combination of the m differences before it, `d_{n+m} = Σ c_j d_{n+j}`,
//! with coefficients c_j for j from 0 to m - 1. If the differences die out, the cycle states converge to
//! `(e_{n+m+1} - Σ c_j e_{n+j+1}) / (1 - Σ c_j)` (minimal polynomial extrapolation).

use crate::numerics::{IntoList, Singular, mapped, matrix_of, numbered};
use nalgebra::{DMatrix, DVector};

use super::cycle::CycleUnits;
use crate::load_path::CycleState;
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::prelude::*;

/// The last cycle states, and the linear combination of earlier differences of successive ones that gives the last difference.
pub(super) struct Recurrence<'p> {
    /// The last cycle states, the earliest first.
    places: &'p [CycleState],
    /// The differences of neighbouring cycle states, one fewer than cycle states.
    changes: Vec<DVector<f64>>,
    /// Coefficients c of the combination: the last difference is the sum of all differences before it, each multiplied by its coefficient.
    coefficients: Vec<f64>,
}

impl<'p> Recurrence<'p> {
    /// The recurrence with the fewest modes that reproduces the last difference of cycle states up to `error`. `None` if up to eight modes do not
    /// reproduce it, or if there are too few cycle states.
    pub(super) fn of(places: &'p [CycleState], numbers: &[DVector<f64>], error: f64) -> Option<Self> {
        let n = places.len();
        // If more than eight modes contribute, the caller follows further cycles until some modes have died out.
        for modes in 1..9.min(n.saturating_sub(1)) {
            let first = n - modes - 2;
            let changes = numbered(modes + 1, &|k| &numbers[first + k + 1] - &numbers[first + k]);
            let (last, others) = changes.split_last()?;
            let decomposed = Singular::new(&DMatrix::from_columns(others));
            let coefficients = decomposed.solve(last, SOLVED_ROUNDING * decomposed.values[0]);
            let mut left = last.clone();
            for (k, change) in others.iter().enumerate() {
                left -= change * coefficients[k];
            }
            if left.amax() <= error {
                let coefficients = coefficients.as_slice().to_vec();
                return Some(Self { places: &places[first..], changes, coefficients });
            }
        }
        None
    }

    /// The norm of the last difference of successive cycle states divided by the norm of the difference before it.
    pub(super) fn ratio(&self) -> f64 {
        let last = self.changes.len() - 1;
        self.changes[last].norm() / self.changes[last - 1].norm()
    }

    /// The number of cycles after which the difference of successive cycle states is at most `small`, if it shrinks by [`Self::ratio`] in each cycle.
    /// The result is at most 2^20, and 2^20 if differences do not shrink.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to a million")]
    pub(super) fn cycles_until(&self, small: f64) -> usize {
        let last = self.changes[self.changes.len() - 1].amax();
        let cycles = (small / last).ln() / self.ratio().ln();
        let farthest = 1_usize << 20;
        if self.ratio() < 1.0 { cycles.clamp(0.0, farthest as f64).ceil() as usize } else { farthest }
    }

    /// The cycle state to which the recurrence converges; `None` if the coefficients add up to one, so that it determines no limit.
    pub(super) fn fixed_point(&self) -> Option<CycleState> {
        let rest = 1.0 - self.coefficients.iter().sum::<f64>();
        if rest.abs() <= SOLVED_ROUNDING {
            return None;
        }
        // `changes` are differences of two cycle states. Each coefficient becomes the weight of the later of the two, so the first cycle state has
        // weight zero.
        let mut weights = vec![0.0];
        self.coefficients.iter().map(|c| -c / rest).append_to(&mut weights);
        weights.push(1.0 / rest);
        Some(self.combination(&weights))
    }

    /// The predicted cycle state after this number of further cycles, and the predicted difference over the next cycle.
    pub(super) fn after(&self, cycles: usize) -> (CycleState, DVector<f64>) {
        let modes = self.coefficients.len();
        // The companion matrix of the recurrence: in each cycle the differences move up by one row, and the last row gives the new difference.
        let next = matrix_of(modes, modes, &|i, j| {
            if i + 1 == modes { self.coefficients[j] } else { f64::from(u8::from(j == i + 1)) }
        });
        let (power, sum) = power_and_sum(&next, cycles);
        let all = sum.row(modes - 1);
        let then = power.tr_mul(&next.row(modes - 1).transpose());
        let change = then.iter().zip(&self.changes[1..]).map(|(weight, change)| change * *weight).sum();
        let mut weights = vec![0.0; self.places.len()];
        weights[modes + 1] = 1.0;
        for (k, weight) in all.iter().enumerate() {
            weights[k + 2] += weight;
            weights[k + 1] -= weight;
        }
        (self.combination(&weights), change)
    }

    /// The weighted sum of the cycle states `places`; the weights add up to one. The sum is an equilibrium, because all of them are equilibria under
    /// the same load, and the conditions of equilibrium are linear while the events are the same.
    fn combination(&self, weights: &[f64]) -> CycleState {
        let from = &self.places[self.places.len() - 1];
        let mut sum = from.clone();
        for (place, weight) in self.places.iter().zip(weights) {
            // The weights add up to one, so the differences from the last cycle state are combined. Thus numbers that are the same in all of them are
            // not rounded.
            let add = |a: &mut f64, b: f64, base: f64| *a += weight * (b - base);
            for i in 0..sum.forces.len() {
                for axis in 0..3 {
                    add(&mut sum.forces[i][axis], place.forces[i][axis], from.forces[i][axis]);
                    add(&mut sum.slips[i][axis], place.slips[i][axis], from.slips[i][axis]);
                }
                add(&mut sum.gaps[i], place.gaps[i], from.gaps[i]);
            }
            sum.twist += (&place.twist - &from.twist) * *weight;
        }
        sum
    }
}

/// `Aⁿ` and `A + A² + … + Aⁿ` for a square matrix A, by repeated squaring, with one step for each binary digit of n.
fn power_and_sum(a: &DMatrix<f64>, n: usize) -> (DMatrix<f64>, DMatrix<f64>) {
    let size = a.nrows();
    let (mut power, mut sum) = (DMatrix::identity(size, size), DMatrix::zeros(size, size));
    for digit in (0..usize::BITS - n.leading_zeros()).rev() {
        sum += &power * &sum;
        power = &power * &power;
        if n >> digit & 1 == 1 {
            power = a * power;
            sum = a + a * sum;
        }
    }
    (power, sum)
}

impl CycleState {
    /// The forces and gaps of this cycle state in units of `scale`. With kinetic friction, a number for each contact follows: 1 if it slides at its
    /// kinetic coefficient, else 0. Gaps of contacts for which `aside` returns true are replaced by zero.
    pub(super) fn numbers(&self, scale: &CycleUnits, aside: &dyn Fn(usize) -> bool) -> DVector<f64> {
        let mut numbers = Vec::new();
        for force in &self.forces {
            force.iter().map(|x| x / scale.force).append_to(&mut numbers);
        }
        for (i, gap) in self.gaps.iter().enumerate() {
            numbers.push(if aside(i) { 0.0 } else { gap / scale.stretch });
        }
        numbers.extend(mapped(&self.has_kinetic_friction, &|is_kinetic| f64::from(u8::from(*is_kinetic))));
        DVector::from_vec(numbers)
    }

    /// This cycle state after `times` further cycles that repeat. In each of them gaps, slips and motion change by their difference from `from`, the
    /// cycle state one cycle before. Forces do not change.
    pub(super) fn after_repeats(&self, from: &Self, times: f64) -> Self {
        let mut there = self.clone();
        there.slips.iter_mut().zip(&from.slips).for_each(|(slip, before)| *slip += (*slip - before) * times);
        there.gaps.iter_mut().zip(&from.gaps).for_each(|(gap, before)| *gap += (*gap - before) * times);
        there.twist += (&self.twist - &from.twist) * times;
        there
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The powers of `(a, b) → (b, a + b)` contain Fibonacci's numbers. The sum of the first n numbers is number n + 2 of the sequence, less 1. All
    /// these numbers are exact, without rounding.
    #[test]
    fn powers_and_their_sums_are_the_numbers_of_fibonacci() {
        let step = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 1.0, 1.0]);
        let mut numbers = vec![0.0, 1.0];
        for k in 0..70 {
            numbers.push(numbers[k] + numbers[k + 1]);
        }
        for n in 0..70 {
            let (power, sum) = power_and_sum(&step, n);
            assert_eq!([power[(0, 1)], power[(1, 1)]], [numbers[n], numbers[n + 1]], "{n}");
            assert_eq!(sum[(0, 1)], numbers[n + 2] - 1.0, "{n}");
        }
    }
}
