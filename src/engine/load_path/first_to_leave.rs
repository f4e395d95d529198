//! The onset (the load factor at which the first contact ceases to stick) in a simple case, which is the most common. Everything clearly sticks under
//! the base load, and the force of one contact leaves its friction cone before all others. The base load acts from the start, and the load of the
//! question grows in addition. A ramp is a load that grows in proportion to a load factor; a turn is a load that turns by an angle.
//!
//! This case is cheap: one factorisation, solved for the base load and for its change, and a ratio test. One more solve at the onset makes the last
//! digits of its load factor exact. [`super::sticking_path`] handles all other cases.

use nalgebra::SVector;

use super::onset::{DepartingContact, Onset, OnsetEvent};
use super::onset_workspace::OnsetMemory;
use super::segment::Segment;
use super::tolerances::LARGEST_CORRECTION;
use super::turn::Turn;
use super::turning_load::at_start;
use crate::contact::{ActiveSet, Exit, Line, LocalLaw, SpringState};
use crate::equilibrium::ACCURATE;
use crate::grasp::{Site, Wrench};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{self, Harmonic, Vector, add_times, cleared_for};
use crate::object::{ForcesAndTwist, Imbalance};
use crate::search::{FoundBy, SearchSolution};

/// The contact that stops sticking first, and forces and twist at this onset. The index `contact` may also be that of a drive, the spring of a joint
/// or tendon, that reaches its force limit. Drives are counted after the contacts. `factor` is the load factor or, while a load turns, the angle in
/// rad.
pub(super) struct FirstToLeave {
    pub(super) factor: f64,
    pub(super) contact: usize,
    exit: Exit,
    pub(super) there: ForcesAndTwist,
}

/// The first contact that stops sticking along a ramp. `None` if everything sticks at every load factor, or if the simple case of this file does not
/// apply. It applies if everything clearly sticks under the base load, and one contact stops sticking before all others.
pub(super) fn first_to_leave(segment: &Segment<'_>, memory: &mut OnsetMemory) -> Option<FirstToLeave> {
    let problem = &segment.problem;
    let linear_problem = problem.trial();
    if !linear_problem.free_motions().is_empty() {
        return None;
    }
    let direction = segment.trajectory.rate_at(0.0);
    let OnsetMemory { solution, base, rate, there, offsets, .. } = memory;
    linear_problem.solve_roughly_into(&segment.change, &direction, (solution, rate));
    linear_problem.solve_roughly_into(&problem.offsets, &problem.wrench, (solution, base));
    let FirstContact { contact, exit, line } = first_exit(segment, base, (&direction, rate))?;
    // The equilibrium is solved again at the onset. A load factor extrapolated from the base load has the rounding errors of the forces under
    // the base load.
    let mut factor = exit.step;
    let load = segment.trajectory.at(factor);
    segment.offsets_into(factor, offsets);
    linear_problem.solve_into(problem.sites, offsets, &(&load).into(), (solution, there)).ok()?;
    let more = problem.local(contact).step_to_exit(&exit, &there.forces[contact], &line.rate);
    if more.abs() > LARGEST_CORRECTION * factor || !is_balanced(problem.sites, &load, &there.forces) {
        return None;
    }
    factor += more;
    there.twist += &rate.twist * more;
    add_times(&mut there.forces, &rate.forces, more);
    Some(FirstToLeave { factor, contact, exit, there: core::mem::take(there) })
}

/// While a load turns: the first contact that stops sticking, if it does so clearly before all others.
pub(super) enum WhileTurning {
    /// One contact stops sticking before all others.
    First(FirstToLeave),
    /// All contacts keep sticking up to the full angle of the turn.
    Never,
}

/// The first contact that stops sticking while the load turns by up to `turn.angle`, or [`WhileTurning::Never`]. `inside` is the load as a function
/// of the angle. `None` if the simple case of this file does not apply, or if a force touches the boundary of its friction cone without leaving the
/// cone.
pub(super) fn first_to_leave_on_turn(
    segment: &Segment<'_>,
    turn: &Turn<3>,
    inside: &Harmonic<Vector>,
) -> Option<WhileTurning> {
    let problem = &segment.problem;
    let linear_problem = problem.trial();
    if !linear_problem.free_motions().is_empty() {
        return None;
    }
    let states = problem.trial_states();
    let at_rest = vec![SVector::zeros(); problem.len()];
    let parts = Harmonic {
        constant: linear_problem.solve_roughly(&problem.offsets, &inside.constant),
        cosine: linear_problem.solve_roughly(&at_rest, &inside.cosine),
        sine: linear_problem.solve_roughly(&at_rest, &inside.sine),
    };
    let base = at_start(&parts);
    let largest = problem.largest_force(&base.forces, &base.twist);
    let at = |i: usize| problem.at(i, &base.forces[i], &base.twist, largest);
    if !problem.locals().enumerate().all(|(i, local)| clearly_sticks(&local, &at(i))) {
        return None;
    }
    let mut turned = segment.harmonics(inside, 1.0, &parts);
    // The solutions under the constant, cosine and sine terms of the load are not refined by iteration. Each force thus has a rounding error in
    // proportion to the largest force. Cases that such an error could change are left to `sticking_path`.
    let roughly = parts.map(|part| problem.largest_force(&part.forces, &part.twist));
    let roughly = roughly.parts().into_iter().sum::<f64>();
    for [force, _] in &mut turned.waves {
        force.size = force.size.max(roughly);
    }
    let first = turned.first_exits(problem, &states, turn.angle);
    if !first.touches.is_empty() {
        return None;
    }
    let Some((mut angle, reached)) = first.reached else { return Some(WhileTurning::Never) };
    let [(contact, exits)] = &reached[..] else { return None };
    let [exit] = exits[..] else { return None };
    if exit.uncertainty > LARGEST_CORRECTION * angle {
        return None;
    }
    let load = inside.at(angle);
    let mut there = linear_problem.solve(problem.sites, &problem.offsets, &load).ok()?;
    let rate = turned.waves[*contact][0].of.rate_at(angle);
    let more = problem.local(*contact).step_to_exit(&exit, &there.forces[*contact], &rate);
    if more.abs() > LARGEST_CORRECTION * angle || !is_balanced(problem.sites, &load, &there.forces) {
        return None;
    }
    angle += more;
    for (force, [wave, _]) in there.forces.iter_mut().zip(&turned.waves) {
        *force += wave.of.rate_at(angle) * more;
    }
    there.twist += turned.twist.rate_at(angle) * more;
    Some(WhileTurning::First(FirstToLeave { factor: angle, contact: *contact, exit, there }))
}

