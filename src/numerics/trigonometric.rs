//! First zero crossing of trigonometric polynomials of degree two.
//!
//! ```text
//! f(φ) = c + a₁ cos φ + b₁ sin φ + a₂ cos 2φ + b₂ sin 2φ
//! ```
//!
//! A full turn is treated as four quarter turns. With t = tan(φ/2) from the start of a quarter, `(1 + t²)² f` is a polynomial of degree four on 0 ≤ t
//! ≤ 1. Its extrema are the roots of its derivative, which are found recursively down to degree one. Between two neighbouring extrema the polynomial
//! is monotone: a sign change between them shows exactly one root, and no root with a sign change is missed. A double root is an extremum whose value
//! is zero up to rounding, and counts as a touch.

use core::f64::consts::{FRAC_PI_2, TAU};

use super::harmonic::Harmonic;
use crate::numerics::summed;
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// A trigonometric polynomial `f(φ) = c + a₁ cos φ + b₁ sin φ + a₂ cos 2φ + b₂ sin 2φ`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Trigonometric {
    pub(crate) constant: f64,
    /// Coefficients of cos φ and sin φ.
    pub(crate) first: [f64; 2],
    /// Coefficients of cos 2φ and sin 2φ.
    pub(crate) second: [f64; 2],
}

/// The first zero of a trigonometric polynomial on an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum FirstZero {
    /// The polynomial changes from positive to negative at this angle, rad.
    At(f64),
    /// The polynomial stays positive, but touches zero to within rounding at this angle, rad.
    Touches(f64),
}

impl Trigonometric {
    /// The value of the polynomial at an angle, rad.
    #[cfg(test)]
    pub(crate) fn at(&self, angle: f64) -> f64 {
        let ([sin, cos], [sin2, cos2]) =
            ([angle.sin(), angle.cos()], [(2.0 * angle).sin(), (2.0 * angle).cos()]);
        self.constant
            + self.first[0] * cos
            + self.first[1] * sin
            + self.second[0] * cos2
            + self.second[1] * sin2
    }

    /// Value, first and second derivative of the polynomial at φ = 0.
    pub(crate) fn at_the_beginning(&self) -> [f64; 3] {
        let ([a, b], [a2, b2]) = (self.first, self.second);
        [self.constant + a + a2, b + 2.0 * b2, -a - 4.0 * a2]
    }

    /// The square of `c + a cos φ + b sin φ` as a trigonometric polynomial.
    pub(crate) fn square_of(&Harmonic { constant: c, cosine: a, sine: b }: &Harmonic<f64>) -> Self {
        Self {
            constant: c * c + 0.5 * (a * a + b * b),
            first: [2.0 * c * a, 2.0 * c * b],
            second: [0.5 * (a - b) * (a + b), a * b],
        }
    }

    /// `c + a cos φ + b sin φ` as a trigonometric polynomial.
    pub(crate) fn linear(&Harmonic { constant, cosine, sine }: &Harmonic<f64>) -> Self {
        Self { constant, first: [cosine, sine], second: [0.0; 2] }
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        Self {
            constant: self.constant - other.constant,
            first: [self.first[0] - other.first[0], self.first[1] - other.first[1]],
            second: [self.second[0] - other.second[0], self.second[1] - other.second[1]],
        }
    }

    /// The polynomial f(φ + π/2), for this polynomial f.
    fn a_quarter_on(&self) -> Self {
        let ([a, b], [a2, b2]) = (self.first, self.second);
        Self { constant: self.constant, first: [b, -a], second: [-a2, -b2] }
    }

