//! The onset where everything clearly rolls to begin with, and one contact reaches the edge of its cone before all others.
//!
//! That is the common case and the cheap one: one factorisation for two loads, a ratio test, and one more solve at the onset, which gives its
//! factor the last digits. Everything else is for [`super::walk`].

use nalgebra::Matrix;

use super::onset::{Departure, Leaving, OnsetEvent, RollingState};
use super::ramp::Ramp;
use super::segment::Segment;
use crate::contact::{Exit, Line, Stand};
use crate::object::Piece;
use crate::search::Rung;

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
    let piece = Piece::new(problem, &states);
    if !piece.free_motions().is_empty() {
        return None;
    }
    let base = piece.solve_roughly(&problem.drives, &problem.wrench);
    let rate = piece.solve_roughly(&segment.change, &segment.direction);
    let [largest, fastest] = [
        problem.largest_force(&base.forces, &base.twist),
        rate.forces.iter().map(Matrix::norm).fold(segment.direction.norm(), f64::max),
    ];
    let mut first: Option<(usize, Exit<C>, Line<C>)> = None;
    let mut next = f64::INFINITY;
    for (i, state) in states.iter().enumerate() {
        let (local, site) = (problem.local(i), &problem.sites[i]);
        let at = problem.at(i, &base.forces[i], &base.twist, largest);
        let mut clear = true;
        local.for_each_condition(state, &at, |value, size| clear &= value > CLEARLY * size);
        if !clear {
            return None;
        }
        let span_rate = site.span(&segment.change[i], &rate.twist);
        let line = Line {
            force: base.forces[i],
            rate: rate.forces[i],
            force_size: local.force_size(&base.forces[i], at.span, largest),
            rate_size: local.force_size(&rate.forces[i], span_rate, fastest),
        };
        let Some((exit, second)) = local.first_exit(&line) else { continue };
        next = next.min(second);
        match &first {
            Some((_, nearest, _)) if exit.step >= nearest.step => next = next.min(exit.step),
            _ => {
                next = first.map_or(next, |(_, nearest, _)| next.min(nearest.step));
                first = Some((i, exit, line));
            }
        }
    }
    let (contact, exit, line) = first?;
    let alone = next - exit.step > APART * exit.step && exit.uncertainty <= ROUGHLY * exit.step;
    if !alone || exit.step * fastest > FAR * largest {
        return None;
    }
    // Again at the onset: found from afar the factor carries the rounding of what the forces are at the base.
    let mut factor = exit.step;
    let load = problem.wrench + segment.direction * factor;
    let mut there = piece.solve(problem.sites, &segment.drives(factor), &load).ok()?;
    let more = problem.local(contact).way_to(&exit, &there.forces[contact], &line.rate);
    if more.abs() > ROUGHLY * factor {
        return None;
    }
    factor += more;
    there.twist += rate.twist * more;
    there.forces.iter_mut().zip(&rate.forces).for_each(|(force, rate)| *force += rate * more);
    let mut stands = vec![Stand::NOWHERE; states.len()];
    stands[contact].reach(&states[contact], &[exit]);
    let how = if exit.facet.norm() == 0.0 {
        Departure::Opens
    } else {
        Departure::Slides { direction: problem.sites[contact].frame * exit.facet.normalize() }
    };
    let largest = problem.largest_force(&there.forces, &there.twist);
    Some(OnsetEvent {
        factor,
        load: ramp.load_at(factor),
        leaving: vec![Leaving { contact, how }],
        cone: segment.cone,
        local: RollingState {
            rule: Rung::EverythingRolls,
            states,
            forces: there.forces,
            stands,
            twist: there.twist,
            free_motions: Vec::new(),
            wrench: problem.wrench + segment.direction * factor,
            wrench_rate: segment.direction,
            drives: segment.drives(factor),
            drive_rates: segment.change.clone(),
            slips: problem.slips.clone(),
            sizes: [largest, 0.0],
        },
    })
}
