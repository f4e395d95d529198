//! Batches of small grasps screened on all cores.

use crate::screening::{Batch, Part, Pull, Screened};

/// Blocks of scenes that one thread screens in one go. Blocks are four or eight scenes: far more
/// work than handing it out, and small enough that every core gets some of a batch of ten thousand.
const BLOCKS: usize = 256;

/// When the first contact of each grasp of a batch leaves rolling as each of the loads grows:
/// [`Batch::onsets_into`] on all cores. The answers come grasp by grasp, for each in the order of
/// the loads. `answers` is cleared first; its memory is used again. [`Batch`] has an example.
pub fn onsets_of_batch<const D: usize, const C: usize, const N: usize>(
    batch: &Batch<D, C, N>,
    pulls: &[Pull<D, C>],
    answers: &mut Vec<Screened>,
) {
    let parts = batch.parts(pulls, BLOCKS, answers);
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        let parts: Vec<_> = parts.collect();
        parts.into_par_iter().for_each(Part::screen);
    }
    #[cfg(not(feature = "parallel"))]
    parts.for_each(Part::screen);
}
