//! A solution may be one end of an interval of solutions with equal forces. The motion along such an interval is then added to its free motions, i.e.
//! motions that no spring resists.
//!
//! If friction is at its limit at every contact that could resist a motion, forces do not determine the object's position along this motion. The
//! possible positions form an interval. At one end of it, one of these contacts has not slipped yet, and may be taken as sticking. The solution with
//! this contact sticking satisfies every condition, but has no free motion. A force at the limit of friction is on the boundary of the friction cone
//! (`edge` in code names).

use nalgebra::SVector;

use super::answer::SearchSolution;
use super::candidate::{CandidateOutcome, try_states};
use super::least_motion::at_the_least_motion;
use crate::contact::{Line, Mode, State, WEIGHTLESS};
use crate::grasp::Space;
use crate::numerics::largest;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::object::Problem;
use crate::prelude::*;

/// In the plane, looks for a solution with the same forces as `found`, but with a further free motion. The contact states tried are those of `found`,
/// except that contacts on the boundary of their cone slide, and contacts without force are open. Returns `found` itself if these contact states
/// break a condition, change a force or give no further free motion. In space `found` is always returned.
pub(crate) fn on_the_solution_interval(problem: &Problem, found: SearchSolution) -> SearchSolution {
    // In space a contact that slides still has a tangential spring perpendicular to its slip, which resists, so that no motion becomes free. If
    // `near` has contact states of a similar grasp, from which the search starts, free motions are not looked for.
    if problem.space() == Space::Spatial || !problem.near.is_empty() {
        return found;
    }
    let Some(states) = yielding(problem, &found) else { return found };
    let largest = problem.largest_force(&found.forces, &found.twist);
    // Forces that differ by at most the fraction `NEGLIGIBLE` of the largest force are equal.
    let are_the_same = |other: &SearchSolution| {
        found.forces.iter().zip(&other.forces).all(|(f, g)| (f - g).norm() <= NEGLIGIBLE * largest)
    };
    let free = |other: &SearchSolution| other.free_motions.len();
    match try_states(problem, states) {
        CandidateOutcome::Holds(other) if free(&other) > free(&found) && are_the_same(&other) => {
            at_the_least_motion(problem, other)
        }
        _ => found,
    }
}

/// The contact states of the solution `found`, except that sticking contacts without force open, and sticking contacts on the boundary of their cone
/// slide. `None` if no contact changes its state.
fn yielding(problem: &Problem, found: &SearchSolution) -> Option<Vec<State>> {
    let largest = largest(&found.forces, &SVector::norm).max(problem.wrench.norm());
    let mut states = found.states.clone();
    let mut any = false;
    for (i, state) in states.iter_mut().enumerate().filter(|(_, state)| state.is_sticking()) {
        let (local, force) = (problem.local(i), found.forces[i]);
        let size = local.force_size(&force, problem.span(i, &found.twist), largest);
        let yields = if force.norm() <= WEIGHTLESS * size {
            local.may_open().then_some(Mode::Open)
        } else {
            let line = Line { force, rate: SVector::zeros(), force_size: size, rate_size: 0.0 };
            local.on_its_edge(&line)
        };
        if let Some(yields) = yields {
            (*state, any) = (yields, true);
        }
    }
    any.then_some(states)
}
