//! Of many contacts few leave the state of the elastic trial: Lemke's method pivots on these alone.
//!
//! Contacts that break a condition are let go of, and all others stay as they are. With the states that this gives others may break one: they
//! join, until none does. Where many leave the trial, states by friction with given limits come nearer, and what breaks a condition there is a few again.

use alloc::sync::Arc;

use super::candidate::breaking;
use super::near_states::{beside, regular};
use super::proposals::{MOST_WORK, propose_dense};
use super::scene::{Log, TrialScene};
use super::settings::Settings;
use crate::contact::State;
use crate::forms::{Moved, kinematic_form_among, kinematic_states};
use crate::numerics::Size;
use crate::object::{Piece, PieceState, Problem, states_by_given_limits};
use crate::prelude::*;

/// How often others may join: a disturbance spreads from contact to contact, and fades.
const ROUNDS: usize = 32;
/// Multiplications that one path may take where the caller sets no limit on pivots: some seconds, where any other way takes minutes.
const MOST_WORK_OF_A_FEW: usize = MOST_WORK.saturating_mul(20);
/// If so many leave the trial nearer states are looked for: a path takes as long as the cube of their number.
const MANY_LEAVE: usize = 128;
/// With more contacts than these a path from nearer states is none of a few.
const MOST_BESIDE: usize = 400;

/// States that stay for all but a few contacts, which stick in them.
struct Base<D: Size, const C: usize> {
    states: Vec<State<C>>,
    piece: Arc<Piece<D, C>>,
    at: PieceState<D, C>,
}

impl<D: Size, const C: usize> Base<D, C> {
    /// With these states; `None` where they do not balance the load.
    fn of(problem: &Problem<D, C>, states: Vec<State<C>>) -> Option<Self> {
        let piece = problem.piece(&states);
        let at = piece.solve(problem.sites, &problem.drives, problem.load()).ok()?;
        Some(Self { states, piece, at })
    }

    /// The same with these contacts sticking; itself if they do. `None` where that leaves something loose.
    fn sticking_at(self, problem: &Problem<D, C>, among: &[usize], moved: &mut Moved) -> Option<Self> {
        let mut states = self.states.clone();
        for i in among {
            states[*i] = problem.local(*i).unjumped();
        }
        if states == self.states {
            return Some(self);
        }
        *moved = Moved::default();
        problem.tangent_in_a_band(&|i| states[i])?.is_regular().then(|| Self::of(problem, states))?
    }
}

/// States in which no contact breaks a condition, if this leads to any.
pub(super) fn propose_of_a_few<D: Size, const C: usize>(
    scene: &TrialScene<'_, '_, D, C>,
    problem: &Problem<D, C>,
    log: &mut Log,
) -> Option<Vec<State<C>>> {
    let leaving = breaking(problem, &scene.unjumped, &scene.state);
    if leaving.len() >= MANY_LEAVE
        && let Some(near) = states_by_given_limits(problem).and_then(|near| regular(problem, near))
        && let Some(base) = Base::of(problem, near)
    {
        let among = breaking(problem, &base.states, &base.at);
        if among.is_empty() {
            return Some(base.states);
        }
        if let Some(states) = pivoted(problem, scene.settings, (base, among, MOST_BESIDE), log) {
            return Some(states);
        }
    }
    let (states, piece, at) = (scene.unjumped.clone(), scene.trial.clone(), scene.state.clone());
    pivoted(problem, scene.settings, (Base { states, piece, at }, leaving, 0), log)
}

/// States from a path among a few contacts. If it has no end those beside them join, as long as they are no more than `most`.
fn pivoted<D: Size, const C: usize>(
    problem: &Problem<D, C>,
    settings: &Settings,
    (mut base, mut among, most): (Base<D, C>, Vec<usize>, usize),
    log: &mut Log,
) -> Option<Vec<State<C>>> {
    let mut moved = Moved::default();
    for _ in 0..ROUNDS {
        among.sort_unstable();
        base = base.sticking_at(problem, &among, &mut moved)?;
        let form = kinematic_form_among(problem, &base.piece, &base.at, &among, &mut moved)?;
        let proposed =
            propose_dense(problem, settings, (Some(form), MOST_WORK_OF_A_FEW), kinematic_states, log);
        let Some(mut states) = proposed else {
            among = beside(problem, &among);
            if among.len() > most {
                return None;
            }
            continue;
        };
        let is_among = |i: &usize| among.binary_search(i).is_ok();
        (0..states.len()).filter(|i| !is_among(i)).for_each(|i| states[i] = base.states[i]);
        let at = Piece::new(problem, &states).solve(problem.sites, &problem.drives, problem.load()).ok()?;
        let joins: Vec<_> = breaking(problem, &states, &at).into_iter().filter(|i| !is_among(i)).collect();
        if joins.is_empty() {
            return Some(states);
        }
        among.extend(joins);
    }
    None
}
