//! Batches of small grasps screened on all cores.

use crate::screening::{Batch, LoadCases, Pull, Screened, ScreenedSqueeze, ScreenedTurn, TurningPull};

/// When the first contact of each grasp of a batch stops sticking as each of the loads grows:
/// [`Batch::onsets_into`] on all cores. The answers come grasp by grasp, for each in the order of
/// the loads. What `answers` held before is lost; its memory is used again. [`Batch`] has an example.
pub fn onsets_of_batch<const D: usize, const C: usize, const N: usize>(
    batch: &Batch<D, C, N>,
    pulls: &[Pull<C>],
    answers: &mut Vec<Screened>,
) {
    batch.onsets_on_all_cores(pulls, answers);
}

/// At which angle the first contact of each grasp of a batch stops sticking while each of the loads
/// turns: [`Batch::turn_onsets_into`] on all cores. Answers come as from [`onsets_of_batch`].
pub fn turn_onsets_of_batch<const D: usize, const C: usize, const N: usize>(
    batch: &Batch<D, C, N>,
    turns: &[TurningPull<C>],
    answers: &mut Vec<ScreenedTurn>,
) {
    batch.turn_onsets_on_all_cores(turns, answers);
}

/// The least factor of the commands with which each grasp of a batch holds every load of a list, for
/// each of the lists: [`Batch::least_squeezes_into`] on all cores. Answers come as from
/// [`onsets_of_batch`].
pub fn least_squeezes_of_batch<const D: usize, const C: usize, const N: usize>(
    batch: &Batch<D, C, N>,
    cases: &[LoadCases<C>],
    answers: &mut Vec<ScreenedSqueeze>,
) {
    batch.least_squeezes_on_all_cores(cases, answers);
}
