//! From a solution with polygonal friction cones to a solution with round cones: Newton's method on the twist, then a solution in the contact states
//! found, accurate to the last digits.
//!
//! A few steps of Newton's method ([`newton_on_cones`](crate::object::newton_on_cones)) start from the twist of the solution with polygonal cones.
//! They lead to the states of the contacts on the round cones. If every contact keeps its state, the contact laws are linear. The solution of this
//! linear problem gives the last digits ([`super::round_pieces`]). If stiffnesses differ so widely that the twist does not determine the forces,
//! these steps fail. Newton's method in forces and twist together then starts from the contact states of the solution with polygonal cones.

use super::answer::SearchSolution;
use super::candidate::{CandidateOutcome, try_states};
use super::round_pieces::RoundPieces;
use crate::contact::State;
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{IntoList, PartialPivoting, Reals, Vector, paired};
use crate::object::{ForcesAndTwist, LinearProblem, Problem, balance, tangent_stiffness};
use crate::prelude::*;

/// Checks proposed contact states: their solution with polygonal friction cones must satisfy every condition. With round cones Newton's method
/// continues from that solution, and must converge.
pub(super) fn accept(problem: &Problem, states: Vec<State>) -> CandidateOutcome {
    if !problem.round {
        return try_states(problem, states);
    }
    match try_states(problem, states) {
        CandidateOutcome::Holds(found) => {
            let near = ForcesAndTwist { forces: found.forces, twist: found.twist };
            polish(problem, &found.states, &near)
                .map_or(CandidateOutcome::Violated { doubtful: false }, CandidateOutcome::Holds)
        }
        other => other,
    }
}

/// The start for Newton's method on the round cone: the solution of the linear problem with these contact states on polygonal friction cones. This
/// solution may break inequalities of the contact states, such as F_n >= 0. `None` if no forces in these contact states balance the load.
pub(crate) fn solution_near(problem: &Problem, states: &[State]) -> Option<ForcesAndTwist> {
    if let Some(near) = regular_solution(problem, states) {
        return Some(near);
    }
    match try_states(problem, states.to_vec()) {
        CandidateOutcome::Holds(found) => Some(ForcesAndTwist { forces: found.forces, twist: found.twist }),
        CandidateOutcome::Violated { .. } => {
            LinearProblem::new(problem, states).solve(problem.sites, &problem.offsets, problem.load()).ok()
        }
        CandidateOutcome::Unbalanced => None,
    }
}

/// The solution of the linear problem with these contact states. `None` if the tangent stiffness is singular, or so ill-conditioned that Newton steps
/// do not reach balance of forces and load.
fn regular_solution(problem: &Problem, states: &[State]) -> Option<ForcesAndTwist> {
    let springs: Vec<_> =
        problem.locals().zip(states).map(|(local, state)| local.tangent(state).matrix()).list();
    let tangent = PartialPivoting::new(&tangent_stiffness(problem.sites, &|i| springs[i]))?;
    let forces = paired(&springs, &problem.offsets, &|(springs, offset)| springs * offset);
    let mut near = ForcesAndTwist { forces, twist: Vector::zeros() };
    // The solution is refined by Newton steps until the imbalance is at most the fraction `SOLVED_ROUNDING` of the forces. This is accurate enough
    // for a start of Newton's method on round cones.
    balance(problem.sites, &springs, &tangent, &problem.wrench, &mut near, SOLVED_ROUNDING)?;
    Some(near)
}

/// The solution on the round cone at which Newton's method ends if it starts from a twist; `None` if it does not converge.
pub(super) fn polish_from(problem: &Problem, twist: Vector) -> Option<SearchSolution> {
    RoundPieces::by_newton(problem, twist)?.solve(problem)
}

/// The solution with round friction cones that is found from `near`, a solution with polygonal cones in the contact states `states`. Newton's method
/// starts from the twist of `near` and, if that fails, from the contact states. `None` if both starts fail.
pub(crate) fn polish(problem: &Problem, states: &[State], near: &ForcesAndTwist) -> Option<SearchSolution> {
    let found = RoundPieces::by_newton(problem, near.twist.clone())
        .and_then(|arrived| arrived.solve(problem))
        .or_else(|| RoundPieces::on_polygons(problem, states, near).solve(problem))?;
    let change = found.forces.iter().zip(&near.forces).map(|(round, polygon)| (round - polygon).norm());
    Some(SearchSolution { from_polygon: Some(change.most()), ..found })
}
