//! Many questions at once: answers in the order of the questions, the same bits for any number of threads.
//!
//! Every question is answered on its own by the same serial code; threads (feature `parallel`, rayon's global pool) only
//! decide who does which. Besides this room only the sums over very many contacts of one scene (`halves`) know of threads.

mod progress;
mod uncertainty;

pub use progress::{Progress, map_watched};
pub use uncertainty::Uncertainty;

use crate::equilibrium::{Outcome, Settings};
use crate::error::Error;
use crate::grasp::{Grasp, Wrench};
use crate::load_path::{Onset, Ramp};
use crate::screening::{Batch, Part, Pull, Screened};

/// Blocks of scenes that one thread screens in one go.
const BLOCKS: usize = 256;

/// `f` of every item, in order: in parallel with the feature `parallel`, one after the other without it.
pub fn map_in_order<T: Sync, R: Send>(items: &[T], f: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        items.par_iter().map(f).collect()
    }
    #[cfg(not(feature = "parallel"))]
    {
        items.iter().map(f).collect()
    }
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// The equilibria under many loads; an error in one does not stop the rest.
    #[must_use]
    pub fn solve_each(&self, loads: &[Wrench<D>], settings: &Settings) -> Vec<Result<Outcome<D, C>, Error>> {
        map_in_order(loads, |load| self.solve_with(load, settings))
    }

    /// The onsets of sliding along many ramps; an error in one does not stop the rest.
    #[must_use]
    pub fn onset_each(&self, ramps: &[Ramp<D, C>], settings: &Settings) -> Vec<Result<Onset<D, C>, Error>> {
        map_in_order(ramps, |ramp| self.onset(ramp, settings))
    }
}

/// The onsets of sliding of many grasps along one ramp; an error in one does not stop the rest.
#[must_use]
pub fn onset_of_each<const D: usize, const C: usize>(
    grasps: &[Grasp<D, C>],
    ramp: &Ramp<D, C>,
    settings: &Settings,
) -> Vec<Result<Onset<D, C>, Error>> {
    map_in_order(grasps, |grasp| grasp.onset(ramp, settings))
}

/// When the first contact of each grasp of a batch leaves rolling as each of the loads grows: [`Batch::onsets_into`] on all cores. `answers` is
/// cleared first; its memory is used again.
pub fn onsets_of_batch<const D: usize, const C: usize, const N: usize>(
    batch: &Batch<D, C, N>,
    pulls: &[Pull<D>],
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
