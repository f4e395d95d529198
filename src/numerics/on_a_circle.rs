//! Angles φ at which `N(φ) - |v(φ)|` is negative. The number N and the vector v are functions `x₀ + x_c cos φ + x_s sin φ` of the angle.
//!
//! No such angle exists if and only if neither N nor `N² - |v|²`, a trigonometric polynomial of degree two, is ever negative.

use core::f64::consts::TAU;

use nalgebra::SVector;

use super::harmonic::Harmonic;
use super::tolerances::ROUNDED_SUM;
use super::trigonometric::{FirstZero, Trigonometric};

/// A number N and a vector v as functions of an angle, whose difference `N - |v|` is studied.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Turning<const C: usize> {
    pub(crate) number: Harmonic<f64>,
    pub(crate) vector: Harmonic<SVector<f64, C>>,
}

impl<const C: usize> Turning<C> {
    fn value(&self, angle: f64) -> f64 {
        self.number.at(angle) - self.vector.at(angle).norm()
    }

    /// The sum of the absolute values of all coefficients of N and v: the rounding scale of N - |v|.
    fn size(&self) -> f64 {
        let [numbers, vectors] = [self.number.map(|x| x.abs()), self.vector.map(SVector::norm)];
        numbers.parts().into_iter().chain(vectors.parts()).sum()
    }

    /// The trigonometric polynomial N² - |v|² of the number N and the vector v.
    pub(crate) fn square(&self) -> Trigonometric {
        let square = Trigonometric::square_of(&self.number);
        (0..C).fold(square, |sum, axis| sum.minus(&Trigonometric::square_of(&self.vector.map(|v| v[axis]))))
    }

    /// An angle from 0 to `most` at which N - |v| has a local minimum that is negative by more than rounding. `None` if there is no such angle.
    pub(crate) fn deepest(&self, most: f64) -> Option<f64> {
        let rounding = ROUNDED_SUM * self.size();
        if self.value(0.0) < -rounding {
            return Some(self.least_near(0.0, most));
        }
        let falls = [
            Trigonometric::linear(&self.number).first_fall(most, rounding, 0),
            self.square().first_fall(most, rounding * self.size(), 0),
        ];
        falls.into_iter().find_map(|fall| match fall? {
            FirstZero::At(angle) => Some(self.least_near(angle, most)),
            FirstZero::Touches(_) => None,
        })
    }

    /// The angle of the local minimum of N - |v|, with the number N and the vector v, that a descent from the angle `start` reaches. The angle lies
    /// between 0 and `most`. Only if `most` is a full turn may the angle lie outside, since all angles are then allowed.
    fn least_near(&self, start: f64, most: f64) -> f64 {
        let within = |angle: f64| if most < TAU { angle.clamp(0.0, most) } else { angle };
        // First step of the descent, rad. Steps are doubled until N - |v| increases, and the minimum is then sought between the last three angles.
        let first_step = 1e-3;
        let way = if self.value(within(start + first_step)) <= self.value(within(start - first_step)) {
            1.0
        } else {
            -1.0
        };
        let (mut before, mut at, mut step) = (within(start - way * first_step), start, first_step);
        let mut value = self.value(start);
        while step < TAU {
            let next = within(at + way * step);
            if self.value(next) >= value {
                break;
            }
            (before, at, value) = (at, next, self.value(next));
            step *= 2.0;
        }
        let (mut low, mut high) = (before, within(at + way * step));
        for _ in 0..80 {
            let third = (high - low) / 3.0;
            if self.value(low + third) <= self.value(high - third) { high -= third } else { low += third }
        }
        let found = 0.5 * (low + high);
        if self.value(found) <= value { found } else { at }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::generic;

    #[test]
    fn what_is_negative_somewhere_is_found() {
        let mut drawn = 0;
        let (mut some, mut none) = (0, 0);
        for _ in 0..2000 {
            let mut number = || {
                drawn += 1;
                2.0 * generic(drawn) - 2.0
            };
            let turning = Turning {
                number: Harmonic::new([2.0 + number(), number(), number()]),
                vector: Harmonic::new(core::array::from_fn(|_| SVector::from([number(), number()]))),
            };
            let sampled =
                (0..3000).map(|k| turning.value(TAU * f64::from(k) / 3000.0)).fold(f64::INFINITY, f64::min);
            if let Some(angle) = turning.deepest(TAU) {
                assert!(turning.value(angle) < 0.0, "{turning:?}");
                some += 1;
            } else {
                assert!(sampled > -1e-12, "{turning:?}: {sampled}");
                none += 1;
            }
        }
        assert!(some > 200 && none > 200, "{some} {none}");
    }

    #[test]
    fn what_is_the_same_all_round_is_told_apart_by_its_sign() {
        for (number, negative) in [(1.0, false), (1.0 + 1e-12, false), (1.0 - 1e-12, true)] {
            let vector = Harmonic::new([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(SVector::from));
            let turning = Turning { number: Harmonic::new([number, 0.0, 0.0]), vector };
            assert_eq!(turning.deepest(TAU).is_some(), negative, "{number}");
        }
    }
}
