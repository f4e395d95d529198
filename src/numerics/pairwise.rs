//! Sums over very many contacts, made of halves: their rounding grows with the logarithm of their length only, and they are the same for any number of
//! threads.

/// Contacts that are summed one after the other,
pub(crate) const SUMMED_IN_TURN: usize = 256;
/// and those that are worth a second thread.
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
