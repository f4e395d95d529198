//! Sums and extremes of the numbers of an iterator.

/// Sums and extremes of numbers, by plain loops. For each use of `sum` and `fold` the compiler copies several adapters; a loop compiles in half the
/// time.
pub(crate) trait Reals: Iterator<Item = f64> + Sized {
    /// The sum, added in order.
    fn added(self) -> f64 {
        // -0.0 is the neutral element of addition; starting from 0.0 would change the sign of a sum of negative zeros.
        let mut sum = -0.0;
        for number in self {
            sum += number;
        }
        sum
    }

    /// The largest number; 0 if no number is positive.
    fn most(self) -> f64 {
        let mut most = 0.0_f64;
        for number in self {
            most = most.max(number);
        }
        most
    }

    /// The least number; infinite if there is none.
    fn least(self) -> f64 {
        let mut least = f64::INFINITY;
        for number in self {
            least = least.min(number);
        }
        least
    }
}

impl<I: Iterator<Item = f64>> Reals for I {}
