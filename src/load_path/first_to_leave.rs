//! The onset where everything clearly rolls to begin with, and one contact reaches the edge of its cone before all others.
//!
//! That is the common case and the cheap one: one factorisation for two loads, a ratio test, and one more solve at the onset, which gives its
//! factor the last digits. Everything else is for [`super::walk`].

use nalgebra::{Matrix, SVector};

use super::onset::{Leaving, OnsetEvent};
use super::ramp::Ramp;
use super::segment::Segment;
use crate::contact::{Exit, Line, Stand, State};
use crate::equilibrium::ACCURATE;
use crate::grasp::Site;
use crate::object::{Piece, PieceState};
use crate::search::{Found, Rung};

/// Conditions at the base must hold by this part of their size: less may be rounding or an edge on which a contact stands, which is for
/// the walk to tell.
const CLEARLY: f64 = 1e-9;
/// The next contact must be farther than this part of the way to the first.
const APART: f64 = 1e-9;
/// The solve at the onset may correct the factor by this part; a larger correction says that something else is wrong.
const ROUGHLY: f64 = 1e-6;
/// A factor at which the forces would be so many times as large as at the base may be that of rates which are rounding.
const FAR: f64 = 1e6;

/// The event, or `None` where the case is another one.
pub(super) fn first_to_leave<const D: usize, const C: usize>(
    segment: &Segment<'_, D, C>,
    ramp: &Ramp<D, C>,
) -> Option<OnsetEvent<D, C>> {
    let problem = &segment.problem;
    let states = problem.unjumped();
    let piece = problem.trial();
    if !piece.free_motions().is_empty() {
        return None;
    }
    let rate = piece.solve_roughly(&segment.change, &segment.direction);
    let First { contact, exit, line } = first_exit(segment, &states, &piece, &rate)?;
    // Again at the onset: found from afar the factor carries the rounding of what the forces are at the base.
    let mut factor = exit.step;
    let load = problem.wrench + segment.direction * factor;
    let mut there = piece.solve(problem.sites, &segment.drives(factor), &load).ok()?;
    let more = problem.local(contact).way_to(&exit, &there.forces[contact], &line.rate);
    if more.abs() > ROUGHLY * factor || !is_balanced(problem.sites, &load, &there.forces) {
        return None;
    }
    factor += more;
    there.twist += rate.twist * more;
    there.forces.iter_mut().zip(&rate.forces).for_each(|(force, rate)| *force += rate * more);
    let mut stands = vec![Stand::NOWHERE; states.len()];
    stands[contact].reach(&states[contact], &[exit]);
    let leaving = vec![Leaving::driven_out(contact, &stands[contact], &problem.sites[contact].frame)];
    let found = Found::new(states, there.forces, there.twist);
    Some(OnsetEvent::new(segment, ramp, factor, leaving, stands, (found, Rung::EverythingRolls)))
}

/// The contact that reaches the edge of its cone before all others, with its way there.
struct First<const C: usize> {
    contact: usize,
    exit: Exit<C>,
    line: Line<C>,
}

/// The first way out, if everything clearly rolls at the base and no other comes near it.
fn first_exit<const D: usize, const C: usize>(
    segment: &Segment<'_, D, C>,
    states: &[State<C>],
    piece: &Piece<D, C>,
    rate: &PieceState<D, C>,
) -> Option<First<C>> {
    let problem = &segment.problem;
    let base = piece.solve_roughly(&problem.drives, &problem.wrench);
    let largest = problem.largest_force(&base.forces, &base.twist);
    let fastest = rate.forces.iter().map(Matrix::norm).fold(segment.direction.norm(), f64::max);
    let mut first: Option<First<C>> = None;
    let mut next = f64::INFINITY;
    for (contact, state) in states.iter().enumerate() {
        let (local, site) = (problem.local(contact), &problem.sites[contact]);
        let at = problem.at(contact, &base.forces[contact], &base.twist, largest);
        let mut clear = true;
        local.for_each_condition(state, &at, |value, size| clear &= value > CLEARLY * size);
        if !clear {
            return None;
        }
        let span_rate = site.span(&segment.change[contact], &rate.twist);
        let line = Line {
            force: base.forces[contact],
            rate: rate.forces[contact],
            force_size: local.force_size(&base.forces[contact], at.span, largest),
            rate_size: local.force_size(&rate.forces[contact], span_rate, fastest),
        };
        let Some((exit, second)) = local.first_exit(&line) else { continue };
        next = next.min(second);
        match &first {
            Some(nearest) if exit.step >= nearest.exit.step => next = next.min(exit.step),
            _ => {
                next = first.map_or(next, |nearest| next.min(nearest.exit.step));
                first = Some(First { contact, exit, line });
            }
        }
    }
    first.filter(|First { exit, .. }| {
        let alone = next - exit.step > APART * exit.step && exit.uncertainty <= ROUGHLY * exit.step;
        alone && exit.step * fastest <= FAR * largest
    })
}

/// Whether forces balance a load as well as those of an answer have to.
fn is_balanced<const D: usize, const C: usize>(
    sites: &[Site<D, C>],
    load: &SVector<f64, D>,
    forces: &[SVector<f64, C>],
) -> bool {
    let (mut left, mut size) = (*load, load.norm());
    for (site, force) in sites.iter().zip(forces) {
        left += site.map * force;
        size += force.norm();
    }
    left.norm() <= ACCURATE * size
}
