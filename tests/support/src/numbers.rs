//! Reproducible pseudo-random numbers.

/// A linear congruential generator (Knuth's MMIX).
pub struct Numbers(pub u64);

impl Numbers {
    /// The next number, in [0, 1).
    pub fn part(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// The next number, in [-1, 1).
    pub fn signed(&mut self) -> f64 {
        2.0 * self.part() - 1.0
    }

    /// The next three numbers, in [-1, 1).
    pub fn three(&mut self) -> [f64; 3] {
        [self.signed(), self.signed(), self.signed()]
    }
}
