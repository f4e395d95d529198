//! Sums over very many terms, made of halves. Their rounding grows with the logarithm of their
//! length only, and they are the same for any number of threads.

use core::ops::Range;

use super::cores;

/// Terms that are summed one after the other: fewer would cost more calls than digits are worth.
const SUMMED_IN_TURN: usize = 256;
/// Terms that are worth a second thread: with fewer, waking it costs more than their sum.
const APART: usize = 4096;

/// Both results, on two threads if the work on so many contacts is worth it.
fn both<R: Send>(count: usize, a: impl FnOnce() -> R + Send, b: impl FnOnce() -> R + Send) -> (R, R) {
    if count >= APART { cores::both(a, b) } else { (a(), b()) }
}

/// What can be divided into a near half and a far one.
pub(crate) trait Halves: Send + Sized {
    fn count(&self) -> usize;

    /// The first so many, and the others.
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

/// Both are as long.
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

/// The sum over a whole, from sums `part` over short parts of it and `plus` of two halves.
pub(crate) fn in_halves<W: Halves, S: Send>(
    whole: W,
    part: &(impl Fn(W) -> S + Sync),
    plus: &(impl Fn(S, S) -> S + Sync),
) -> S {
    let count = whole.count();
    if count <= SUMMED_IN_TURN {
        return part(whole);
    }
    let (near, far) = whole.divided(count / 2);
    let (a, b) = both(count, || in_halves(near, part, plus), || in_halves(far, part, plus));
    plus(a, b)
}
