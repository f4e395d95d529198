//! The sticking equilibrium of what touches: contacts that would pull are open, and everything closed sticks.

use super::answer::Found;
use super::candidate::admit;
use crate::contact::{Mode, State};
use crate::numerics::Size;
use crate::object::{Piece, PieceState, Problem};
use crate::prelude::*;

/// With more contacts all that pull let go together.
const ONE_BY_ONE: usize = 64;
/// How often they may.
const ROUNDS: usize = 20;

/// From these states and their solution on: opens contacts that pull and closes contacts that penetrate, until neither are left.
/// The result is accepted if it satisfies every condition. A finger far out of reach is thus no reason to return another
/// equilibrium than without it.
pub(super) fn touching_contacts<D: Size, const C: usize>(
    problem: &Problem<D, C>,
    mut states: Vec<State<C>>,
    trial: PieceState<D, C>,
) -> Option<Found<D, C>> {
    let mut solved = trial;
    // In the first round these are the states that have failed before.
    let mut piece = None;
    let mut changed = Vec::new();
    // Every contact usually changes once; the bound ends those that would go in circles.
    let rounds = if states.len() > ONE_BY_ONE { ROUNDS } else { 2 * states.len() + 2 };
    for _ in 0..rounds {
        // Few contacts let go one at a time: a contact that pulls makes others pull that will not when it has let go. The first is
        // the one that is farthest from the object before anything moves.
        let reach = |i: usize| problem.drives[i][0];
        let depth = |i: usize| reach(i) - problem.sites[i].map.tr_mul(&solved.twist)[0];
        let may_open = |i: &usize| problem.local(*i).may_open();
        let pulls = |i: &usize| !states[*i].is_open() && solved.forces[*i][0] < 0.0;
        let penetrates = |i: &usize| states[*i].is_open() && depth(*i) > 0.0;
        changed.clear();
        changed.extend((0..states.len()).filter(may_open).filter(pulls));
        if states.len() <= ONE_BY_ONE
            && let Some(first) = changed.iter().copied().min_by(|&i, &j| reach(i).total_cmp(&reach(j)))
        {
            changed = vec![first];
        }
        let next = if changed.is_empty() { Mode::Sticking } else { Mode::Open };
        if changed.is_empty() {
            changed.extend((0..states.len()).filter(may_open).filter(penetrates));
            if states.len() <= ONE_BY_ONE
                && let Some(first) = changed.iter().copied().max_by(|&i, &j| depth(i).total_cmp(&depth(j)))
            {
                changed = vec![first];
            }
        }
        if changed.is_empty() {
            return admit(problem, states, &piece?, solved).ok();
        }
        for &i in &changed {
            states[i] = next;
        }
        let changed = piece.insert(Piece::new(problem, &states));
        solved = changed.solve(problem.sites, &problem.drives, problem.load()).ok()?;
    }
    None
}
