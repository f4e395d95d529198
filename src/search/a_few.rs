//! Of many contacts few leave the state of the elastic trial: Lemke's method pivots on these alone.
//!
//! Contacts that break a condition in the trial are let go of, and all others stay as they are. With the states that this gives others may break one: they
//! join, until none does.

use super::candidate::breaking;
use super::proposals::propose_dense;
use super::scene::{Log, TrialScene};
use crate::contact::State;
use crate::forms::{Moved, kinematic_form_among, kinematic_states};
use crate::numerics::Size;
use crate::object::{Piece, Problem};

/// How often others may join: a disturbance spreads from contact to contact, and fades.
const ROUNDS: usize = 32;
/// Multiplications that one path may take where the caller sets no limit on pivots: some seconds, where any other way takes minutes.
const MOST_WORK: usize = 10_000_000_000;

/// States in which no contact breaks a condition, if this leads to any.
pub(super) fn propose_of_a_few<D: Size, const C: usize>(
    scene: &TrialScene<'_, '_, D, C>,
    problem: &Problem<D, C>,
    log: &mut Log,
) -> Option<Vec<State<C>>> {
    let mut among = breaking(problem, &scene.unjumped, &scene.state);
    let mut moved = Moved::default();
    for _ in 0..ROUNDS {
        among.sort_unstable();
        let form = kinematic_form_among(problem, &scene.trial, &scene.state, &among, &mut moved)?;
        let states = propose_dense(problem, scene.settings, (Some(form), MOST_WORK), kinematic_states, log)?;
        let at = Piece::new(problem, &states).solve(problem.sites, &problem.drives, problem.load()).ok()?;
        let joins: Vec<_> =
            breaking(problem, &states, &at).into_iter().filter(|i| among.binary_search(i).is_err()).collect();
        if joins.is_empty() {
            return Some(states);
        }
        among.extend(joins);
    }
    None
}
