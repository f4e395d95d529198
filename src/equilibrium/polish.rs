//! From the polygon to the round cone: Newton's method on the return map, then the last digits.
//!
//! From the twist of a polygon's answer a few steps of Newton's method ([`super::newton`]) do. There the contacts are springs
//! again, with a regular tangent stiffness unless motions are free or stiffnesses lie far apart, and steps of refinement on
//! the forces themselves balance them to rounding (`formulation/tangent`). Otherwise the last step is made on the piece,
//! where the oblique projection gives forces that balance to the last digits whatever the stiffness ratios.

use nalgebra::SVector;

use super::candidate::{Found, Verdict, admit, admit_sliding, try_states};
use super::newton::{Arrived, newton};
use super::slack::scene_force;
use crate::formulation::{
    Law, Piece, PieceState, Problem, Regular, Returned, Slide, Springs, State, balance, contact_stiffness,
    respond, tangent_stiffness,
};

/// A tiny friction force may still turn when all others have settled: it is then off its cone by the square of the angle. This
/// part of the largest force is rounding.
const ON_THE_CONE: f64 = 1e-14;
/// Steps on the piece: where Newton has converged the first is the last.
const FINISHING_STEPS: usize = 12;
/// A step that changes forces by less than this part of them is the last: what it leaves is the square of this.
const SETTLED: f64 = 1e-8;
/// Steps of Newton's method at most that bring every contact to the last digit.
const SHARPENING_STEPS: usize = 8;
/// A step by less than this part of a force, or of the twist, is the last.
const SHARP: f64 = 1e-14;
/// This part of the largest force is below the last digit of any.
const NO_DIGIT: f64 = 1e-20;
/// What may be out of balance of a polygon's answer, from which Newton's method starts.
const NEAR: f64 = 1e-12;
/// What is left out of balance of an answer is the rounding of its terms.
const BALANCED: f64 = 4e-16;

/// A proposal that holds: as it is on the polygon, where it leads to on the round cone.
pub(super) fn accept<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    states: Vec<State>,
) -> Verdict<D, C> {
    if !problem.round {
        return try_states(problem, states);
    }
    match try_states(problem, states) {
        Verdict::Holds(found) => {
            let near = PieceState { forces: found.forces, twist: found.twist };
            polish(problem, &near).map_or(Verdict::Violated { doubtful: false }, Verdict::Holds)
        }
        other => other,
    }
}

/// The solution of the polygon's piece with these states, whether every inequality holds or not: where Newton's method starts.
pub(crate) fn solution_near<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    states: &[State],
) -> Option<PieceState<D, C>> {
    if let Some(near) = regular_solution(problem, states) {
        return Some(near);
    }
    match try_states(problem, states.to_vec()) {
        Verdict::Holds(found) => Some(PieceState { forces: found.forces, twist: found.twist }),
        Verdict::Violated { .. } => {
            Piece::new(problem, states).solve(problem.sites, &problem.drives, problem.load()).ok()
        }
        Verdict::Unbalanced => None,
    }
}

/// The solution of a piece whose tangent stiffness is regular.
fn regular_solution<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    states: &[State],
) -> Option<PieceState<D, C>> {
    let springs: Vec<Springs<C>> =
        states.iter().enumerate().map(|(i, &state)| contact_stiffness(problem, i, state)).collect();
    let tangent = Regular::new(&tangent_stiffness(problem.sites, &springs))?;
    let forces = springs.iter().zip(&problem.drives).map(|(springs, drive)| springs * drive).collect();
    let mut near = PieceState { forces, twist: SVector::zeros() };
    balance(problem.sites, &springs, &tangent, &problem.wrench, &mut near, NEAR)?;
    Some(near)
}

/// The solution on the round cone near one on the polygon, if Newton's method finds it.
pub(crate) fn polish<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    near: &PieceState<D, C>,
) -> Option<Found<D, C>> {
    // On the pieces alone where stiffnesses lie so far apart that noise decides what Newton's matrix resists.
    let found = newton(problem, near.twist)
        .and_then(|arrived| {
            let twist = arrived.twist;
            let on_an_edge = problem.laws.iter().any(|law| matches!(law, Law::Edge(_)));
            let balanced = if on_an_edge { None } else { balanced(problem, arrived) };
            balanced.or_else(|| finish(problem, twist))
        })
        .or_else(|| finish(problem, near.twist))?;
    let found = sharpened(problem, found)?;
    let change = found.forces.iter().zip(&near.forces).map(|(round, polygon)| (round - polygon).norm());
    Some(Found { from_polygon: Some(change.fold(0.0, f64::max)), ..found })
}

