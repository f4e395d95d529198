//! What touches without force neither sticks nor slides: it is open, with a gap of nothing.
//!
//! Which rung finds it sticking, sliding or open is a matter of the rounding of its force. Friction of no force holds nothing, so that the state in which
//! all such contacts are open has the same forces, and is told whatever was found.

use nalgebra::Matrix;

use super::answer::{Effort, Found, Settled};
use super::ladder::settle;
use super::least_motion::at_the_least_motion;
use super::settings::Settings;
use super::whole_line::on_the_whole_line;
use crate::contact::{ActiveSet, Mode, WEIGHTLESS};
use crate::numerics::Size;
use crate::object::{Piece, PieceState, Problem};

/// Forces that differ by less than this part of the largest are the same.
const SAME: f64 = 1e-9;

/// [`settle`] for a problem at rest.
pub(crate) fn settle_at_rest<D: Size, const C: usize>(
    problem: &Problem<D, C>,
    settings: &Settings,
) -> (Settled<D, C>, Effort) {
    match settle(problem, settings) {
        (Settled::Found(found, rung), effort) => {
            let found = match opened(problem, &found) {
                Some(open) => at_the_least_motion(problem, open),
                None => found,
            };
            (Settled::Found(found, rung), effort)
        }
        other => other,
    }
}

/// A solution where it is, with the states and free motions that are told of a problem at rest.
pub(crate) fn told_at_rest<D: Size, const C: usize>(
    problem: &Problem<D, C>,
    found: Found<D, C>,
) -> Found<D, C> {
    let open = opened(problem, &found).unwrap_or_else(|| found.clone());
    let told = on_the_whole_line(problem, open);
    Found { twist: found.twist, sizes: found.sizes, ..told }
}

/// The same forces with all contacts open that carry none, if some do. Where nothing carries anything there is no force to be small beside.
fn opened<D: Size, const C: usize>(problem: &Problem<D, C>, found: &Found<D, C>) -> Option<Found<D, C>> {
    let largest = found.forces.iter().map(Matrix::norm).fold(0.0, f64::max);
    // Of what has not moved at all its own displacements are no measure.
    let spans = (0..problem.len()).map(|i| problem.span(i, &found.twist));
    let farthest = spans.fold(0.0, f64::max);
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
    let piece = Piece::new(problem, &states);
    let PieceState { forces, .. } = piece.solve(problem.sites, &problem.drives, problem.load()).ok()?;
    let are_the_same = forces.iter().zip(&found.forces).all(|(f, g)| (f - g).norm() <= SAME * largest);
    let free_motions = piece.free_motions().to_vec();
    let neutral_motions = piece.neutral_motions();
    are_the_same.then(|| Found { states, forces, free_motions, neutral_motions, ..found.clone() })
}
