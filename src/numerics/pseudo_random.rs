//! Reproducible pseudorandom numbers, the same on every machine and in every run.

use core::f64::consts::TAU;

#[cfg(not(feature = "std"))]
use crate::prelude::*;

const WEYL_STEP: u64 = 0x9E37_79B9_7F4A_7C15;

/// Number i of a fixed list of irregular numbers, each from 1/2 to below 3/2. They serve as perturbations that break ties, and as data of tests.
pub(crate) fn generic(i: usize) -> f64 {
    let bits = mixed((i as u64).wrapping_add(1).wrapping_mul(WEYL_STEP));
    0.5 + (bits >> 11) as f64 / (1_u64 << 53) as f64
}

/// The output function of the generator SplitMix64: a one-to-one map of 64-bit words that spreads each bit over all bits.
fn mixed(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// Random numbers that depend only on the three words of the seed: SplitMix64 (Steele, Lea and Flood, Fast splittable pseudorandom number generators,
/// 2014).
pub(crate) struct Draw(u64);

impl Draw {
    /// The generator with this seed. Its 64 bits depend on every word of the seed, so that neighbouring seeds give unrelated numbers.
    pub(crate) fn new(seed: [u64; 3]) -> Self {
        let mut draw = Self(0);
        for word in seed {
            draw.0 ^= word;
            draw.0 = draw.next();
        }
        draw
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(WEYL_STEP);
        mixed(self.0)
    }

    /// 1 or −1, each with probability one half.
    pub(crate) fn sign(&mut self) -> f64 {
        if self.next() >> 63 == 0 { 1.0 } else { -1.0 }
    }

    /// A uniform number in the open interval (0, 1).
    pub(crate) fn uniform(&mut self) -> f64 {
        ((self.next() >> 12) as f64 + 0.5) / (1_u64 << 52) as f64
    }

    /// A standard normal number (mean 0, variance 1), by the Box–Muller method.
    pub(crate) fn normal(&mut self) -> f64 {
        let (radius, angle) = ((-2.0 * self.uniform().ln()).sqrt(), TAU * self.uniform());
        radius * angle.cos()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normal_numbers_have_the_moments_of_a_normal_distribution() {
        let count = 40_000_u64;
        let draws: Vec<f64> = (0..count).map(|i| Draw::new([3, i, i % 5]).normal()).collect();
        let moment = |k: i32| draws.iter().map(|z| z.powi(k)).sum::<f64>() / count as f64;
        // The allowed error of a moment: five standard deviations of the sampling error.
        let error = |variance: f64| 5.0 * (variance / count as f64).sqrt();
        assert!(moment(1).abs() < error(1.0), "{}", moment(1));
        assert!((moment(2) - 1.0).abs() < error(2.0), "{}", moment(2));
        assert!(moment(3).abs() < error(15.0), "{}", moment(3));
        assert!((moment(4) - 3.0).abs() < error(96.0), "{}", moment(4));
    }
}
