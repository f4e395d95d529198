//! Pairwise summation of very many terms. Rounding grows only with the logarithm of the number of terms, and the result is the same for any number of
//! threads.

use core::ops::Range;

use super::cores;

/// The results of `a` and `b`, computed on two threads if there are at least 4096 terms to sum.
fn both<R: Send>(count: usize, a: impl FnOnce() -> R + Send, b: impl FnOnce() -> R + Send) -> (R, R) {
    // With fewer terms, waking a second thread costs more than the summation.
    if count >= 4096 { cores::both(a, b) } else { (a(), b()) }
}

/// A sequence that can be divided in two.
pub(crate) trait Halves: Send + Sized {
    fn count(&self) -> usize;

    /// The first `middle` elements, and the remaining ones.
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

/// Two sequences of equal length, divided together.
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

/// The pairwise sum over a sequence, which is halved until its parts are short: `part` sums a short part, and `plus` adds the sums of two halves.
pub(crate) fn in_halves<W: Halves, S: Send>(
    whole: W,
    part: &(impl Fn(W) -> S + Sync),
    plus: &(impl Fn(S, S) -> S + Sync),
) -> S {
    let count = whole.count();
    // Short parts are summed without further halving, which gains too little accuracy for the cost of the calls.
    if count <= 256 {
        return part(whole);
    }
    let (near, far) = whole.divided(count / 2);
    let (a, b) = both(count, || in_halves(near, part, plus), || in_halves(far, part, plus));
    plus(a, b)
}
