//! Sums in twice the working precision: what rounding takes from the sum is kept beside it.
//!
//! A sum of terms that nearly cancel keeps the digits that its terms have (T. Ogita, S. M. Rump, S. Oishi, *Accurate sum and dot
//! product*, SIAM J. Sci. Comput. 26, 2005). What is left of an equation at a solution is such a sum.

/// A sum as `high + low`, known to about 1e-32 of its largest term.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Twice {
    pub(crate) high: f64,
    pub(crate) low: f64,
}

impl Twice {
    pub(crate) fn new(high: f64) -> Self {
        Self { high, low: 0.0 }
    }

    pub(crate) fn add(&mut self, x: f64) {
        let sum = self.high + x;
        let from_x = sum - self.high;
        self.low += (self.high - (sum - from_x)) + (x - from_x);
        self.high = sum;
    }

    pub(crate) fn add_product(&mut self, a: f64, b: f64) {
        let product = a * b;
        // Fused, by the processor or by the system's library: the same bits.
        self.low += a.mul_add(b, -product);
        self.add(product);
    }

    /// Adds `(a + rest) b`, the rest being the rounding of a.
    pub(crate) fn add_product_of_twice(&mut self, (a, rest): (f64, f64), b: Self) {
        self.low += a * b.low + rest * b.high;
        self.add_product(a, b.high);
    }

    /// The sum, rounded.
    pub(crate) fn value(self) -> f64 {
        self.high + self.low
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keeps_what_cancels() {
        let mut sum = Twice::new(1e16);
        for x in [1.0, -1e16, 1e-20] {
            sum.add(x);
        }
        assert_eq!(sum.value(), 1.0);
        // (1 + ε)(1 - ε) - 1 = -ε²
        let mut sum = Twice::new(-1.0);
        sum.add_product(1.0 + f64::EPSILON, 1.0 - f64::EPSILON);
        assert_eq!(sum.value(), -f64::EPSILON * f64::EPSILON);
    }
}
