//! From one straight piece to the next: the guess that mostly holds, other ways to go on, and what changed.

use nalgebra::SVector;

use super::event::Change;
use crate::equilibrium::{Found, combinations, search};
use crate::formulation::{Law, Piece, Problem, State, kinematic_form};
use crate::lcp::MatrixClass;

/// With at most this many combinations of states among the contacts on an edge, all are tried to see whether the path
/// goes on in more than one way.
const FEW_COMBINATIONS: f64 = 256.0;
/// With more rows than this, the class of their matrix costs more than the event.
const MOST_ROWS: usize = 64;

/// Nothing changes: the states so far in terms of the laws of the rates, if these have them.
pub(super) fn nothing_changes<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    rates: &Problem<D, C>,
    states: &[State],
) -> Option<Vec<State>> {
    let in_the_rates = |(contact, &state): (usize, &State)| {
        if let (true, State::Sliding { .. }) = (problem.round, state) {
            return match rates.laws[contact] {
                Law::Edge(_) => Some(state),
                // It has just stuck.
                Law::Bonded => Some(State::Rolling),
                // At the apex there is no telling which way it slid.
                _ => None,
            };
        }
        let (Law::Edge(facets), State::Sliding { first, second }) = (&rates.laws[contact], state) else {
            return Some(state);
        };
        let normals = problem.normals(contact);
        let at = |k: usize| facets.iter().position(|h| *h == normals[k]);
        match second {
            None => Some(State::Sliding { first: at(first)?, second: None }),
            Some(second) => Some(State::Sliding { first: at(first)?, second: Some(at(second)?) }),
        }
    };
    states.iter().enumerate().map(in_the_rates).collect()
}

/// What slides goes on sliding and what has reached an edge slides along it: the common case, one solve. What is at the
/// apex of its cone opens.
pub(super) fn everything_slides<const D: usize, const C: usize>(rates: &Problem<D, C>) -> Vec<State> {
    (0..rates.len())
        .map(|i| match &rates.laws[i] {
            Law::Edge(facets) => {
                State::Sliding { first: 0, second: (C == 3 && facets.len() == 2).then_some(1) }
            }
            Law::Cone { gap: true } => State::Open,
            _ => rates.unjumped(i),
        })
        .collect()
}

/// A state of the rates, in which facets count among those its law has, in terms of the whole law.
pub(super) fn in_the_whole_law<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    contact: usize,
    law: &Law<C>,
    state: State,
) -> State {
    let (Law::Edge(facets), State::Sliding { first, second }) = (law, state) else { return state };
    if problem.round {
        return state;
    }
    let normals = problem.normals(contact);
    let mut at: Vec<usize> = [Some(first), second]
        .into_iter()
        .flatten()
        .filter_map(|k| normals.iter().position(|h| *h == facets[k]))
        .collect();
    at.sort_unstable();
    problem.slipping_state(contact, &at)
}

/// What a contact changes from one state to the next, each with its direction if it slides.
pub(super) fn change<const C: usize>(
    (was, before): (State, Option<SVector<f64, C>>),
    (is, direction): (State, Option<SVector<f64, C>>),
) -> Option<Change<C>> {
    match (was, is, direction) {
        (State::Open, State::Rolling, _) => Some(Change::Closes),
        (State::Open, State::Sliding { .. }, Some(direction)) => Some(Change::ClosesSliding { direction }),
        (State::Rolling, State::Sliding { .. }, Some(direction)) => Some(Change::Slides { direction }),
        (State::Sliding { .. }, State::Rolling, _) => Some(Change::Sticks),
        (State::Rolling | State::Sliding { .. }, State::Open, _) => Some(Change::Opens),
        (State::Sliding { .. }, State::Sliding { .. }, Some(direction)) if was != is => {
            let back = before.is_some_and(|before| before.dot(&direction) < -0.5);
            Some(if back { Change::Reverses { direction } } else { Change::Turns { direction } })
        }
        _ => None,
    }
}

/// How many other solutions the rates have: other forces, or other motions than one along what is free anyway. None if a P-matrix says
/// that there is only one; else all combinations of states are tried if they are few.
pub(super) fn others<const D: usize, const C: usize>(
    rates: &Problem<D, C>,
    found: &Found<D, C>,
) -> Option<usize> {
    // What polygons say of an apex is not true of the round cone.
    if rates.round {
        return None;
    }
    if has_one_solution(rates) {
        return Some(0);
    }
    if combinations(rates) > FEW_COMBINATIONS {
        return None;
    }
    let size = found.forces.iter().map(nalgebra::Matrix::norm).fold(rates.wrench.norm(), f64::max);
    let mut distinct: Vec<Found<D, C>> = vec![found.clone()];
    for other in search(rates, false).found {
        let same = |known: &Found<D, C>| {
            let mut apart = known.twist - other.twist;
            for v in known.free_motions.iter().chain(&other.free_motions) {
                apart -= v * v.dot(&apart);
            }
            let travel = known.twist.norm().max(other.twist.norm());
            apart.norm() <= 1e-9 * travel
                && known.forces.iter().zip(&other.forces).all(|(x, y)| (x - y).norm() <= 1e-9 * size)
        };
        if !distinct.iter().any(same) {
            distinct.push(other);
        }
    }
    Some(distinct.len() - 1)
}

/// Whether the kinematic form of the rates has a P-matrix: one solution whatever the load does.
fn has_one_solution<const D: usize, const C: usize>(rates: &Problem<D, C>) -> bool {
    let rows: usize = (0..rates.len()).map(|i| rates.normals(i).len() + usize::from(rates.may_open(i))).sum();
    if rows == 0 || rows > MOST_ROWS {
        return rows == 0;
    }
    let stuck: Vec<State> = (0..rates.len()).map(|i| rates.unjumped(i)).collect();
    let trial = Piece::new(rates, &stuck);
    let Ok(state) = trial.solve(rates.sites, &rates.drives, &rates.wrench) else { return false };
    kinematic_form(rates, &trial, &state)
        .and_then(|form| MatrixClass::of(form.lcp.matrix()).ok())
        .is_some_and(|class| class.p_matrix == Some(true))
}
