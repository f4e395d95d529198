//! Exact sums of products of doubles.
//!
//! A product of two doubles is an integer multiple of 2⁻²¹⁴⁸ with less than 4196 bits. A fixed-point number with some more bits holds every sum
//! of products exactly, without cancellation, underflow or overflow (U. Kulisch's long accumulator).

use core::cmp::Ordering;

#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// Number of limbs of 64 bits, 4352 bits in all: 4196 bits for a product, the rest for carries and the sign.
const LIMBS: usize = 68;
/// Binary exponent of the lowest bit of a sum. The value of this bit is the square of the smallest subnormal number.
const LOWEST: i32 = -2148;

/// A sum in two's complement, least significant limb first.
#[derive(Debug, Clone)]
pub(crate) struct ExactSum([u64; LIMBS]);

impl ExactSum {
    pub(crate) fn new() -> Self {
        Self([0; LIMBS])
    }

    /// The sum of products of pairs of finite numbers.
    pub(crate) fn of_products(pairs: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let mut sum = Self::new();
        for (a, b) in pairs {
            sum.add_product(a, b);
        }
        sum
    }

    /// Adds `a b`, for finite a and b.
    pub(crate) fn add_product(&mut self, a: f64, b: f64) {
        let ((m, e), (n, f)) = (parts(a), parts(b));
        let product = u128::from(m) * u128::from(n);
        if product == 0 {
            return;
        }
        let shift = (e + f - LOWEST).unsigned_abs() as usize;
        let (at, bits) = (shift / 64, shift % 64);
        let [low, high] = halves(product);
        let spill = |limb: u64| if bits == 0 { 0 } else { limb >> (64 - bits) };
        let limbs = [low << bits, high << bits | spill(low), spill(high)];
        let negative = a.is_sign_negative() != b.is_sign_negative();
        let mut carry = false;
        for (k, limb) in self.0[at..].iter_mut().enumerate() {
            if k >= limbs.len() && !carry {
                break;
            }
            let term = limbs.get(k).copied().unwrap_or(0);
            (*limb, carry) = if negative { take(*limb, term, carry) } else { add(*limb, term, carry) };
        }
    }

    /// The sign of the sum, as its comparison with zero.
    pub(crate) fn sign(&self) -> Ordering {
        if self.0[LIMBS - 1] >> 63 == 1 {
            Ordering::Less
        } else if self.0.iter().any(|limb| *limb != 0) {
            Ordering::Greater
        } else {
            Ordering::Equal
        }
    }

    /// The leading digits of the sum as `(x, k)`: `x 2ᵏ` has a relative error below 2⁻⁵², and x is zero or 1 ≤ |x| < 2¹²⁸.
    pub(crate) fn leading(&self) -> (f64, i32) {
        let mut size = self.0;
        let negative = self.sign() == Ordering::Less;
        if negative {
            let mut carry = true;
            for limb in &mut size {
                (*limb, carry) = add(!*limb, 0, carry);
            }
        }
        // Each 64-bit limb is paired with the binary exponent of its lowest bit; the highest nonzero limb is wanted.
        let limbs = size.iter().zip((LOWEST..).step_by(64));
        let Some((top, exponent)) = limbs.filter(|(limb, _)| **limb != 0).last() else { return (0.0, 0) };
        let below = size.iter().zip((LOWEST + 64..).step_by(64)).find(|(_, above)| *above == exponent);
        let leading = u128::from(*top) << 64 | below.map_or(0, |(limb, _)| u128::from(*limb));
        let exponent = exponent - 64;
        (if negative { -(leading as f64) } else { leading as f64 }, exponent)
    }
}

/// x 2ᵏ, without intermediate overflow or underflow.
pub(crate) fn times_power_of_two(mut x: f64, mut k: i32) -> f64 {
    while k != 0 && x != 0.0 && x.is_finite() {
        let step = k.clamp(-1000, 1000);
        x *= f64::from(step).exp2();
        k -= step;
    }
    x
}

/// The low and the high limb of a product.
#[expect(clippy::cast_possible_truncation, reason = "the low half is what is asked for")]
fn halves(x: u128) -> [u64; 2] {
    [x as u64, (x >> 64) as u64]
}

/// Decomposes `x = ± m 2ᵉ` with an integer m.
fn parts(x: f64) -> (u64, i32) {
    let bits = x.to_bits();
    let (exponent, mantissa) = ((bits >> 52 & 0x7ff) as i32, bits & ((1 << 52) - 1));
    if exponent == 0 { (mantissa, -1074) } else { (mantissa | 1 << 52, exponent - 1075) }
}

fn add(a: u64, b: u64, carry: bool) -> (u64, bool) {
    let (sum, first) = a.overflowing_add(b);
    let (sum, second) = sum.overflowing_add(u64::from(carry));
    (sum, first || second)
}

fn take(a: u64, b: u64, borrow: bool) -> (u64, bool) {
    let (rest, first) = a.overflowing_sub(b);
    let (rest, second) = rest.overflowing_sub(u64::from(borrow));
    (rest, first || second)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_lost_from_the_smallest_to_the_largest() {
        let tiny = f64::from_bits(1);
        // 1.8e308² and the square of the smallest number in one sum.
        let mut sum = ExactSum::of_products([(f64::MAX, f64::MAX), (tiny, tiny), (f64::MAX, -f64::MAX)]);
        assert_eq!(sum.sign(), Ordering::Greater);
        let (x, k) = sum.leading();
        assert_eq!(x.log2() + f64::from(k), -2148.0);
        sum.add_product(-tiny, tiny);
        assert_eq!(sum.sign(), Ordering::Equal);
        sum.add_product(-tiny, tiny);
        assert_eq!((sum.sign(), sum.leading().0 < 0.0), (Ordering::Less, true));
    }

    #[test]
    fn signs_are_those_of_whole_numbers() {
        // 53-bit numbers whose products cancel to one unit: (2⁵² + 1)(2⁵² - 1) = 2¹⁰⁴ - 1.
        let p = 4_503_599_627_370_496.0;
        let sum = ExactSum::of_products([(p + 1.0, p - 1.0), (-p, p)]);
        let (x, k) = sum.leading();
        assert_eq!((sum.sign(), x * f64::from(k).exp2()), (Ordering::Less, -1.0));
        for (a, b) in [(0.1, 0.3), (-1e-200, 1e-200), (3e150, 4e150), (0.0, -5.0)] {
            let (x, k) = ExactSum::of_products([(a, b)]).leading();
            let exact = if k == 0 { x } else { x * f64::from(k / 2).exp2() * f64::from(k - k / 2).exp2() };
            assert!((exact - a * b).abs() <= f64::EPSILON * (a * b).abs(), "{a} {b}: {exact}");
        }
    }
}
