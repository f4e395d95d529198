//! Sums in double-double precision: a second number collects the rounding errors of the sum.
//!
//! The error of a sum is about ε² of its largest term, with ε = 2⁻⁵². A sum of nearly cancelling terms thus keeps correct digits (T. Ogita, S.
//! M. Rump, S. Oishi, *Accurate sum and dot product*, SIAM J. Sci. Comput. 26, 2005). The residual of an equation near its solution is such a
//! sum.

/// A sum `high + low`, accurate to about 1e-32 of its largest term.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct DoubleDouble {
    pub(crate) high: f64,
    pub(crate) low: f64,
}

impl DoubleDouble {
    pub(crate) fn new(high: f64) -> Self {
        Self { high, low: 0.0 }
    }

    #[inline(always)]
    pub(crate) fn add(&mut self, x: f64) {
        let sum = self.high + x;
        let from_x = sum - self.high;
        self.low += (self.high - (sum - from_x)) + (x - from_x);
        self.high = sum;
    }

    #[inline(always)]
    pub(crate) fn subtract(&mut self, other: Self) {
        self.add(-other.high);
        self.add(-other.low);
    }

    #[inline(always)]
    pub(crate) fn add_product(&mut self, a: f64, b: f64) {
        let product = a * b;
        self.low += rounding_of(product, a, b);
        self.add(product);
    }

    /// Adds the product (a + `rest`) b to this sum; `rest` is the rounding error of a, and b is a double-double number, too.
    #[inline(always)]
    pub(crate) fn add_product_of_twice(&mut self, (a, rest): (f64, f64), b: Self) {
        self.low += a * b.low + rest * b.high;
        self.add_product(a, b.high);
    }

    /// This sum divided by k, which is taken as exact.
    pub(crate) fn over(self, k: f64) -> Self {
        let high = self.high / k;
        let product = high * k;
        Self { high, low: ((self.high - product) - rounding_of(product, high, k) + self.low) / k }
    }

    /// The sum, rounded to a double.
    pub(crate) fn value(self) -> f64 {
        self.high + self.low
    }
}

/// The exact value of `a b - product`, by splitting into halves of 26 bits (T. J. Dekker, 1971). A fused multiply-add is a single instruction, but
/// becomes a library call if the target processor may lack it.
#[inline(always)]
pub(crate) fn rounding_of(product: f64, a: f64, b: f64) -> f64 {
    let ((a_high, a_low), (b_high, b_low)) = (halves(a), halves(b));
    ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low
}

/// Splits a double into halves of 26 bits. Overflows above 1e300; numbers of this library are far smaller.
#[inline(always)]
fn halves(x: f64) -> (f64, f64) {
    let shifted = 134_217_729.0 * x; // 2^27 + 1
    let high = shifted - (shifted - x);
    (high, x - high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keeps_what_cancels() {
        let mut sum = DoubleDouble::new(1e16);
        for x in [1.0, -1e16, 1e-20] {
            sum.add(x);
        }
        assert_eq!(sum.value(), 1.0);
        // (1 + ε)(1 - ε) - 1 = -ε²
        let mut sum = DoubleDouble::new(-1.0);
        sum.add_product(1.0 + f64::EPSILON, 1.0 - f64::EPSILON);
        assert_eq!(sum.value(), -f64::EPSILON * f64::EPSILON);
    }
}
