//! A question to the scenes of a block.

use super::block::{Block, Parted};
use super::ready::Ready;

/// What is asked of every scene alike.
pub(crate) trait Question<const D: usize, const C: usize>: Sync {
    type Answer: Copy + Send;
    /// Before it is asked.
    const UNKNOWN: Self::Answer;
    /// Must be inlined for the caller's vectors to be used. Arguments are passed apart: in one value
    /// they would be copied for every block.
    fn ask<const N: usize, const L: usize>(
        &self,
        ready: &Ready<D, C, N, L>,
        block: &Block<C, N, L>,
        parted: &Parted<N, L>,
    ) -> [Self::Answer; L];
}
