//! Sums over very many terms, made of halves. Their rounding grows only with the logarithm of their
//! length, and they are the same for any number of threads.

use core::ops::Range;

use super::cores;

/// Both results, on two threads if `count` terms are worth it.
fn both<R: Send>(count: usize, a: impl FnOnce() -> R + Send, b: impl FnOnce() -> R + Send) -> (R, R) {
    // With fewer terms, waking a second thread costs more than their sum.
    if count >= 4096 { cores::both(a, b) } else { (a(), b()) }
}

/// A sequence that can be divided into a first and a second half.
pub(crate) trait Halves: Send + Sized {
    fn count(&self) -> usize;

    /// The first `middle` elements, and the others.
    fn divided(self, middle: usize) -> (Self, Self);
}

impl Halves for Range<usize> {
    #[inline]
    fn count(&self) -> usize {
        self.len()
    }

    fn divided(self, middle: usize) -> (Self, Self) {
        let middle = self.start + middle;
        (self.start..middle, middle..self.end)
    }
}

impl<T: Send> Halves for &mut [T] {
    #[inline]
    fn count(&self) -> usize {
        self.len()
    }

    fn divided(self, middle: usize) -> (Self, Self) {
        self.split_at_mut(middle)
    }
}

/// Two sequences of equal length.
impl<A: Halves, B: Halves> Halves for (A, B) {
    #[inline]
    fn count(&self) -> usize {
        self.0.count()
    }

    fn divided(self, middle: usize) -> (Self, Self) {
        let ((near, far), (also_near, also_far)) = (self.0.divided(middle), self.1.divided(middle));
        ((near, also_near), (far, also_far))
    }
}

/// The sum over a whole, from `part`, the sum of a short part, and `plus`, the sum of two halves.
pub(crate) fn in_halves<W: Halves, S: Send>(
    whole: W,
    part: &(impl Fn(W) -> S + Sync),
    plus: &(impl Fn(S, S) -> S + Sync),
) -> S {
    let count = whole.count();
    // With fewer terms, calls would cost more than the digits are worth.
    if count <= 256 {
        return part(whole);
    }
    let (near, far) = whole.divided(count / 2);
    let (a, b) = both(count, || in_halves(near, part, plus), || in_halves(far, part, plus));
    plus(a, b)
}