/// The same to the last digit: steps of refinement leave rounding of the displacements, which stiff springs feel, and small forces beside
/// large ones may not have arrived. Newton's method again, with conditions in twice the working precision. `None` if it leads to where
/// the states no longer hold; as it was if it does not settle, since nothing but rounding holds a contact's direction.
fn sharpened<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    found: Found<D, C>,
) -> Option<Found<D, C>> {
    if found.slides.is_empty() {
        // From a piece, and sharp already.
        return Some(found);
    }
    let mut slides = found.slides.clone();
    let mut at = PieceState { forces: found.forces.clone(), twist: found.twist };
    for _ in 0..SHARPENING_STEPS {
        let linear = problem.along(&slides, &at.forces, &at.twist);
        let largest = scene_force(problem, &at.forces, &at.twist);
        let missing = Piece::new(&linear, &found.states).correction(&linear, &found.states, &at, largest);
        at.twist += missing.twist;
        let mut settled = missing.twist.norm() <= SHARP * at.twist.norm();
        for (force, missing) in at.forces.iter_mut().zip(&missing.forces) {
            *force += missing;
            // Each contact by itself: a small force may still turn while the large ones have settled.
            settled &= missing.norm() <= SHARP * force.norm() + NO_DIGIT * largest;
        }
        for (slide, law) in slides.iter_mut().zip(&linear.laws) {
            if let Law::Turning { slide: turned, .. } = law {
                *slide = Some(*turned);
            }
        }
        if settled {
            let Found { states, free_motions, neutral_motions, .. } = found;
            return admit_sliding(problem, states, slides, at, largest).map(|sharp| Found {
                free_motions,
                neutral_motions,
                ..sharp
            });
        }
    }
    Some(found)
}

/// What Newton's method arrived at, balanced to rounding: where the tangent stiffness is regular and that hardly changes a force.
fn balanced<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    arrived: Arrived<D, C>,
) -> Option<Found<D, C>> {
    let Arrived { twist, contacts, tangent: Some(tangent), mut springs } = arrived else { return None };
    springs.clear();
    springs.extend(contacts.iter().zip(problem.sites).map(|(returned, site)| returned.stiffness(site)));
    let mut state = PieceState { forces: contacts.iter().map(Returned::force).collect(), twist };
    let moved = balance(problem.sites, &springs, &tangent, &problem.wrench, &mut state, BALANCED)?;
    let largest = scene_force(problem, &state.forces, &state.twist);
    let slides: Vec<Option<Slide<C>>> = contacts
        .iter()
        .map(|returned| if let Returned::Sliding(_, slide) = returned { Some(*slide) } else { None })
        .collect();
    let settled = moved <= SETTLED * largest
        && (0..problem.len()).all(|i| slides[i].is_none() || on_cone(problem, i, &state.forces[i], largest));
    if !settled {
        return None;
    }
    let states = contacts
        .iter()
        .map(|returned| match returned {
            Returned::Open => State::Open,
            Returned::Rolling(_) => State::Rolling,
            Returned::Sliding(..) => State::Sliding { first: 0, second: None },
        })
        .collect();
    admit_sliding(problem, states, slides, state, largest)
}

/// Whether the friction force of a sliding contact is on its cone.
fn on_cone<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    contact: usize,
    f: &SVector<f64, C>,
    largest: f64,
) -> bool {
    let r = problem.sites[contact].mu * f[0];
    matches!(problem.laws[contact], Law::Edge(_))
        || (f[1].hypot(f[2]) - r).abs() <= ON_THE_CONE * largest.max(r)
}

/// Steps on the piece of the present slides until forces settle.
fn finish<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    mut twist: SVector<f64, D>,
) -> Option<Found<D, C>> {
    let n = problem.len();
    let mut linear = problem.with_laws(problem.laws.clone());
    let mut forces = vec![SVector::<f64, C>::zeros(); n];
    let mut states = vec![State::Open; n];
    let mut slides: Vec<Option<Slide<C>>> = vec![None; n];
    for _ in 0..FINISHING_STEPS {
        let mut drives = problem.drives.clone();
        for (i, site) in problem.sites.iter().enumerate() {
            drives[i] -= site.map.tr_mul(&twist);
            slides[i] = None;
            states[i] = match respond(problem, i, &drives[i], 0.0) {
                Returned::Open => State::Open,
                Returned::Rolling(force) => {
                    forces[i] = force;
                    State::Rolling
                }
                Returned::Sliding(force, slide) => {
                    linear.laws[i] = problem.turning(i, slide);
                    slides[i] = Some(slide);
                    let rest = slide.rest(&drives[i], &force, site.mu * force[0]);
                    drives[i] -= rest;
                    forces[i] = force;
                    State::Sliding { first: 0, second: None }
                }
            };
            if states[i] == State::Open {
                forces[i].fill(0.0);
            }
        }
        let piece = Piece::new(&linear, &states);
        let solved = piece.solve(problem.sites, &drives, problem.load()).ok()?;
        twist += solved.twist;
        let change = solved.forces.iter().zip(&forces).map(|(new, old)| (new - old).norm());
        let largest = scene_force(problem, &solved.forces, &twist);
        let on_cone = |i: usize| slides[i].is_none() || on_cone(problem, i, &solved.forces[i], largest);
        if change.fold(0.0, f64::max) <= SETTLED * largest && (0..n).all(on_cone) {
            let forces = solved.forces;
            return match admit(&linear, states, &piece, PieceState { forces, twist }) {
                Verdict::Holds(found) => Some(Found { slides, ..found }),
                _ => None,
            };
        }
    }
    None
}
