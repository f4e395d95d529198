//! Contact states (open, sticking, sliding) proposed by Lemke's method. If every contact keeps its proposed state, the contact laws are linear
//! equations, whose solution is checked. On the round cone Newton's method refines the solution first.

use super::answer::{Doubt, SearchSolution};
use super::candidate::{CandidateOutcome, try_states};
use super::elastic_trial::SearchLog;
use super::enumerate::combinations;
use super::polish::{polish, solution_near};
use super::settings::Settings;
use super::tolerances::{COVERING_VECTORS, MANY_CONTACTS, MOST_WORK};
use super::tree::most_cases;
use crate::contact::State;
use crate::forms::Form;
use crate::lcp::{self, Basis, Outcome};
use crate::object::Problem;
use crate::prelude::*;

/// Whether Lemke's method takes acceptable time on a dense matrix. The matrix has `times` times as many rows as that of the kinematic form, the
/// complementarity problem for gaps and slips. The work grows with the cube of the number of rows: there are about as many pivots as rows, and each
/// pivot changes the whole matrix.
pub(crate) fn dense_is_affordable(problem: &Problem, times: usize) -> bool {
    let rows = problem.locals().map(|local| local.pairs()).sum::<usize>();
    (times * rows).pow(3) <= MOST_WORK
}

/// Whether there are at most [`Settings::most_states`] combinations of contact states, so that all of them may be tried.
pub(super) fn enumerable(problem: &Problem, settings: &Settings) -> bool {
    combinations(problem) <= settings.most_states as f64
}

/// A method that proposes contact states; `None` if it has none to propose.
type ProposalMethod<'p> = dyn Fn(&Problem, &mut SearchLog) -> Option<Vec<State>> + 'p;

/// Lets `propose` propose contact states. If every contact keeps its proposed state, the contact laws are linear; this linear problem is solved, and
/// its solution checked. On the round cone Newton's method continues from this solution. `None` if no solution passes the check.
pub(super) fn equilibrium_by_proposals(
    problem: &Problem,
    propose: &ProposalMethod<'_>,
    log: &mut SearchLog,
) -> Option<SearchSolution> {
    let proposed = propose(problem, log)?;
    if !problem.round {
        return match try_states(problem, proposed) {
            CandidateOutcome::Holds(found) => Some(found),
            CandidateOutcome::Violated { doubtful: true } => {
                log.doubt = Doubt::OnTheBoundary;
                None
            }
            CandidateOutcome::Violated { doubtful: false } | CandidateOutcome::Unbalanced => None,
        };
    }
    let near = solution_near(problem, &proposed)?;
    polish(problem, &proposed, &near)
}

/// Contact states from Lemke's method on the complementarity problem `form`, whose matrix is dense. `most_work` is an upper limit of the number of
/// multiplications, and `states` translates the basis of a solution (the set of its basic variables) to contact states. `None` if no solution is
/// found.
pub(super) fn propose_dense(
    problem: &Problem,
    settings: &Settings,
    (form, most_work): (Option<Form>, usize),
    states: fn(&Problem, &Form, &Basis) -> Vec<State>,
    log: &mut SearchLog,
) -> Option<Vec<State>> {
    log.is_infeasible = false;
    let form = form?;
    log.effort.rows = log.effort.rows.max(form.rows.len());
    // The solver may run Lemke's method more than once, but it never tries all bases: the search tries all combinations of contact states later, at
    // less cost. If branch and bound over contact states comes later instead, Lemke's method runs once. Branch and bound more often finds an
    // equilibrium or a proof than another run does.
    let affordable = settings.max_pivots.unwrap_or(most_work / form.rows.len().pow(2).max(1));
    let by_size = lcp::Settings::one_path();
    // The solver is given the limit `affordable` of the number of pivots for one of two reasons: the caller set it, or it is below the solver's own
    // limit.
    let bounds = settings.max_pivots.is_some() || affordable < by_size.pivot_limit(form.rows.len());
    let one_path = lcp::Settings { max_pivots: bounds.then_some(affordable), ..by_size };
    let lcp_settings = if most_cases(problem, settings) > 0 {
        one_path
    } else {
        let few = problem.round || enumerable(problem, settings);
        // If Lemke's method ends on a ray, it may run again, each time with another covering vector (the vector along which it starts). Three such
        // runs are allowed if the cones are round, or if all combinations of contact states can be tried next. Otherwise 16 are allowed.
        let retries = if few { COVERING_VECTORS } else { 16 };
        // All runs of Lemke's method together may cost no more than `most_work` multiplications.
        let paths = most_work / form.rows.len().pow(3).max(1);
        let retries = paths.saturating_sub(1).min(retries);
        lcp::Settings { prove_infeasible: problem.len() < MANY_CONTACTS, retries, ..one_path }
    };
    match form.lcp.solve_with(&lcp_settings) {
        Outcome::Solved(solution) => {
            log.effort.pivots += solution.pivots;
            return Some(states(problem, &form, &solution.basis));
        }
        Outcome::Ray(lcp::Ray { pivots, .. }) => log.effort.pivots += pivots,
        Outcome::Infeasible(lcp::Certificate { pivots, .. })
        | Outcome::NearlyInfeasible(lcp::Certificate { pivots, .. }) => {
            (log.is_infeasible, log.effort.pivots) = (true, log.effort.pivots + pivots);
        }
        _ => log.doubt = Doubt::OutOfPivots,
    }
    None
}
