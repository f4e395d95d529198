//! The transition from one piece of the path (on which contacts keep their states: open, sticking or sliding) to the next. This file has the guess
//! that no state changes, the list of changes of states, and the number of other continuations of the path.
//!
//! The rate problem determines the rates of forces and motion along the path. Its kinematic form is a linear complementarity problem for the rates of
//! gaps and slips. Its elastic trial is the solution in which all contacts stick.

use nalgebra::SVector;

use super::event::Change;
use crate::contact::{Mode, State};
use crate::forms::{Form, clearly_breaks, kinematic_form};
use crate::grasp::{Site, Space};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Reals, all_some};
use crate::object::Problem;
use crate::prelude::*;
use crate::search::{SearchSolution, combinations, search_among};

/// The contact states of the rate problem `rates` in which every contact keeps its present state, given in `states`. They are tried first. `None` if
/// some contact cannot keep its state according to its law in `rates`.
pub(super) fn nothing_changes(problem: &Problem, rates: &Problem, states: &[State]) -> Option<Vec<State>> {
    let locals = problem.locals().zip(&rates.laws).zip(states);
    all_some(locals.map(|((local, law), state)| local.in_the_rates(law, *state)))
}

/// The change of a contact from one state to the next, as an event lists it. `None` if the contact stays open, sticks on, or slides on along the same
/// facet or corner of its cone. Each state is given with the direction of slip, which is `None` unless the contact slides.
pub(super) fn change(
    (was, before): (State, Option<SVector<f64, 3>>),
    (is, direction): (State, Option<SVector<f64, 3>>),
) -> Option<Change<3>> {
    match (was, is, direction) {
        (Mode::Open, Mode::Sticking, _) => Some(Change::Closes),
        (Mode::Open, _, Some(direction)) if is.slides() => Some(Change::ClosesSliding { direction }),
        (Mode::Sticking, _, Some(direction)) if is.slides() => Some(Change::Slides { direction }),
        (_, Mode::Sticking, _) if was.slides() => Some(Change::Sticks),
        (_, Mode::Open, _) if !was.is_open() => Some(Change::Opens),
        (_, _, Some(direction)) if was.slides() && is.slides() && !was.is_kind_of(&is) => {
            let back = before.is_some_and(|before| before.dot(&direction) < -0.5);
            Some(if back { Change::Reverses { direction } } else { Change::Turns { direction } })
        }
        _ => None,
    }
}

/// Number of solutions of the rate problem `rates` in addition to the solution `found`. Two solutions differ if rates of forces differ, or twist
/// rates apart from motions that no spring resists. Zero if the matrix of the kinematic form of `rates` is a P-matrix, which proves uniqueness.
/// Otherwise all combinations of contact states are tried. `None` if there are more than 256 combinations, or with a contact at the apex of a round
/// cone.
pub(super) fn other_solutions(rates: &Problem, found: &SearchSolution) -> Option<usize> {
    // In a rate problem `round` is true only if a contact is at the apex of a round cone. The solutions cannot be counted then: combinations of
    // states are tried on polygonal cones, on which the number of solutions may be different.
    if rates.round {
        return None;
    }
    let rows: usize = rates.locals().map(|local| local.pairs()).sum();
    let few = few_rows(rates, rows);
    if rows == 0 || few.as_ref().is_some_and(|few| few.form.lcp.has_p_matrix() == Some(true)) {
        return Some(0);
    }
    // All combinations of states of the contacts on the boundary of their cones are tried if there are at most this many; trying more takes too long.
    if combinations(rates) > 256.0 {
        return None;
    }
    let size = found.forces.iter().map(nalgebra::Matrix::norm).fold(rates.wrench.norm(), f64::max);
    let mut distinct: Vec<SearchSolution> = vec![found.clone()];
    // With many coordinates, solving for one combination of states takes long. A test on the kinematic form excludes most combinations first. This
    // test is cheap, because the form has at most 64 complementary pairs.
    let is_planar = rates.space() == Space::Planar;
    let ruled_out = |states: &[State]| {
        few.as_ref().is_some_and(|few| few.many && clearly_breaks(&few.form, is_planar, states, few.largest))
    };
    for other in search_among(rates, false, &|states| !ruled_out(states)).found {
        let same = |known: &SearchSolution| {
            let mut apart = &known.twist - &other.twist;
            for v in known.free_motions.iter().chain(&other.free_motions) {
                apart -= v * v.dot(&apart);
            }
            let travel = known.twist.norm().max(other.twist.norm());
            // Solutions are equal if their forces and motions differ by at most this fraction of their magnitude.
            apart.norm() <= NEGLIGIBLE * travel
                && known.forces.iter().zip(&other.forces).all(|(x, y)| (x - y).norm() <= NEGLIGIBLE * size)
        };
        if !distinct.iter().any(same) {
            distinct.push(other);
        }
    }
    Some(distinct.len() - 1)
}

/// The kinematic form (a linear complementarity problem for the rates of gaps and slips) of the rate problem. It has at most 64 complementary pairs,
/// so that tests on it are cheap.
struct FewRows {
    form: Form,
    /// The largest component of a contact force in the elastic trial, in which all contacts stick. Each component is divided by the square root of
    /// its stiffness, like the slacks of the kinematic form.
    largest: f64,
    /// Whether there are so many coordinates that the elastic trial is factorised as a band matrix.
    many: bool,
}

/// The kinematic form of the rate problem `rates`; the form has `rows` complementary pairs. `None` if there are no pairs or more than 64, or if the
/// form cannot be computed.
fn few_rows(rates: &Problem, rows: usize) -> Option<FewRows> {
    // With more complementary pairs than this, testing for a P-matrix costs more than all other work at the event.
    if rows == 0 || rows > 64 {
        return None;
    }
    let trial = rates.trial();
    let state = trial.solve(rates.sites, &rates.offsets, &rates.wrench).ok()?;
    let in_units = |(site, force): (&Site, &SVector<f64, 3>)| {
        let axes = 0..site.springs.axes();
        axes.map(|axis| (force[axis] / site.springs.root_along(axis)).abs()).most()
    };
    let largest = rates.sites.iter().zip(&state.forces).map(in_units).most();
    let form = kinematic_form(rates, &trial, &state)?;
    Some(FewRows { form, largest, many: trial.is_banded() })
}
