//! Lemke's method proposes contact states, which are solved and checked; on the round cone Newton's method goes on from there.

use super::answer::{Doubt, Found};
use super::candidate::{Verdict, try_states};
use super::enumerate::combinations;
use super::polish::{polish, solution_near};
use super::scene::{Log, Scene};
use super::settings::Settings;
use super::tree::most_cases;
use crate::contact::State;
use crate::forms::Form;
use crate::lcp::{self, Basis, Outcome};
use crate::object::Problem;
use crate::structured;

/// Covering vectors tried after a ray, where trying every combination of states would come next: each path costs as much as
/// the first.
const OTHER_PATHS: usize = 3;
/// The number of those where there are too many contacts to try every combination.
const OTHER_PATHS_AT_MOST: usize = 16;
/// Few enough contacts to try every combination of their states.
pub(super) fn enumerable<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    settings: &Settings,
) -> bool {
    combinations(problem) <= settings.most_states as f64
}

/// One rung: Lemke proposes states, the piece with these states is solved and checked; on the round cone Newton's method goes on
/// from there.
pub(super) fn climb<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    propose: impl Fn(&Problem<D, C>, &mut Log) -> Option<Vec<State<C>>>,
    log: &mut Log,
) -> Option<Found<D, C>> {
    let proposed = propose(problem, log)?;
    if !problem.round {
        return match try_states(problem, proposed) {
            Verdict::Holds(found) => Some(found),
            Verdict::Violated { doubtful: true } => {
                log.doubt = Doubt::OnTheBoundary;
                None
            }
            Verdict::Violated { doubtful: false } | Verdict::Unbalanced => None,
        };
    }
    let near = solution_near(problem, &proposed)?;
    polish(problem, &proposed, &near)
}

/// Contact states from Lemke's method on lists of contact states.
pub(super) fn propose_structured<const D: usize, const C: usize>(
    scene: &Scene<'_, '_, D, C>,
    problem: &Problem<D, C>,
    log: &mut Log,
) -> Option<Vec<State<C>>> {
    let max_pivots = scene.settings.max_pivots;
    let retries = if most_cases(problem, scene.settings) > 0 { 0 } else { OTHER_PATHS };
    let proposal = structured::propose(problem, &scene.trial, &scene.state, retries, max_pivots);
    log.effort.rows = log.effort.rows.max(proposal.pairs);
    log.effort.pivots += proposal.pivots;
    if proposal.cut_short {
        log.doubt = Doubt::OutOfPivots;
    }
    proposal.states
}

/// Contact states from Lemke's method on a complementarity problem with a dense matrix.
pub(super) fn propose_dense<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    settings: &Settings,
    form: impl Fn(&Problem<D, C>) -> Option<Form>,
    states: impl Fn(&Problem<D, C>, &Form, &Basis) -> Vec<State<C>>,
    log: &mut Log,
) -> Option<Vec<State<C>>> {
    let form = form(problem)?;
    log.effort.rows = log.effort.rows.max(form.rows.len());
    // Bases are better enumerated as contact states, where each costs one d x d system and is checked as physics. On the round
    // cone the tree comes next, which knows more than another path would.
    let few = problem.round || enumerable(problem, settings);
    let lcp_settings = lcp::Settings {
        max_pivots: settings.max_pivots,
        retries: if few { OTHER_PATHS } else { OTHER_PATHS_AT_MOST },
        enumerate_up_to: 0,
        ..lcp::Settings::default()
    };
    let outcome = if most_cases(problem, settings) > 0 {
        form.lcp.first_path(&lcp_settings)
    } else {
        form.lcp.solve_with(&lcp_settings)
    };
    match outcome {
        Outcome::Solved(solution) => {
            log.effort.pivots += solution.pivots;
            return Some(states(problem, &form, &solution.basis));
        }
        Outcome::Ray(lcp::Ray { pivots, .. })
        | Outcome::Infeasible(lcp::Certificate { pivots, .. })
        | Outcome::NearlyInfeasible(lcp::Certificate { pivots, .. }) => log.effort.pivots += pivots,
        _ => log.doubt = Doubt::OutOfPivots,
    }
    None
}
