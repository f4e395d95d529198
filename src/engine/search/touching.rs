//! The sticking equilibrium of touching contacts: contacts that pull if they stick are open, and all closed contacts stick.

use super::answer::SearchSolution;
use super::candidate::admit;
use crate::contact::{Mode, State};
use crate::numerics::{chosen, highest, lowest};
use crate::object::{ForcesAndTwist, LinearProblem, Problem};
use crate::prelude::*;

/// Looks for an equilibrium in which some contacts are open and all others stick. It starts from the contact states `states` with the solution
/// `trial`. Contacts that pull are opened, and open contacts that penetrate the object stick again, until no contact pulls or penetrates. Returns the
/// equilibrium reached if it satisfies every condition of its contact states, otherwise `None`.
pub(super) fn touching_contacts(
    problem: &Problem,
    mut states: Vec<State>,
    trial: ForcesAndTwist,
) -> Option<SearchSolution> {
    let mut solved = trial;
    // `linear_problem` is `None` in the first round: the initial contact states have already failed the check, and are not checked again.
    let mut linear_problem = None;
    // With at most 64 contacts, those that pull are opened one at a time, and those that penetrate are closed one at a time. With more contacts, all
    // of them change together.
    let one_by_one = 64;
    // A contact usually changes its state once, if at all. The limit of the number of rounds ends cycles.
    let rounds = if states.len() > one_by_one { 20 } else { 2 * states.len() + 2 };
    for _ in 0..rounds {
        // With at most `one_by_one` contacts a single contact opens in a round: once it is open, other contacts may no longer pull. The contact with
        // the largest initial gap opens first, and the contact that penetrates deepest closes first.
        let reach = |i: usize| problem.offsets[i][0];
        let depth = |i: usize| reach(i) - problem.sites[i].map.tr_mul(&solved.twist)[0];
        let may_open = |i: &usize| problem.local(*i).may_open();
        let pulls = |i: &usize| !states[*i].is_open() && solved.forces[*i][0] < 0.0;
        let penetrates = |i: &usize| states[*i].is_open() && depth(*i) > 0.0;
        let mut changed = chosen(states.len(), &|i| may_open(i) && pulls(i));
        if states.len() <= one_by_one
            && let Some(first) = lowest(&changed, &|i| reach(*i))
        {
            changed = vec![*first];
        }
        let next = if changed.is_empty() { Mode::Sticking } else { Mode::Open };
        if changed.is_empty() {
            changed = chosen(states.len(), &|i| may_open(i) && penetrates(i));
            if states.len() <= one_by_one
                && let Some(first) = highest(&changed, &|i| depth(*i))
            {
                changed = vec![*first];
            }
        }
        if changed.is_empty() {
            return admit(problem, states, &linear_problem?, solved).ok();
        }
        for &i in &changed {
            states[i] = next;
        }
        let changed = linear_problem.insert(LinearProblem::new(problem, &states));
        solved = changed.solve(problem.sites, &problem.offsets, problem.load()).ok()?;
    }
    None
}
