//! Quantities that are harmonic functions of an angle, `x(φ) = x₀ + x_c cos φ + x_s sin φ`: numbers, vectors and wrenches.

use core::ops::{Add, Mul, Sub};

#[cfg(not(feature = "std"))]
use crate::prelude::*;

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Harmonic<X> {
    pub(crate) constant: X,
    pub(crate) cosine: X,
    pub(crate) sine: X,
}

impl<X> Harmonic<X> {
    /// The function with the coefficients x₀, x_c and x_s.
    pub(crate) fn new([constant, cosine, sine]: [X; 3]) -> Self {
        Self { constant, cosine, sine }
    }

    pub(crate) fn map<Y>(&self, mut by: impl FnMut(&X) -> Y) -> Harmonic<Y> {
        Harmonic { constant: by(&self.constant), cosine: by(&self.cosine), sine: by(&self.sine) }
    }

    /// The coefficients x₀, x_c and x_s of `x(φ) = x₀ + x_c cos φ + x_s sin φ`.
    pub(crate) fn parts(&self) -> [&X; 3] {
        [&self.constant, &self.cosine, &self.sine]
    }
}

impl<X: Clone + Add<Output = X> + Sub<Output = X> + Mul<f64, Output = X>> Harmonic<X> {
    /// The value x(φ) at an angle.
    pub(crate) fn at(&self, angle: f64) -> X {
        let (sin, cos) = angle.sin_cos();
        self.constant.clone() + self.cosine.clone() * cos + self.sine.clone() * sin
    }

    /// The derivative dx/dφ at an angle, per radian.
    pub(crate) fn rate_at(&self, angle: f64) -> X {
        let (sin, cos) = angle.sin_cos();
        self.sine.clone() * cos - self.cosine.clone() * sin
    }

    /// The shifted function `x(angle + φ)` of φ.
    pub(crate) fn from(&self, angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self {
            constant: self.constant.clone(),
            cosine: self.cosine.clone() * cos + self.sine.clone() * sin,
            sine: self.sine.clone() * cos - self.cosine.clone() * sin,
        }
    }
}

impl Harmonic<f64> {
    /// The integral `∫ x dy` as the angle grows from 0 to `angle`: the work of a force x on a displacement y, both functions of the angle.
    pub(crate) fn work_on(&self, moved: &Self, angle: f64) -> f64 {
        let (sin, cos) = angle.sin_cos();
        let (mixed, squares) = (0.5 * sin * sin, [0.5 * (angle + sin * cos), 0.5 * (angle - sin * cos)]);
        // 1 - cos φ as sin φ tan(φ/2), which has no cancellation.
        let versine = sin * (0.5 * angle).tan();
        let versine = if cos > 0.0 { versine } else { 1.0 - cos };
        self.constant * (moved.sine * sin - moved.cosine * versine)
            + self.cosine * (moved.sine * squares[0] - moved.cosine * mixed)
            + self.sine * (moved.sine * mixed - moved.cosine * squares[1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_is_the_sum_of_that_of_many_small_steps() {
        let force = Harmonic::new([0.7, -1.1, 0.4]);
        let moved = Harmonic::new([2.0, 0.3, -0.9]);
        for angle in [1e-3, 0.4, 2.0, 3.5, 20.0] {
            let steps = 20_000;
            let h = angle / f64::from(steps);
            let middle = |k: u32| (f64::from(k) + 0.5) * h;
            let sum: f64 = (0..steps).map(|k| force.at(middle(k)) * moved.rate_at(middle(k)) * h).sum();
            let work = force.work_on(&moved, angle);
            assert!((work - sum).abs() < 1e-6 * angle, "{angle}: {work} {sum}");
        }
    }

    #[test]
    fn what_goes_on_from_an_angle_is_what_was() {
        let x = Harmonic::new([0.7, -1.1, 0.4]);
        let onward = x.from(1.2);
        assert!((onward.at(0.8) - x.at(2.0)).abs() < 1e-15);
        assert!((onward.rate_at(0.8) - x.rate_at(2.0)).abs() < 1e-15);
    }
}
