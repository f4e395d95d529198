//! The search ladder is a list of methods (rungs) that are tried in turn until one of them finds an equilibrium or proves that there is none. The
//! elastic trial, the solution in which every contact sticks, is tried before the ladder. This file records which method ends each search, for the
//! program `rungs` in `examples/reports`.

use crate::numerics::mapped;

use std::cell::RefCell;
use std::time::Instant;

use super::answer::{Doubt, SearchCounts};
use super::elastic_trial::{Attempt, ElasticTrial, SearchLog};
use super::ladder::LADDER;

/// The result of one method (rung) of the search ladder in one search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RungResult {
    /// The method was not tried: its condition on the problem, such as round cones or many contacts, is not met.
    Untried,
    /// The method found neither an equilibrium nor a proof.
    Nothing,
    /// The method found an equilibrium.
    Found,
    /// The method proved that no equilibrium exists.
    Proved,
}

/// A search for an equilibrium that did not end with the elastic trial. For comparison each method (rung) of the ladder was also run alone on the
/// same problem.
#[derive(Debug, Clone)]
pub struct RecordedSearch {
    /// The index, in [`names`], of the method that found an equilibrium or a proof; `None` if the search stayed undecided.
    pub decided: Option<usize>,
    /// For each method, in the order of [`names`], its result and the time that it took, s. Methods after the one that decided the search were run,
    /// too.
    pub rungs: Vec<(RungResult, f64)>,
}

std::thread_local! {
    static RECORD: RefCell<Option<Vec<RecordedSearch>>> = const { RefCell::new(None) };
}

/// The names of the methods (rungs) of the search ladder, in the order in which they are tried.
#[must_use]
pub fn names() -> Vec<&'static str> {
    mapped(&LADDER, &|rung| rung.name)
}

/// Runs `ask`, a question to a grasp. Returns its answer with a record of all searches for an equilibrium that did not end with the elastic trial.
pub fn recorded<T>(ask: impl FnOnce() -> T) -> (T, Vec<RecordedSearch>) {
    RECORD.set(Some(Vec::new()));
    let answer = ask();
    (answer, RECORD.take().unwrap_or_default())
}

/// If this thread keeps a record, adds a search to it. `decided` is the index of the method that ended the search. For comparison every method whose
/// condition is met is run again, by itself, and timed.
pub(super) fn record(scene: &ElasticTrial<'_, '_>, decided: Option<usize>) {
    if RECORD.with_borrow(Option::is_none) {
        return;
    }
    let mut log =
        SearchLog { effort: SearchCounts::default(), doubt: Doubt::RayWithoutProof, is_infeasible: false };
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
