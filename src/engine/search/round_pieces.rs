//! Newton's method in forces and twist together on the round cone. Each step solves the linear problem of the present contact states.
//!
//! The force of a spring 1e10 times as stiff as the others is 1e10 times as sensitive to the twist. If it were computed from the twist alone
//! (`object/newton`), its rounding error would determine the contact state. Here forces are unknowns, too. The linear problem of the present contact
//! states is solved in twice the working precision (`object/correction`). Then contacts whose inequalities fail change their states.

use nalgebra::SVector;

use super::answer::SearchSolution;
use super::candidate::{admit, admit_regular};
use crate::contact::{LocalLaw, Mode, Slide, State, tangential, tangential_norm};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{IntoList, Vector, by_axis};
use crate::object::{ForcesAndTwist, LinearProblem, PreciseTwist, Problem, newton_on_cones};
use crate::prelude::*;

/// An iterate of Newton's method: contact states, forces and a twist. Forces and twist need not solve the linear problem of these contact states yet.
#[derive(Debug, Clone)]
pub(super) struct RoundPieces {
    states: Vec<State>,
    forces: Vec<SVector<f64, 3>>,
    /// The twist in twice the working precision: the slip of a stiff contact may be smaller than the working-precision rounding error of the twist.
    twist: PreciseTwist,
}

/// How much forces and twist changed in a Newton step: each flag is true if the changes were at most the bounds given for it.
struct NewtonChange {
    /// The twist changed by at most 1e-14 of its norm, and each force by at most 1e-14 of itself plus 1e-20 of the largest force.
    sharp: bool,
    /// The twist and each force changed by at most 1e-8 of themselves, so that the directions of friction have hardly turned.
    near: bool,
    /// Each force changed by at most 1e-8 of itself plus 1e-15 of the largest force, its rounding error.
    settled: bool,
}

impl RoundPieces {
    /// Newton's method on the twist, from the initial twist `from`, in which every contact may change its state; `None` if it does not converge.
    pub(super) fn by_newton(problem: &Problem, from: Vector) -> Option<Self> {
        let mut contacts = Vec::new();
        // Newton's method on the twist ends once the imbalance is at most the fraction `NEGLIGIBLE` of the forces. The caller's Newton steps in
        // forces and twist remove the rest of the imbalance.
        let (twist, ..) = newton_on_cones(problem, (from, NEGLIGIBLE), &mut contacts)?;
        let (states, forces) = contacts.iter().map(|at| (at.state, at.force)).unzip();
        Some(Self { states, forces, twist: PreciseTwist::new(problem.size(), twist) })
    }

    /// The start from a solution with polygonal friction cones: its contact states are converted to states on round cones.
    pub(super) fn on_polygons(problem: &Problem, states: &[State], near: &ForcesAndTwist) -> Self {
        let state = |(local, (state, force)): (LocalLaw<'_>, (&State, &SVector<f64, 3>))| {
            if state.slides() && !local.is_on_an_edge() {
                // Without a friction force the direction of sliding is unknown, so the contact is taken as sticking.
                let rubs = local.may_slide() && tangential(force).amax() > 0.0;
                return if rubs { Mode::Round(Slide::new(force, 0.0)) } else { Mode::Sticking };
            }
            // At the apex of a polygonal cone (zero force) a contact may be in the state `Open` although its law keeps it closed. Such a contact is
            // taken as sticking.
            if state.is_open() && local.excludes(state) { Mode::Sticking } else { *state }
        };
        let states = problem.locals().zip(states.iter().zip(&near.forces)).map(state).list();
        Self {
            states,
            forces: near.forces.clone(),
            twist: PreciseTwist::new(problem.size(), near.twist.clone()),
        }
    }

