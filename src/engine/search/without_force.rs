//! Contacts that touch without force neither stick nor slide. They are reported as open, with a gap of zero.
//!
//! Whether the search finds such a contact sticking, sliding or open depends on the rounding of its force. Friction without normal force holds
//! nothing. Hence the solution with all such contacts open has the same forces, and always this solution is returned.

use nalgebra::Matrix;

use super::answer::{SearchCounts, SearchOutcome, SearchSolution};
use super::ladder::settle;
use super::least_motion::at_the_least_motion;
use super::settings::Settings;
use super::solution_interval::on_the_solution_interval;
use crate::contact::{ActiveSet, Mode, WEIGHTLESS};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Reals, largest};
use crate::object::{ForcesAndTwist, LinearProblem, Problem};

/// Searches for an equilibrium of a static problem. In the solution that is returned, all contacts without force that may open are open.
pub(crate) fn settle_at_rest(problem: &Problem, settings: &Settings) -> (SearchOutcome, SearchCounts) {
    match settle(problem, settings) {
        (SearchOutcome::Found(found, rung), effort) => {
            let found = match opened(problem, &found) {
                Some(open) => at_the_least_motion(problem, open),
                None => found,
            };
            (SearchOutcome::Found(found, rung), effort)
        }
        other => other,
    }
}

/// The solution `found` of a static problem, as answers report it: contacts without force are open, and motions that nothing resists are listed. The
/// twist is that of `found`. So are the rounding scales `sizes`, the force and the displacement to which rounding errors are proportional.
pub(crate) fn reported_at_rest(problem: &Problem, found: SearchSolution) -> SearchSolution {
    let open = opened(problem, &found).unwrap_or_else(|| found.clone());
    let shown = on_the_solution_interval(problem, open);
    SearchSolution { twist: found.twist, sizes: found.sizes, ..shown }
}

/// The solution with the same forces in which all contacts without force are open. `None` if there is no such contact, or if forces change or
/// contacts overlap once they are open. Also `None` if no contact carries a force: there is then no force with which a small force could be compared.
fn opened(problem: &Problem, found: &SearchSolution) -> Option<SearchSolution> {
    let largest = largest(&found.forces, &Matrix::norm);
    // Gaps are compared with the largest displacement of all contacts, since the displacement of a single contact may be zero.
    let spans = (0..problem.len()).map(|i| problem.span(i, &found.twist));
    let farthest = spans.most();
    let mut states = found.states.clone();
    let (mut any, mut some_press) = (false, false);
    for (i, state) in states.iter_mut().enumerate().filter(|(_, state)| !state.is_open()) {
        if !ActiveSet::is_weightless(&found.forces[i], largest) {
            some_press = true;
        } else if problem.local(i).may_open() {
            (*state, any) = (Mode::Open, true);
        }
    }
    if !(any && some_press) {
        return None;
    }
    let gap_is_none = |i: usize| -problem.stretch(i, &found.twist)[0] >= -WEIGHTLESS * farthest;
    let opens = |i: &usize| states[*i].is_open() && !found.states[*i].is_open();
    if !(0..states.len()).filter(opens).all(gap_is_none) {
        return None;
    }
    let linear_problem = LinearProblem::new(problem, &states);
    let ForcesAndTwist { forces, .. } =
        linear_problem.solve(problem.sites, &problem.offsets, problem.load()).ok()?;
    // Forces that differ by at most the fraction `NEGLIGIBLE` of the largest force are the same.
    let are_the_same = forces.iter().zip(&found.forces).all(|(f, g)| (f - g).norm() <= NEGLIGIBLE * largest);
    let free_motions = linear_problem.free_motions().to_vec();
    let neutral_motions = linear_problem.neutral_motions();
    are_the_same.then(|| SearchSolution { states, forces, free_motions, neutral_motions, ..found.clone() })
}
