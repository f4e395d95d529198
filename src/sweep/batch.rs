//! Batches of small grasps screened on all cores.

use crate::numerics::each_taken;
use crate::screening::{
    Batch, LoadCases, Part, Pull, Screened, ScreenedSqueeze, ScreenedTurn, ScreeningQuestion, TurningPull,
};

/// Blocks of scenes that one thread screens in one go. Blocks are four or eight scenes: far more
/// work than handing it out, and small enough that every core gets some of a batch of ten thousand.
const BLOCKS: usize = 256;

/// When the first contact of each grasp of a batch stops sticking as each of the loads grows:
/// [`Batch::onsets_into`] on all cores. The answers come grasp by grasp, for each in the order of
/// the loads. What `answers` held before is lost; its memory is used again. [`Batch`] has an example.
pub fn onsets_of_batch<const D: usize, const C: usize, const N: usize>(
    batch: &Batch<D, C, N>,
    pulls: &[Pull<C>],
    answers: &mut Vec<Screened>,
) {
    ask(batch, pulls, answers);
}

/// At which angle the first contact of each grasp of a batch stops sticking while each of the loads
/// turns: [`Batch::turn_onsets_into`] on all cores. Answers come as from [`onsets_of_batch`].
pub fn turn_onsets_of_batch<const D: usize, const C: usize, const N: usize>(
    batch: &Batch<D, C, N>,
    turns: &[TurningPull<C>],
    answers: &mut Vec<ScreenedTurn>,
) {
    ask(batch, turns, answers);
}

/// The least factor of the commands with which each grasp of a batch holds every load of a list, for
/// each of the lists: [`Batch::least_squeezes_into`] on all cores. Answers come as from
/// [`onsets_of_batch`].
pub fn least_squeezes_of_batch<const D: usize, const C: usize, const N: usize>(
    batch: &Batch<D, C, N>,
    cases: &[LoadCases<C>],
    answers: &mut Vec<ScreenedSqueeze>,
) {
    ask(batch, cases, answers);
}

fn ask<const D: usize, const C: usize, const N: usize, Q: ScreeningQuestion<D, C>>(
    batch: &Batch<D, C, N>,
    questions: &[Q],
    answers: &mut Vec<Q::Answer>,
) {
    let parts = batch.parts(questions, BLOCKS, answers);
    each_taken(parts, &Part::screen);
}
