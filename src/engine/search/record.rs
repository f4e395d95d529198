//! A record of which rung of the ladder decides each search, for the report `rungs`.

use crate::numerics::mapped;

use std::cell::RefCell;
use std::time::Instant;

use super::answer::{Doubt, Effort};
use super::elastic_trial::{Attempt, ElasticTrial, Log};
use super::ladder::LADDER;

/// The result of one rung in one search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RungResult {
    /// The rung does not apply to the search.
    Untried,
    /// The rung found neither an equilibrium nor a proof.
    Nothing,
    /// The rung found an equilibrium.
    Found,
    /// The rung proved that no equilibrium exists.
    Proved,
}

/// One search, with the result of each rung tried alone.
#[derive(Debug, Clone)]
pub struct RecordedSearch {
    /// The index of the rung that decided; `None` if the search stayed undecided.
    pub decided: Option<usize>,
    /// The result of each rung, and its time, s.
    pub rungs: Vec<(RungResult, f64)>,
}

std::thread_local! {
    static RECORD: RefCell<Option<Vec<RecordedSearch>>> = const { RefCell::new(None) };
}

/// The names of the rungs, in the order in which they are tried.
#[must_use]
pub fn names() -> Vec<&'static str> {
    mapped(&LADDER, &|rung| rung.name)
}

/// Asks a question, and returns with its answer all of its searches that went beyond the elastic trial.
pub fn recorded<T>(ask: impl FnOnce() -> T) -> (T, Vec<RecordedSearch>) {
    RECORD.set(Some(Vec::new()));
    let answer = ask();
    (answer, RECORD.take().unwrap_or_default())
}

/// Records a search and the rung that decided it, if this thread keeps a record. For this every rung that applies is tried once more, alone.
pub(super) fn record(scene: &ElasticTrial<'_, '_>, decided: Option<usize>) {
    if RECORD.with_borrow(Option::is_none) {
        return;
    }
    let mut log = Log { effort: Effort::default(), doubt: Doubt::RayWithoutProof, is_infeasible: false };
    let mut rungs = Vec::with_capacity(LADDER.len());
    for rung in &LADDER {
        let start = Instant::now();
        let made = match (rung.applies)(scene).then(|| (rung.climb)(scene, &mut log)) {
            None => RungResult::Untried,
            Some(Attempt::Nothing) => RungResult::Nothing,
            Some(Attempt::Found(_)) => RungResult::Found,
            Some(Attempt::Proof(_)) => RungResult::Proved,
        };
        rungs.push((made, start.elapsed().as_secs_f64()));
    }
    RECORD.with_borrow_mut(|record| {
        if let Some(climbs) = record {
            climbs.push(RecordedSearch { decided, rungs });
        }
    });
}
