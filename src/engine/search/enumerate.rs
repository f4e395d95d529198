//! The trial of every combination of contact states: a complete search, which takes acceptable time for a few contacts. A contact is open, sticks, or
//! slides on a facet or at a corner of its friction cone.

use super::answer::SearchSolution;
use super::candidate::CandidateOutcome;
use super::polish::accept;
use crate::contact::State;
use crate::numerics::paired;
use crate::object::Problem;
use crate::prelude::*;

/// The number of combinations of states of all contacts and drives (springs of joints and tendons). It is a floating-point number, since with a few
/// dozen contacts it exceeds the largest integer.
pub(crate) fn combinations(problem: &Problem) -> f64 {
    problem.locals().map(|local| local.states().len() as f64).product()
}

/// Calls `visit` with every combination of states, in a fixed order, until it returns `true`. In the first combination everything sticks.
pub(crate) fn for_each_combination(problem: &Problem, visit: &mut dyn FnMut(Vec<State>) -> bool) {
    let choices = problem.each(|local| local.states());
    let mut at = vec![0; choices.len()];
    loop {
        let states = paired(&choices, &at, &|(choice, &k)| choice[k]);
        if visit(states) {
            return;
        }
        // The next combination, in the order of counting up the digits of a number. The first contact that is not in its last state takes its next
        // state; all contacts before it return to their first state.
        let Some(next) = (0..at.len()).find(|&i| at[i] + 1 < choices[i].len()) else { return };
        at[next] += 1;
        at[..next].fill(0);
    }
}

#[derive(Debug, Clone)]
pub(crate) struct Enumerated {
    pub(crate) found: Vec<SearchSolution>,
    /// Number of combinations tried, without those that the caller's test `may_hold` excludes.
    pub(crate) tried: usize,
    /// True if some combination that was tried broke a condition by so little that rounding may be the cause.
    pub(crate) doubtful: bool,
}

/// Tries all combinations of contact states or, if `first_only` is true, the combinations up to the first equilibrium. On the round cone
/// Newton's method starts from the solution of each combination on polygonal cones, if that solution satisfies every condition.
pub(crate) fn search(problem: &Problem, first_only: bool) -> Enumerated {
    search_among(problem, first_only, &|_| true)
}

/// Tries combinations of contact states as [`search`] does, but only those for which `may_hold` is true.
pub(crate) fn search_among(
    problem: &Problem,
    first_only: bool,
    may_hold: &dyn Fn(&[State]) -> bool,
) -> Enumerated {
    let mut search = Enumerated { found: Vec::new(), tried: 0, doubtful: false };
    for_each_combination(problem, &mut |states| {
        if !may_hold(&states) {
            return false;
        }
        search.tried += 1;
        match accept(problem, states) {
            CandidateOutcome::Holds(found) => {
                search.found.push(found);
                first_only
            }
            CandidateOutcome::Violated { doubtful } => {
                search.doubtful |= doubtful;
                false
            }
            CandidateOutcome::Unbalanced => false,
        }
    });
    search
}
