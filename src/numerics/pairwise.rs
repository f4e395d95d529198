//! Sums over very many terms, made of halves. Their rounding grows with the logarithm of their
//! length only, and they are the same for any number of threads.

use std::ops::Range;

/// Terms that are summed one after the other: fewer would cost more calls than digits are worth.
pub(crate) const SUMMED_IN_TURN: usize = 256;
/// Terms that are worth a second thread: with fewer, waking it costs more than their sum.
#[cfg(feature = "parallel")]
const APART: usize = 4096;

/// Both results, on two threads if the work on so many contacts is worth it.
pub(crate) fn both<R: Send>(
    count: usize,
    a: impl FnOnce() -> R + Send,
    b: impl FnOnce() -> R + Send,
) -> (R, R) {
    #[cfg(feature = "parallel")]
    if count >= APART {
        return rayon::join(a, b);
    }
    let _ = count;
    (a(), b())
}

/// The sum over a range, from sums `part` over short ranges and `plus` of two halves.
pub(crate) fn in_halves<S: Send>(
    range: Range<usize>,
    part: &(impl Fn(Range<usize>) -> S + Sync),
    plus: &(impl Fn(S, S) -> S + Sync),
) -> S {
    if range.len() <= SUMMED_IN_TURN {
        return part(range);
    }
    let middle = range.start.midpoint(range.end);
    let (near, far) = (range.start..middle, middle..range.end);
    let (a, b) = both(range.len(), || in_halves(near, part, plus), || in_halves(far, part, plus));
    plus(a, b)
}
