//! Small changes of the states of many contacts: neighbours of contacts, and states without loose motions.

use crate::contact::{Mode, State};
use crate::object::Problem;
use crate::prelude::*;

/// The contacts that share a coordinate with one of `among`, these included, in order.
pub(super) fn beside(problem: &Problem, among: &[usize]) -> Vec<usize> {
    let felt = |i: usize| problem.sites[i].support.ranges().into_iter().flatten();
    let mut is_near = vec![false; problem.size().count()];
    among.iter().flat_map(|i| felt(*i)).for_each(|k| is_near[k] = true);
    (0..problem.len()).filter(|i| felt(*i).any(|k| is_near[k])).collect()
}

/// The states, with further contacts sticking until no motion is loose. For each loose motion the contact with the largest displacement sticks,
/// among the contacts that do not. `None` if motions are still loose after all rounds.
pub(super) fn regular(problem: &Problem, mut states: Vec<State>) -> Option<Vec<State>> {
    // Most rounds of sticking further contacts before the states are given up.
    for _ in 0..8 {
        let loose = problem.tangent_in_a_band(&|i| states[i])?.loose_motions();
        if loose.is_empty() {
            return Some(states);
        }
        for motion in &loose {
            let moved = |i: usize| {
                let moved = problem.sites[i].map.tr_mul(motion);
                if states[i].is_open() { moved.norm() } else { moved.rows(1, 2).norm() }
            };
            let may_stick = |i: &usize| !states[*i].is_sticking() && !problem.local(*i).is_absent();
            let most = (0..states.len()).filter(may_stick).max_by(|a, b| moved(*a).total_cmp(&moved(*b)))?;
            states[most] = Mode::Sticking;
        }
    }
    None
}
