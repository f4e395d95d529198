//! Angles from cotangents, for all lanes of a vector at once.
//!
//! The mathematical library of a system may round differently on another processor, and works on one number at a time. This file uses plain
//! arithmetic alone, so that every lane has the same bits everywhere.

use super::lanes::Packed;

/// `(atan x - x) / x³` in powers of x² for |x| <= tan(π/8), interpolated at the roots of a Chebyshev polynomial. The relative error of atan is 7e-18.
/// With one term less it would lose a digit.
const ARCTANGENT_SERIES: [f64; 11] = [
    -0.333_333_333_333_333_3,
    0.199_999_999_999_955_2,
    -0.142_857_142_846_665_42,
    0.111_111_110_152_562_92,
    -0.090_909_045_781_210_85,
    0.076_921_831_907_606_51,
    -0.066_645_114_464_602_2,
    0.058_581_489_047_951_24,
    -0.050_854_496_960_392_584,
    0.039_231_657_085_083_686,
    -0.019_176_885_636_589_053,
];

/// The angle θ from 0 to 2π, rad, with `cot(θ/2) = u`; u may be infinite. For NaN the result has no meaning.
#[inline(always)]
pub(super) fn angle_of<X: Packed>(u: X) -> X {
    let (zero, one) = (X::all(0.0), X::all(1.0));
    let size = u.abs();
    let (small, large) = (size.min(one), size.max(one));
    // Up to this argument, tan(π/8), the series is evaluated directly. Beyond it, x is the tangent of the angle's difference from π/4.
    let bound = X::all(core::f64::consts::SQRT_2 - 1.0) * large;
    let over = small.above(bound, small - large, small);
    let x = over / small.above(bound, small + large, large);
    let square = x * x;
    let mut sum = zero;
    for coefficient in ARCTANGENT_SERIES.into_iter().rev() {
        sum = sum * square + X::all(coefficient);
    }
    let eighth = X::all(core::f64::consts::FRAC_PI_4);
    let steep = small.above(bound, eighth, zero) + (x + x * square * sum);
    // `steep` is the angle whose tangent is min(|u|, 1) / max(|u|, 1).
    let half = size.above(one, steep, X::all(core::f64::consts::FRAC_PI_2) - steep);
    let half = zero.above(u, X::all(core::f64::consts::PI) - half, half);
    half + half
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cotangents_give_back_their_angles() {
        let mut worst = 0.0_f64;
        for k in -200_000..200_000 {
            let u = (f64::from(k) * 4e-5).sinh();
            let exact = 2.0 * 1.0_f64.atan2(u);
            worst = worst.max((angle_of(u) / exact - 1.0).abs());
        }
        assert!(worst < 4.0 * f64::EPSILON, "{worst:e}");
        let at = |u: f64| angle_of(u);
        assert_eq!(
            [at(f64::INFINITY), at(0.0), at(1.0)],
            [0.0, core::f64::consts::PI, core::f64::consts::FRAC_PI_2]
        );
        assert!((at(1e200) / 2e-200 - 1.0).abs() < 4.0 * f64::EPSILON);
    }
}
