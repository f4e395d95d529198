//! Student's distribution: how far a mean may be off by chance where the scatter is estimated from the same few numbers.

use core::f64::consts::{FRAC_2_PI, FRAC_PI_2};

use super::normal_tail::normal_tail;
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// More degrees of freedom are as good as any number of them, to some 1e-4.
const MANY: usize = 4000;
/// An angle is halved so often, to all digits.
const HALVINGS: usize = 60;

/// How many standard errors on both sides hold the truth with this probability, from 0 to less than 1. `None` degrees of freedom stand for a scatter
/// that is known.
///
/// With an integer number ν of them the distribution is a finite sum in θ, tan θ = t / √ν (Abramowitz and Stegun, 26.7.3 and 26.7.4).
pub(crate) fn two_sided(probability: f64, degrees: Option<usize>) -> f64 {
    let halved = |least: f64, most: f64, within: &dyn Fn(f64) -> f64| {
        let halve = |(low, high): (f64, f64), _| {
            let middle = 0.5 * (low + high);
            if within(middle) < probability { (middle, high) } else { (low, middle) }
        };
        let (low, high) = (0..HALVINGS).fold((least, most), halve);
        0.5 * (low + high)
    };
    match degrees {
        Some(nu) if nu <= MANY => {
            let angle = halved(0.0, FRAC_PI_2, &|angle| within_an_angle(angle, nu));
            angle.tan() * (nu as f64).sqrt()
        }
        _ => halved(0.0, 40.0, &|z| 1.0 - 2.0 * normal_tail(z)),
    }
}

/// How often |t| stays below √ν tan θ.
fn within_an_angle(angle: f64, nu: usize) -> f64 {
    let (sin, cos) = angle.sin_cos();
    let is_odd = nu % 2 == 1;
    // cos θ + 2/3 cos³ θ + …, or 1 + 1/2 cos² θ + …, up to cos^(ν-2).
    let (first, mut term) = if is_odd { (1, cos) } else { (0, 1.0) };
    let mut sum = 0.0;
    let mut power = first;
    while power + 2 <= nu {
        sum += term;
        power += 2;
        term *= cos * cos * (power - 1) as f64 / power as f64;
    }
    if is_odd { FRAC_2_PI * (angle + sin * sum) } else { sin * sum }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Quantiles from tables (Abramowitz and Stegun, table 26.10; NIST/SEMATECH e-Handbook, 1.3.6.7.2).
    #[test]
    fn quantiles_are_those_of_tables() {
        for (nu, quantile) in [
            (1, 12.706),
            (2, 4.303),
            (3, 3.182),
            (4, 2.776),
            (5, 2.571),
            (10, 2.228),
            (30, 2.042),
            (100, 1.984),
            (1000, 1.962),
        ] {
            let found = two_sided(0.95, Some(nu));
            assert!((found - quantile).abs() < 6e-4, "{nu}: {found}");
        }
        assert!((two_sided(0.95, None) - 1.959_963_984_540_054).abs() < 1e-12);
        assert!((two_sided(0.99, Some(7)) - 3.499_483).abs() < 1e-6);
    }

    /// The largest number that is summed up meets the normal distribution.
    #[test]
    fn many_degrees_of_freedom_are_a_scatter_that_is_known() {
        let [many, more] = [MANY, MANY + 1].map(|nu| two_sided(0.95, Some(nu)));
        assert!((many / more - 1.0).abs() < 4e-4, "{many} {more}");
    }
}