    /// The first angle in (0, `most`] at which the polynomial becomes negative, or touches zero; `most` is at most a full turn. `None` if there is no
    /// such angle.
    ///
    /// A value up to `rounding` counts as zero. The polynomial has `roots_here` roots at φ = 0. They do not count, because the polynomial is
    /// positive just after φ = 0.
    pub(crate) fn first_fall(&self, most: f64, rounding: f64, roots_here: usize) -> Option<FirstZero> {
        let most = most.min(TAU);
        let mut shifted = *self;
        let mut touched = None;
        for quarter in 0_u8..4 {
            let begin = f64::from(quarter) * FRAC_PI_2;
            if begin >= most {
                break;
            }
            let left = most - begin;
            let end = if left < FRAC_PI_2 { (0.5 * left).tan() } else { 1.0 };
            let mut p = shifted.of_the_half_angle();
            let divided = if quarter == 0 { roots_here } else { 0 };
            p[..divided].fill(0.0);
            p.rotate_left(divided);
            // The polynomial has been divided by the powers of t for its roots at φ = 0. Near φ = 0 its values then have no rounding error larger
            // than themselves, so no nonzero value counts as zero.
            match fall_of(&p, end, if divided > 0 { 0.0 } else { rounding }) {
                Some(FirstZero::At(t)) => return Some(FirstZero::At(begin + 2.0 * t.atan())),
                Some(FirstZero::Touches(t)) => {
                    touched = touched.or(Some(FirstZero::Touches(begin + 2.0 * t.atan())));
                }
                None => {}
            }
            shifted = shifted.a_quarter_on();
        }
        touched
    }

    /// Coefficients of the polynomial `(1 + t²)² f` in t = tan(φ/2), the constant first.
    fn of_the_half_angle(&self) -> [f64; 5] {
        let (c, [a, b], [a2, b2]) = (self.constant, self.first, self.second);
        [c + a + a2, 2.0 * b + 4.0 * b2, 2.0 * c - 6.0 * a2, 2.0 * b - 4.0 * b2, c - a + a2]
    }
}

/// The first zero in (0, end] of the polynomial with coefficients `p` at which it changes from positive to negative. Otherwise the first point
/// where it touches zero to within `rounding`; `None` without such a point.
fn fall_of(p: &[f64; 5], end: f64, rounding: f64) -> Option<FirstZero> {
    // No zero exists on (0, 1] if the constant coefficient exceeds the magnitude of the sum of all negative coefficients.
    if p[0] + summed(&p[1..], &|p| p.min(0.0)) > rounding {
        return None;
    }
    let mut bends = Roots::default();
    roots_of_derivative(p, end, &mut bends);
    let mut touched = None;
    let (mut low, mut value) = (0.0, p[0]);
    for &high in bends.list().iter().chain([&end]) {
        let next = horner(p, high);
        if next < -rounding {
            // If the polynomial is zero at the start, or slightly negative by rounding, the start is the zero.
            let root = if value > 0.0 { root_between(p, low, high) } else { low };
            return Some(FirstZero::At(root));
        }
        if next <= rounding && high < end {
            touched = touched.or(Some(FirstZero::Touches(high)));
        }
        (low, value) = (high, next);
    }
    touched
}

/// Roots of a polynomial in ascending order, at most three.
#[derive(Debug, Default, Clone, Copy)]
struct Roots {
    at: [f64; 3],
    count: usize,
}

impl Roots {
    fn push(&mut self, root: f64) {
        self.at[self.count] = root;
        self.count += 1;
    }

    fn list(&self) -> &[f64] {
        &self.at[..self.count]
    }
}

/// The roots of the derivative p' in (0, end) at which p' changes sign.
fn roots_of_derivative(p: &[f64; 5], end: f64, into: &mut Roots) {
    let derivative = [p[1], 2.0 * p[2], 3.0 * p[3], 4.0 * p[4], 0.0];
    if derivative[1..].iter().all(|p| *p == 0.0) {
        return;
    }
    let mut bends = Roots::default();
    roots_of_derivative(&derivative, end, &mut bends);
    let (mut low, mut value) = (0.0, derivative[0]);
    for &high in bends.list().iter().chain([&end]) {
        let next = horner(&derivative, high);
        if value * next < 0.0 {
            into.push(root_between(&derivative, low, high));
        }
        (low, value) = (high, next);
    }
}

fn horner(p: &[f64; 5], t: f64) -> f64 {
    let mut sum = 0.0;
    for p in p.iter().rev() {
        sum = sum * t + p;
    }
    sum
}