    /// Newton's method until the forces of all contacts are correct to the last digit. `None` if it does not converge, or if the converged solution
    /// breaks a condition of a contact's state.
    pub(super) fn solve(mut self, problem: &Problem) -> Option<SearchSolution> {
        let driven = problem.offsets.iter().map(SVector::norm).fold(self.twist.value().norm(), f64::max);
        let mut linear_problem = LinearProblem::new(problem, &self.states);
        // Upper limit of the number of Newton steps: as a rule the method converges in a few steps, or not at all.
        let most_steps = 20;
        for step in 1..=most_steps {
            let NewtonChange { sharp, near, settled } = self.step(problem, &linear_problem);
            // A twist longer than 1e12 times the initial twist and offsets (commands minus clearances) is refused, since hardly a digit of the
            // contacts' stretches is then correct. Near a contact angle at which an object jams (wedges itself between contacts), Newton steps may
            // lead to such a twist although an equilibrium exists. Other methods of the search may find this equilibrium.
            if self.twist.value().norm() > 1e12 * driven {
                return None;
            }
            let last = (sharp || step == most_steps && settled) && self.on_cones(problem);
            if last && let Some(found) = self.admitted(problem, &linear_problem) {
                return Some(found);
            }
            // If no spring resists some motion, the gaps along this motion are arbitrary until Newton's method has converged. An open contact whose
            // gap vanishes in between is therefore not closed.
            let closing = sharp || linear_problem.free_motions().is_empty();
            let left = self.update_states(problem, closing);
            if sharp && !left {
                return None;
            }
            // A new factorisation is needed if contact states have changed, or if the last step changed forces or twist by more than 1e-8 of
            // themselves (`near` is false). Near the solution the present factorisation is good enough: each step reduces the error by a constant
            // factor.
            if left || !near {
                linear_problem = LinearProblem::new(problem, &self.states);
            }
        }
        None
    }

    /// Whether the friction force equals its limit at every contact that slides on the round cone. False also if such a contact pulls, since its
    /// limit μ F_n is then negative.
    fn on_cones(&self, problem: &Problem) -> bool {
        let largest = problem.largest_force(&self.forces, &self.twist.value());
        problem.locals().zip(&self.states).zip(&self.forces).all(|((local, state), force)| {
            let limit = local.cone().limit(force[0]);
            // A friction force may differ from its limit by 1e-14 of the largest force. A Newton step that turns the friction force by a small angle
            // moves it off the cone by the square of this angle, which is negligible after the last steps.
            state.slide().is_none() || (tangential_norm(force) - limit).abs() <= 1e-14 * largest.max(limit)
        })
    }

    /// One Newton step: adds the corrections of forces and twist that solve the equations of `linear_problem`. Returns how large they are.
    fn step(&mut self, problem: &Problem, linear_problem: &LinearProblem) -> NewtonChange {
        let twist = self.twist.value();
        let largest = problem.largest_force(&self.forces, &twist);
        let missing = linear_problem.correction(problem, &self.states, (&self.forces, &self.twist), largest);
        self.twist.add(&missing.twist);
        let (moved, size) = (missing.twist.norm(), twist.norm());
        // Newton's method has converged if a step changes the twist and each force by at most the fraction `last` of themselves (`sharp`).
        let last = 1e-14;
        // If rounding alone determines the direction of a small force, no step is `sharp`. Then it is enough if each force changes by at most the
        // fraction `little` of itself, plus the rounding error of the largest force (`settled`). Newton's method converges quadratically, so the
        // remaining relative error is only the square of the fraction.
        let little = 1e-8;
        let (mut sharp, mut near, mut settled) = (moved <= last * size, moved <= little * size, true);
        for (force, missing) in self.forces.iter_mut().zip(&missing.forces) {
            *force += missing;
            // `sharp` allows each force a change of 1e-20 of the largest force: below that no force has a correct digit. `settled` allows 1e-15
            // of the largest force, its rounding error. Each contact's change is compared with its own force, since a small force may still turn
            // while large forces have settled.
            sharp &= missing.norm() <= last * force.norm() + 1e-20 * largest;
            near &= missing.norm() <= little * force.norm();
            settled &= missing.norm() <= little * force.norm() + 1e-15 * largest;
        }
        NewtonChange { sharp, near, settled }
    }

    /// The solution with the present contact states, if every inequality holds and forces balance the load; otherwise `None`.
    fn admitted(&self, problem: &Problem, linear_problem: &LinearProblem) -> Option<SearchSolution> {
        let Self { states, forces, twist } = self.clone();
        let at = ForcesAndTwist { forces, twist: twist.value() };
        // After convergence an imbalance can only remain along motions that no spring resists.
        if !linear_problem.resists(&problem.wrench) || !balanced(problem, &at) {
            return None;
        }
        if linear_problem.free_motions().iter().any(|motion| self.turns(problem, motion)) {
            return None;
        }
        let whole = linear_problem.free_motions().is_empty() && linear_problem.neutral_motions().is_empty();
        if whole && states.iter().any(|state| state.slide().is_some()) {
            return admit_regular(problem, states, at);
        }
        admit(problem, states, linear_problem, at).ok()
    }