impl FirstToLeave {
    /// The onset as [`Onset::At`]. `segment` is the ramp or the turn along which it was found, and `load` the caller's load at the onset.
    pub(super) fn onset(
        self,
        mut segment: Segment<'_>,
        load: Wrench<3>,
        memory: &mut OnsetMemory,
    ) -> Onset<3> {
        let Self { factor, contact, exit, there } = self;
        let OnsetMemory { states, active_sets, leaving, sites, .. } = memory;
        cleared_for(states, segment.problem.len());
        states.extend(segment.problem.locals().map(|local| local.trial_state()));
        active_sets.iter_mut().for_each(ActiveSet::clear);
        active_sets.resize(states.len(), ActiveSet::EMPTY);
        active_sets[contact].add_exits(segment.problem.space().axes(), &states[contact], &[exit]);
        let frame = &segment.problem.sites[contact].frame;
        cleared_for(leaving, 1);
        leaving.push(DepartingContact::driven_out(
            contact,
            &active_sets[contact],
            &segment.problem.local(contact),
            frame,
        ));
        cleared_for(sites, 1);
        sites.push(contact);
        let found = SearchSolution::new(core::mem::take(states), there.forces, there.twist);
        let leaving = (core::mem::take(leaving), core::mem::take(sites));
        let active_sets = core::mem::take(active_sets);
        memory.lists.laws = core::mem::take(&mut segment.problem.laws);
        let sticks = (found, FoundBy::EverythingSticks);
        let event =
            OnsetEvent::new(segment, (factor, load), leaving, active_sets, sticks, &mut memory.coordinates);
        Onset::At(memory.put(event))
    }
}

/// Whether a contact clearly sticks: the value of every sticking condition, positive inside the friction cone, is more than the fraction `NEGLIGIBLE`
/// of the magnitude of its terms. If the law keeps a contact open (`Law::Absent`), the conditions of an open contact are tested instead.
fn clearly_sticks(local: &LocalLaw<'_>, at: &SpringState<'_>) -> bool {
    let mut clear = true;
    // If a condition has a smaller value, the force may be on the boundary of the friction cone. Such a case is left to `StickingPath`.
    local.for_each_condition(&local.trial_state(), at, &mut |value, size| clear &= value > NEGLIGIBLE * size);
    clear
}

/// The contact whose force reaches the boundary of its cone before all others, with the facet that it reaches and the load factor there (`exit`).
/// `line` is the contact's force as an affine function of the load factor.
struct FirstContact {
    contact: usize,
    exit: Exit,
    line: Line,
}

/// The contact whose force leaves its cone at the least load factor; `None` if no force leaves its cone. `None` also if a contact does not clearly
/// stick under the base load, or if two forces leave at nearly the same load factor.
fn first_exit(
    segment: &Segment<'_>,
    base: &ForcesAndTwist,
    (direction, rate): (&Vector, &ForcesAndTwist),
) -> Option<FirstContact> {
    let problem = &segment.problem;
    let largest = problem.largest_force(&base.forces, &base.twist);
    let fastest = numerics::largest(&rate.forces, &SVector::norm).max(direction.norm());
    let mut first: Option<FirstContact> = None;
    let mut next = f64::INFINITY;
    for (contact, (local, site)) in problem.locals().zip(problem.sites).enumerate() {
        let at = problem.at(contact, &base.forces[contact], &base.twist, largest);
        if !clearly_sticks(&local, &at) {
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
                first = Some(FirstContact { contact, exit, line });
            }
        }
    }
    first.filter(|FirstContact { exit, .. }| {
        // The next exit, of this or of another contact, must come clearly later: its load factor exceeds that of the first exit by more than the
        // fraction `NEGLIGIBLE` (1e-9). The first exit must also be known to the fraction `LARGEST_CORRECTION` (1e-6) of its load factor.
        let alone =
            next - exit.step > NEGLIGIBLE * exit.step && exit.uncertainty <= LARGEST_CORRECTION * exit.step;
        // If forces grow to more than a million times their magnitude under the base load, their computed rates may be only rounding. Such a case is
        // left to `sticking_path`.
        alone && exit.step * fastest <= 1e6 * largest
    })
}

/// Whether the imbalance of contact forces and load is at most the fraction `ACCURATE` (1e-10) of the sum of their norms.
fn is_balanced(sites: &[Site], load: &Vector, forces: &[SVector<f64, 3>]) -> bool {
    let Imbalance { left, size } = Imbalance::of(sites, forces, load, load.norm());
    left.norm() <= ACCURATE * size
}
