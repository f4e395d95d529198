//! Contact states proposed by Lemke's method. The caller in `search` solves the grasp in these states and checks every condition.

use super::path::{PivotEnd, StatePath};
use crate::contact::State;
use crate::numerics::IntoList;
use crate::object::{Piece, PieceState, Problem};
use crate::prelude::*;

/// The result of a search for contact states, and its cost.
#[derive(Debug, Clone)]
pub(crate) struct Proposal {
    pub(crate) states: Option<Vec<State>>,
    pub(crate) pivots: usize,
    /// The number of complementary pairs of the kinematic form.
    pub(crate) pairs: usize,
    /// Whether a path ended at a limit or a breakdown, not on a ray.
    pub(crate) cut_short: bool,
}

/// Follows Lemke's path on the kinematic form from the trial state. After each failure it follows the path of another
/// covering vector, up to `other_paths` of them. All paths together make at most `max_pivots` pivots or, without that limit, at most `most_work`
/// multiplications.
pub(crate) fn propose(
    problem: &Problem,
    trial: &Piece,
    state: &PieceState,
    other_paths: usize,
    max_pivots: Option<usize>,
    most_work: usize,
) -> Proposal {
    let mut path = StatePath::default();
    let mut x = Vec::with_capacity(3 * problem.len());
    for (local, force) in problem.locals().zip(&state.forces).filter(|(local, _)| !local.is_absent()) {
        x.extend((0..local.springs.axes()).map(|axis| force[axis] / local.springs.root_along(axis)));
    }
    path.form.assign(problem, trial.factor(), &x);
    // Multiplications to evaluate one contact: for each of its pairs a product with the motion of the object.
    let of_an_evaluation = (problem.size().count() * path.form.pairs).div_ceil(problem.len().max(1)).max(1);
    path.most_evaluations = max_pivots.is_none().then_some(most_work / of_an_evaluation);
    let mut proposal = Proposal { states: None, pivots: 0, pairs: path.form.pairs, cut_short: false };
    for attempt in 0..=other_paths {
        let limit = max_pivots.unwrap_or_else(|| path.pivots + path.pivot_limit());
        let end = path.run_from_trial(attempt, limit);
        proposal.pivots = path.pivots;
        match end {
            PivotEnd::Complementary => {
                let states = problem.locals().enumerate().map(|(i, law)| path.state(i, &law));
                proposal.states = Some(states.list());
                return proposal;
            }
            PivotEnd::Ray => {}
            PivotEnd::PivotLimit | PivotEnd::Breakdown => proposal.cut_short = true,
        }
    }
    proposal
}
