//! The upper tail of the normal distribution, of one variable and of two.

use core::f64::consts::TAU;

#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// Density of the standard normal distribution, `φ(x) = exp(-x²/2) / √(2π)`.
pub(crate) fn normal_density(x: f64) -> f64 {
    (-0.5 * x * x).exp() / TAU.sqrt()
}

/// The tail `Φ(-x)`: the probability that a standard normal variable exceeds x, with a relative error of some 1e-14.
pub(crate) fn normal_tail(x: f64) -> f64 {
    if x.is_nan() {
        return x;
    }
    if x < 0.0 {
        return 1.0 - normal_tail(-x);
    }
    // For x below 3 the series of the integral converges in some tens of terms. For larger x the continued fraction of the tail is used.
    if x < 3.0 {
        // Φ(x) - 1/2 = φ(x) (x + x³/3 + x⁵/(3·5) + …)
        let (mut term, mut sum, mut k) = (x, x, 1.0);
        while term > f64::EPSILON * sum {
            k += 2.0;
            term *= x * x / k;
            sum += term;
        }
        return 0.5 - normal_density(x) * sum;
    }
    // Φ(-x) = φ(x) / (x + 1/(x + 2/(x + 3/(x + …))))
    let mut fraction = x;
    // The number of terms of the continued fraction after which its value no longer changes.
    let mut k = (400.0 / (x * x)).ceil() + 10.0;
    while k > 0.0 {
        fraction = x + k / fraction;
        k -= 1.0;
    }
    normal_density(x) / fraction
}

/// The probability that two standard normal variables with the correlation ρ exceed a and b, both above -8. The relative error is 1e-4 up to ρ =
/// 0.99, and a few 1e-3 for ρ closer to 1. `tails` has Φ(-a) and Φ(-b): a caller that sums over many pairs computes each tail only once. The
/// probability is
///
/// ```text
/// Φ(-a) Φ(-b) + 1/(2π) ∫ exp(-(a² + b² - 2ab sin θ) / (2 cos² θ)) dθ      from 0 to asin ρ
/// ```
///
/// (Drezner and Wesolowsky, On the computation of the bivariate normal integral, 1990).
pub(crate) fn tail_of_both([a, b]: [f64; 2], tails: [f64; 2], correlation: f64) -> f64 {
    // Nodes and weights of the Gauss–Legendre rule with eight points on (-1, 1): the four positive nodes.
    let nodes = [
        (0.183_434_642_495_649_78, 0.362_683_783_378_362),
        (0.525_532_409_916_329, 0.313_706_645_877_887_4),
        (0.796_666_477_413_626_7, 0.222_381_034_453_374_45),
        (0.960_289_856_497_536_3, 0.101_228_536_290_376_79),
    ];
    let half = 0.5 * correlation.clamp(-1.0, 1.0).asin();
    let mut sum = 0.0;
    for (node, weight) in nodes {
        for node in [node, -node] {
            let (sin, cos) = (half * (1.0 + node)).sin_cos();
            sum += weight * ((a * b * sin - 0.5 * (a * a + b * b)) / (cos * cos)).exp();
        }
    }
    tails[0] * tails[1] + half * sum / TAU
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_1_SQRT_2, PI};

    use super::*;

    fn normal_tail_of_both(bounds: [f64; 2], correlation: f64) -> f64 {
        tail_of_both(bounds, bounds.map(normal_tail), correlation)
    }

    /// Tables of Φ(-x) with thirty digits (NIST, Digital Library of Mathematical Functions, 7.12 and 26.2).
    #[test]
    fn tails_are_those_of_tables() {
        for (x, tail) in [
            (0.0, 0.5),
            (1.0, 0.158_655_253_931_457_05),
            (2.0, 0.022_750_131_948_179_21),
            (3.0, 0.001_349_898_031_630_094_5),
            (4.0, 3.167_124_183_311_992e-5),
            (6.0, 9.865_876_450_376_98e-10),
            (8.0, 6.220_960_574_271_78e-16),
        ] {
            assert!((normal_tail(x) / tail - 1.0).abs() < 1e-13, "{x}: {:e}", normal_tail(x));
            assert!((normal_tail(-x) - (1.0 - tail)).abs() < 1e-15);
        }
        // The series and the continued fraction agree at x = 3.
        let [below, above] = [3.0 - 1e-9, 3.0].map(normal_tail);
        assert!(((below - above) / (1e-9 * normal_density(3.0)) - 1.0).abs() < 1e-4);
    }

    /// The density is the negative derivative of the tail.
    #[test]
    fn the_tail_falls_by_the_density() {
        for x in [-1.5, -0.2, 0.3, 2.9, 3.5] {
            let h = 1e-4;
            let falls = (normal_tail(x - h) - normal_tail(x + h)) / (2.0 * h);
            assert!((falls / normal_density(x) - 1.0).abs() < 1e-7);
        }
        assert!((normal_density(0.0) - FRAC_1_SQRT_2 / PI.sqrt()).abs() < 1e-16);
    }

    /// Reference values for the probability that two normal variables with the correlation ρ exceed the bounds a and b. For a = b = 0 it is
    /// `1/4 + asin ρ / 2π`. With ρ = 1 both are the same variable, and the greater bound counts. Otherwise, if the first variable has the value x,
    /// the second exceeds b with the probability `Φ(-(b - ρx) / √(1 - ρ²))`. This is integrated with the density φ(x) over x > a.
    #[test]
    fn two_tails_are_those_of_closed_forms() {
        let near = |value: f64, exact: f64| assert!((value / exact - 1.0).abs() < 3e-3, "{value} {exact}");
        for rho in [-0.9, -0.3, 0.0, 0.3, 0.7, 0.9, 0.99] {
            near(normal_tail_of_both([0.0, 0.0], rho), 0.25 + f64::asin(rho) / TAU);
            for [a, b] in [[3.0, 3.0], [3.0, 3.3], [3.0, 2.0], [-0.5, 1.0]] {
                let width = 5e-4;
                let at = |k: i32| a + width * (f64::from(k) + 0.5);
                let given = |x: f64| normal_tail((b - rho * x) / (1.0_f64 - rho * rho).sqrt());
                let exact: f64 = (0..16_000).map(|k| width * normal_density(at(k)) * given(at(k))).sum();
                // With strong negative correlation the result is the small difference of nearly equal numbers, so its absolute error is compared.
                assert!(
                    (normal_tail_of_both([a, b], rho) - exact).abs() < 1e-3 * exact + 1e-6 * normal_tail(a)
                );
            }
        }
        near(normal_tail_of_both([2.0, 2.0], 1.0), normal_tail(2.0));
        near(normal_tail_of_both([2.0, 3.0], 1.0), normal_tail(3.0));
    }
}