    /// Whether `motion`, which no spring seems to resist, turns the friction force of a sliding contact. Friction does resist such a motion, but its
    /// resistance is lost in the rounding of the stiffest spring. The component of the solution along this motion is then unknown.
    fn turns(&self, problem: &Problem, motion: &Vector) -> bool {
        problem.sites.iter().zip(&self.states).any(|(site, state)| {
            let turns = |slide: &Slide| slide.perpendicular().dot(&site.map.tr_mul(motion)).abs();
            // For a unit motion, slips below 1e-10 of the largest displacement of the contact are rounding errors.
            state.slide().is_some_and(|slide| turns(slide) > 1e-10 * site.map.norm())
        })
    }

    /// Changes contact states whose inequalities fail, and turns each direction of sliding to the direction of the contact's stretch. Returns true if
    /// a contact changed its kind of state (open, sticking, sliding). Open contacts close only if `closing` is true.
    fn update_states(&mut self, problem: &Problem, closing: bool) -> bool {
        let twist = self.twist.value();
        let largest = problem.largest_force(&self.forces, &twist);
        let mut any = false;
        for contact in 0..problem.len() {
            let site = &problem.sites[contact];
            let precise =
                |axis: usize| self.twist.stretch(site, axis, problem.offsets[contact][axis]).value();
            let stretch = by_axis(precise);
            // The state of a contact changes if an inequality of the state fails by more than the fraction `fails` of its terms.
            let fails = 1e-14;
            let touches = closing && stretch[0] > fails * problem.span(contact, &twist);
            let (state, force) = (self.states[contact], &mut self.forces[contact]);
            let next =
                next_state(&problem.local(contact), &state, force, (&stretch, touches), fails * largest);
            any |= !next.is_kind_of(&state);
            self.states[contact] = next;
        }
        any
    }
}

/// The next state of a contact whose force is `force` and whose stretch is `stretch`. If the contact opens or slides on the round cone, `force` is
/// set to the force in the next state. `touches` is true for an open contact that touches again. Normal and friction forces up to `rounding` are
/// taken as zero.
fn next_state(
    local: &LocalLaw<'_>,
    state: &State,
    force: &mut SVector<f64, 3>,
    (stretch, touches): (&SVector<f64, 3>, bool),
    rounding: f64,
) -> State {
    let opened = |force: &mut SVector<f64, 3>| {
        force.fill(0.0);
        Mode::Open
    };
    match state {
        Mode::Open if touches && local.may_open() => Mode::Sticking,
        Mode::Open => Mode::Open,
        _ if local.may_open() && force[0] < -rounding => opened(force),
        _ if !local.may_slide() => *state,
        _ => {
            // The stretch of a stiff spring is computed from its force: the displacements determine the stretch only up to their rounding error.
            let give = local.springs.deflection(force);
            let known =
                by_axis(|axis| if axis == 0 || state.is_sticking() { give[axis] } else { stretch[axis] });
            let near = state.slide().map_or(0.0, |slide| slide.lambda);
            let answer = local.answer(&known, near);
            let rubs = state.slide().is_some() || tangential_norm(force) > rounding;
            match answer.state {
                Mode::Round(_) => {
                    *force = answer.force;
                    answer.state
                }
                // A contact with a friction force opens if its normal force is zero up to rounding, since without a normal force no friction is
                // possible. A contact without a friction force keeps sticking.
                Mode::Open if local.may_open() && rubs => opened(force),
                _ => Mode::Sticking,
            }
        }
    }
}

/// Whether contact forces balance the load up to rounding. The imbalance is compared with the sum of the norms of the contact forces, plus the load.
/// If there is no load, all forces may be rounding errors. The load is then replaced by the larger of two forces: the largest contact force, and the
/// fraction `NO_FORCE` of the force that the displacements could cause in the softest spring. If there is a load, the twist does not count: compared
/// with the spring force of a huge twist, any imbalance seems small.
fn balanced(problem: &Problem, at: &ForcesAndTwist) -> bool {
    let (left, carried) = problem.imbalance(&at.forces);
    let load = problem.wrench.norm();
    let scale = if load > 0.0 { load } else { problem.largest_force(&at.forces, &at.twist) };
    // Forces may be out of balance by 1e-13 of load and forces, since a load that was itself computed has rounding errors.
    left <= 1e-13 * (scale + carried)
}
