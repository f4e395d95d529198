//! The rungs for more than a few contacts, on lists of contact states: their cost is that of a few numbers a contact.

use super::candidate::Found;
use super::climb::{climb, propose_structured};
use super::settings::Settings;
use super::settle::{Effort, Rung};
use crate::equilibrium::Doubt;
use crate::formulation::{Piece, PieceState, Problem};
use crate::structured::propose_by_newton;

/// From this many contacts on the kinematic form is solved on lists of contact states first. The pivots are cheaper with three contacts
/// already; with so few the dense solver's path is kept: another covering vector may end in another of several equilibria.
const STRUCTURED_FROM: usize = 8;
/// From this many contacts on Newton's method is tried before: with few contacts it often goes round in circles, with many hardly ever
/// unless stiffnesses and friction lie decades apart.
pub(super) const MANY: usize = 32;
/// With more rows the dense matrices of the two forms are not made: they would take gigabytes, and their solution minutes.
const MOST_DENSE_ROWS: usize = 2000;

/// Whether dense matrices can be made for this problem.
pub(super) fn dense_is_affordable<const D: usize, const C: usize>(problem: &Problem<D, C>) -> bool {
    let rows = |i: usize| usize::from(problem.may_open(i)) + problem.normals(i).len();
    (0..problem.len()).map(rows).sum::<usize>() <= MOST_DENSE_ROWS
}

/// What the rungs on lists of contact states find; `trial` is the piece in which everything sticks, `state` its solution.
pub(super) fn climb_on_states<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    with_facets: Option<&Problem<D, C>>,
    settings: &Settings,
    (trial, state): (&Piece<D, C>, &PieceState<D, C>),
    effort: &mut Effort,
    doubt: &mut Doubt,
) -> Option<(Found<D, C>, Rung)> {
    if problem.len() >= MANY {
        let newton = |problem: &Problem<D, C>, _: &mut Effort, _: &mut Doubt| propose_by_newton(problem);
        if let Some(found) = climb(problem, newton, effort, doubt) {
            return Some((found, Rung::Newton));
        }
    }
    if problem.len() < STRUCTURED_FROM {
        return None;
    }
    let structured = |problem: &Problem<D, C>, effort: &mut Effort, doubt: &mut Doubt| {
        propose_structured(problem, settings, trial, state, effort, doubt)
    };
    let found = climb(problem, structured, effort, doubt).or_else(|| {
        let with_facets = with_facets.filter(|_| !dense_is_affordable(problem))?;
        climb(with_facets, structured, effort, doubt)
    });
    found.map(|found| (found, Rung::KinematicForm))
}
