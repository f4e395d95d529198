//! Quantiles of Student's distribution. They give the confidence interval of a mean whose standard deviation is estimated from the same few numbers.

use core::f64::consts::{FRAC_PI_2, PI};

use super::normal_tail::normal_tail;
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// Half width of a two-sided confidence interval in standard errors, for a probability from 0 to below 1. `degrees` are the degrees of freedom
/// ν, at least one; fractions are allowed. `None` means that the standard deviation is known.
///
/// With t = √ν tan θ, `|t|` is exceeded with the probability `I(cos² θ; ν/2, 1/2)`, an incomplete beta function (Abramowitz and Stegun, 26.7.1 and
/// 26.5.27).
pub(crate) fn two_sided(probability: f64, degrees: Option<f64>) -> f64 {
    let halved = |least: f64, most: f64, within: &dyn Fn(f64) -> f64| {
        let halve = |(low, high): (f64, f64), _| {
            let middle = 0.5 * (low + high);
            if within(middle) < probability { (middle, high) } else { (low, middle) }
        };
        // Sixty bisection steps determine all digits of the quantile.
        let (low, high) = (0..60).fold((least, most), halve);
        0.5 * (low + high)
    };
    // Above 4000 degrees of freedom the normal distribution replaces Student's distribution. There their quantiles for 95 % differ by the fraction
    // 3e-4.
    match degrees {
        Some(nu) if nu <= 4000.0 => {
            let a = 0.5 * nu.max(1.0);
            let whole = beta_with_half(a);
            let angle = halved(0.0, FRAC_PI_2, &|angle| within_an_angle(angle, a, whole));
            angle.tan() * (2.0 * a).sqrt()
        }
        _ => halved(0.0, 40.0, &|z| 1.0 - 2.0 * normal_tail(z)),
    }
}

/// The probability that |t| is below √ν tan θ for Student's t with ν degrees of freedom, at the angle θ. `a` is ν/2, and `whole` is the beta function
/// B(a, 1/2).
fn within_an_angle(angle: f64, a: f64, whole: f64) -> f64 {
    let (sin, cos) = angle.sin_cos();
    let x = cos * cos;
    // Of the two continued fractions for the probability, the faster one is used.
    if x < (a + 1.0) / (a + 2.5) {
        1.0 - x.powf(a) * sin / (a * whole) * fraction(x, a, 0.5)
    } else {
        x.powf(a) * sin / (0.5 * whole) * fraction(sin * sin, 0.5, a)
    }
}

/// The continued fraction of the incomplete beta function (Abramowitz and Stegun, 26.5.8), evaluated forwards.
fn fraction(x: f64, a: f64, b: f64) -> f64 {
    let term = |k: usize| {
        let m = (k / 2) as f64;
        if k.is_multiple_of(2) {
            m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m))
        } else {
            -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0))
        }
    };
    // Convergents p / q by their recurrence, normalised to q = 1.
    let ([mut p, mut before], mut q_before) = ([1.0, 1.0], 0.0);
    // For ν degrees of freedom the continued fraction converges after a number of terms of about √ν, which is far below 500.
    for k in 1..500 {
        let d = term(k);
        let (next, q) = (p + d * before, 1.0 + d * q_before);
        let (last, scaled) = (p, next / q);
        (before, q_before, p) = (p / q, q.recip(), scaled);
        if k > 2 && (scaled - last).abs() <= f64::EPSILON * scaled.abs() {
            break;
        }
    }
    p.recip()
}

/// The beta function B(a, 1/2). Its recurrence in a leads to arguments at which the series for the quotient of gamma functions is accurate
/// (Abramowitz and Stegun, 6.1.47).
fn beta_with_half(a: f64) -> f64 {
    let (mut a, mut times) = (a, 1.0);
    // From this argument on the series below is accurate to 1e-13.
    while a < 100.0 {
        times *= (a + 0.5) / a;
        a += 1.0;
    }
    let x = a.recip();
    let series = 1.0 + x * (-1.0 / 8.0 + x * (1.0 / 128.0 + x * (5.0 / 1024.0 - x * 21.0 / 32768.0)));
    times * (PI * x).sqrt() / series
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Quantiles from tables (Abramowitz and Stegun, table 26.10; NIST/SEMATECH e-Handbook, 1.3.6.7.2).
    #[test]
    fn quantiles_are_those_of_tables() {
        for (nu, quantile) in [
            (1.0, 12.706),
            (2.0, 4.303),
            (3.0, 3.182),
            (4.0, 2.776),
            (5.0, 2.571),
            (10.0, 2.228),
            (30.0, 2.042),
            (100.0, 1.984),
            (1000.0, 1.962),
        ] {
            let found = two_sided(0.95, Some(nu));
            assert!((found - quantile).abs() < 6e-4, "{nu}: {found}");
        }
        assert!((two_sided(0.95, None) - 1.959_963_984_540_054).abs() < 1e-12);
        assert!((two_sided(0.99, Some(7.0)) - 3.499_483).abs() < 1e-6);
    }

    /// For one or two degrees of freedom the distribution function is a closed expression in arctan t or t / √(2 + t²).
    #[test]
    fn few_degrees_of_freedom_have_closed_forms() {
        for probability in [0.1_f64, 0.5, 0.9, 0.95, 0.999] {
            let one = (FRAC_PI_2 * probability).tan();
            let two = probability * (2.0 / (1.0 - probability * probability)).sqrt();
            for (nu, quantile) in [(1.0, one), (2.0, two)] {
                let found = two_sided(probability, Some(nu));
                assert!((found / quantile - 1.0).abs() < 1e-11, "{nu}: {found} {quantile}");
            }
        }
    }

    /// Fractional degrees of freedom, compared with `scipy.stats.t.ppf(0.975, nu)`.
    #[test]
    fn degrees_of_freedom_have_parts() {
        for (nu, quantile) in [
            (1.3, 7.500_529_325_562),
            (2.5, 3.574_654_842_004),
            (3.7, 2.867_520_707_191),
            (7.25, 2.348_194_849_105),
            (41.5, 2.018_802_291_882),
        ] {
            let found = two_sided(0.95, Some(nu));
            assert!((found / quantile - 1.0).abs() < 1e-10, "{nu}: {found}");
        }
    }

    /// At the largest number of degrees of freedom for which Student's distribution is evaluated, its quantile must agree with the quantile of the
    /// normal distribution.
    #[test]
    fn many_degrees_of_freedom_are_a_scatter_that_is_known() {
        let [many, more] = [4000.0, 4001.0].map(|nu| two_sided(0.95, Some(nu)));
        assert!((many / more - 1.0).abs() < 4e-4, "{many} {more}");
    }
}
