//! A twist that is one end of an interval: told with the motion along which others hold just as well.
//!
//! Where friction is used up to the last at every contact that could resist a motion, forces do not say where along it the object is. States in which one
//! of these contacts sticks are the end of that interval at which it has not slipped: they hold, and seem to leave nothing free.

use nalgebra::{Matrix, SVector};

use super::answer::Found;
use super::candidate::{Judged, try_states};
use super::least_motion::at_the_least_motion;
use crate::contact::{Line, Mode, State, WEIGHTLESS};
use crate::numerics::Size;
use crate::object::Problem;
use crate::prelude::*;

/// Forces that differ by less than this part of the largest are the same.
const SAME: f64 = 1e-9;

/// The same forces in the states that leave motions free, if what stands on an edge without slipping, or touches without force, may as well slide or part.
pub(crate) fn on_the_whole_line<D: Size, const C: usize>(
    problem: &Problem<D, C>,
    found: Found<D, C>,
) -> Found<D, C> {
    // In space springs across the slip resist where those of the plane have no direction left.
    if C > 2 {
        return found;
    }
    let Some(states) = yielding(problem, &found) else { return found };
    let largest = problem.largest_force(&found.forces, &found.twist);
    let are_the_same = |other: &Found<D, C>| {
        found.forces.iter().zip(&other.forces).all(|(f, g)| (f - g).norm() <= SAME * largest)
    };
    let free = |other: &Found<D, C>| other.free_motions.len();
    match try_states(problem, states) {
        Judged::Holds(other) if free(&other) > free(&found) && are_the_same(&other) => {
            at_the_least_motion(problem, other)
        }
        _ => found,
    }
}

/// What everything does if all that may yield does; `None` if nothing may.
fn yielding<D: Size, const C: usize>(problem: &Problem<D, C>, found: &Found<D, C>) -> Option<Vec<State<C>>> {
    let largest = found.forces.iter().map(Matrix::norm).fold(problem.wrench.norm(), f64::max);
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
