//! How places between cycles go on while the same events happen: each change is a combination of those before it.
//!
//! From place to place leads an affine map, `e_{n+1} = A e_n + b`, so that changes `d_n = e_{n+1} - e_n` obey `d_{n+1} = A d_n`. Of as many of them as there are modes
//! in them the next one is a combination, `d_{n+m} = Σ c_j d_{n+j}`, and so are all to come. Where they die out, they lead to `(e_{n+m+1} - Σ c_j e_{n+j+1}) / (1 - Σ c_j)`
//! (minimal polynomial extrapolation).

use nalgebra::{DMatrix, DVector};

use super::cycle::Scale;
use crate::load_path::CycleState;
use crate::numerics::Size;
use crate::prelude::*;

/// So many modes are told apart at most: cycles that have more go on until fewer are left.
const MOST_MODES: usize = 8;
/// Singular values below this part of the largest are rounding.
const RANK: f64 = 1e-12;
/// Coefficients whose sum is this near to one lead nowhere.
const NOWHERE: f64 = 1e-12;
/// So many cycles ahead are looked at most.
const FARTHEST: usize = 1 << 20;

/// Places between the last cycles, and what each change is of those before it.
pub(super) struct Recurrence<'p, D: Size, const C: usize> {
    /// The last ones: one more than there are changes.
    places: &'p [CycleState<D, C>],
    changes: Vec<DVector<f64>>,
    /// Of the changes but the last, what makes the last.
    coefficients: Vec<f64>,
}

impl<'p, D: Size, const C: usize> Recurrence<'p, D, C> {
    /// Of as few modes as tell the last change but for an error; `None` where these cycles do not tell.
    pub(super) fn of(places: &'p [CycleState<D, C>], numbers: &[DVector<f64>], error: f64) -> Option<Self> {
        let n = places.len();
        (1..=MOST_MODES.min(n.saturating_sub(2))).find_map(|modes| {
            let places = &places[n - modes - 2..];
            let changes: Vec<_> = numbers[n - modes - 2..].windows(2).map(|two| &two[1] - &two[0]).collect();
            let (last, others) = changes.split_last()?;
            let decomposed = DMatrix::from_columns(others).svd(true, true);
            let rank = RANK * decomposed.singular_values.max();
            let coefficients = decomposed.solve(last, rank).ok()?;
            let told = others.iter().zip(coefficients.iter());
            let left = told.fold(last.clone(), |left, (change, weight)| left - change * *weight);
            let coefficients = coefficients.iter().copied().collect();
            (left.amax() <= error).then_some(Self { places, changes, coefficients })
        })
    }

    /// How much of a change is left in the next one.
    pub(super) fn ratio(&self) -> f64 {
        let last = self.changes.len() - 1;
        self.changes[last].norm() / self.changes[last - 1].norm()
    }

    /// After so many cycles changes are as small as that; fewer where they do not get smaller.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to a million")]
    pub(super) fn until(&self, small: f64) -> usize {
        let last = self.changes[self.changes.len() - 1].amax();
        let cycles = (small / last).ln() / self.ratio().ln();
        if self.ratio() < 1.0 { cycles.clamp(0.0, FARTHEST as f64).ceil() as usize } else { FARTHEST }
    }

    /// Where they lead to.
    pub(super) fn fixed_point(&self) -> Option<CycleState<D, C>> {
        let rest = 1.0 - self.coefficients.iter().sum::<f64>();
        if rest.abs() <= NOWHERE {
            return None;
        }
        let others = self.coefficients.iter().map(|c| -c / rest);
        // Each change leads from its place to the next.
        let weights: Vec<f64> = core::iter::once(0.0).chain(others).chain([1.0 / rest]).collect();
        Some(self.combination(&weights))
    }

    /// Where the grasp stands after so many more cycles, and what changes in the one after them.
    pub(super) fn after(&self, cycles: usize) -> (CycleState<D, C>, DVector<f64>) {
        let modes = self.coefficients.len();
        // Changes to come as combinations of the last ones but the first, which is spent: each moves up, and the last becomes the next.
        let next = DMatrix::from_fn(modes, modes, |i, j| {
            if i + 1 == modes { self.coefficients[j] } else { f64::from(u8::from(j == i + 1)) }
        });
        let (power, sum) = power_and_sum(&next, cycles);
        let all = sum.row(modes - 1);
        let then = next.row(modes - 1) * power;
        let change = then.iter().zip(&self.changes[1..]).map(|(weight, change)| change * *weight).sum();
        let mut weights = vec![0.0; self.places.len()];
        weights[modes + 1] = 1.0;
        for (k, weight) in all.iter().enumerate() {
            weights[k + 2] += weight;
            weights[k + 1] -= weight;
        }
        (self.combination(&weights), change)
    }

    /// An affine combination of the places: of one load all of them are balanced, and so is it.
    fn combination(&self, weights: &[f64]) -> CycleState<D, C> {
        let from = &self.places[self.places.len() - 1];
        let mut sum = from.clone();
        for (place, weight) in self.places.iter().zip(weights) {
            // Differences keep what all of them have in common free of rounding.
            let add = |a: &mut f64, b: f64, base: f64| *a += weight * (b - base);
            for i in 0..sum.forces.len() {
                for axis in 0..C {
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

/// `Aⁿ` and `A + A² + … + Aⁿ`, by as many products as n has binary digits.
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

impl<D: Size, const C: usize> CycleState<D, C> {
    /// Forces and gaps, as numbers without unit, and who slides with less friction than at rest; gaps of what is `aside` left out.
    pub(super) fn numbers(&self, scale: &Scale, aside: &dyn Fn(usize) -> bool) -> DVector<f64> {
        let forces = self.forces.iter().flat_map(|force| force.iter().map(|x| x / scale.force));
        let gap = |(i, gap): (usize, &f64)| if aside(i) { 0.0 } else { gap / scale.stretch };
        let weaker = self.weaker.iter().map(|weaker| f64::from(u8::from(*weaker)));
        DVector::from_vec(forces.chain(self.gaps.iter().enumerate().map(gap)).chain(weaker).collect())
    }

    /// This place moved on as often as said by what leads from another one here.
    pub(super) fn moved_on(&self, from: &Self, times: f64) -> Self {
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

    /// Of `(a, b) → (b, a + b)` they are Fibonacci's numbers, and their sums are two further on, less one: whole, and without rounding.
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