/// The root of the polynomial p between `low` and `high`, where it is monotone and changes sign.
fn root_between(p: &[f64; 5], mut low: f64, mut high: f64) -> f64 {
    let falls = horner(p, low) > horner(p, high);
    let mut t = 0.5 * (low + high);
    // Newton's method with bisection as a fallback; bisection alone would need 53 steps.
    for _ in 0..80 {
        let (mut value, mut slope) = (0.0, 0.0);
        for p in p.iter().rev() {
            slope = slope * t + value;
            value = value * t + p;
        }
        if value == 0.0 {
            return t;
        }
        if (value > 0.0) == falls {
            low = t;
        } else {
            high = t;
        }
        let newton = t - value / slope;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if next == t || next <= low || next >= high || (next - t).abs() <= f64::EPSILON * t {
            return next;
        }
        t = next;
    }
    t
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::generic;

    /// Reference: the first zero crossing, found by sampling in small steps.
    fn stepped(f: &Trigonometric, most: f64) -> Option<f64> {
        let steps = 4_000;
        let angle = |k: i32| most * f64::from(k) / f64::from(steps);
        let k = (1..=steps).find(|k| f.at(angle(*k)) < 0.0)?;
        let (mut low, mut high) = (angle(k - 1), angle(k));
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if f.at(middle) < 0.0 { high = middle } else { low = middle }
        }
        Some(high)
    }

    #[test]
    fn the_first_fall_is_that_of_small_steps() {
        let mut drawn = 0;
        let (mut falls, mut none) = (0, 0);
        for k in 0..6_000 {
            // Pseudorandom numbers between -1 and 1.
            let mut number = || {
                drawn += 1;
                2.0 * generic(drawn) - 2.0
            };
            let second = if k % 3 == 0 { 0.0 } else { 1.0 };
            let f = Trigonometric {
                constant: 1.5 + number(),
                first: [number(), number()],
                second: [number() * second, number() * second],
            };
            if f.at(0.0) < 1e-6 {
                continue;
            }
            let most = TAU * if k % 2 == 0 { 1.0 } else { number().abs() };
            match (f.first_fall(most, 1e-14, 0), stepped(&f, most)) {
                (Some(FirstZero::At(root)), Some(known)) => {
                    falls += 1;
                    assert!((root - known).abs() < 1e-9, "{f:?}: {root} {known}");
                }
                (None | Some(FirstZero::Touches(_)), None) => none += 1,
                // The polynomial may become negative between two sampled angles.
                (Some(FirstZero::At(root)), None) => assert!(f.at(root + 1e-6) > -1e-6, "{f:?}: {root}"),
                (found, known) => panic!("{f:?}: {found:?} {known:?}"),
            }
        }
        assert!(falls > 1000 && none > 1000, "{falls} {none}");
    }

    #[test]
    fn double_roots_are_touched() {
        for (turn, lift) in
            [(0.3_f64, 0.0_f64), (2.0, 0.0), (4.4, 0.0), (6.0, 0.0), (1.0, 1e-9), (1.0, -1e-9)]
        {
            // The polynomials (1 - cos(φ - turn))² and 1 - cos(φ - turn), which touch zero from above.
            let once = Trigonometric::linear(&Harmonic::new([1.0 + lift, -turn.cos(), -turn.sin()]));
            let twice = Trigonometric::square_of(&Harmonic::new([1.0, -turn.cos(), -turn.sin()]));
            match once.first_fall(TAU, 1e-13, 0) {
                Some(FirstZero::Touches(angle)) => assert!(lift == 0.0 && (angle - turn).abs() < 1e-7),
                Some(FirstZero::At(angle)) => assert!(lift < 0.0 && (turn - angle - 4.47e-5).abs() < 1e-6),
                None => assert!(lift > 0.0),
            }
            assert!(!matches!(twice.first_fall(TAU, 1e-13, 0), Some(FirstZero::At(_))));
        }
    }

    #[test]
    fn roots_at_the_beginning_do_not_count() {
        // sin φ increases from zero and changes sign at π; 1 - cos φ touches zero only at the start.
        let sine = Trigonometric::linear(&Harmonic::new([0.0, 0.0, 1.0])).first_fall(TAU, 1e-14, 1);
        assert!(matches!(sine, Some(FirstZero::At(angle)) if (angle - TAU / 2.0).abs() < 1e-15), "{sine:?}");
        assert_eq!(Trigonometric::linear(&Harmonic::new([1.0, -1.0, 0.0])).first_fall(6.0, 1e-14, 2), None);
    }
}
