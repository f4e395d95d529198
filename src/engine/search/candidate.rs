//! Solves the linear problem of proposed contact states and checks their conditions, whichever method of the search proposes them. A condition is an
//! inequality `value >= 0` on force or stretch, such as F_n >= 0 of a closed contact. Its rounding scale (`size`) is the magnitude of the terms of
//! `value`, to which the rounding error is proportional. Drives (springs of joints and tendons) are treated like contacts.

use core::cell::OnceCell;

use nalgebra::{Matrix, SVector};

use super::answer::SearchSolution;
use crate::contact::{MOST_SLACK, SpringState, State, ZERO_SLACK};
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{IntoList, Vector, add_times, chosen, least_distance, mapped};
use crate::object::{ForcesAndTwist, LinearProblem, Problem, largest_force};
use crate::prelude::*;

/// Result of the check of proposed contact states.
#[derive(Debug, Clone)]
pub(crate) enum CandidateOutcome {
    Holds(SearchSolution),
    Violated {
        /// True if the violation of a condition may be rounding. The violation then does not prove that these states have no equilibrium.
        doubtful: bool,
    },
    /// No forces balance the load in these contact states.
    Unbalanced,
}

/// Solves the linear problem of these contact states for forces and twist, and checks every inequality of the states.
pub(crate) fn try_states(problem: &Problem, states: Vec<State>) -> CandidateOutcome {
    if problem.locals().zip(&states).any(|(local, state)| local.excludes(state)) {
        return CandidateOutcome::Violated { doubtful: false };
    }
    let linear_problem = LinearProblem::new(problem, &states);
    match linear_problem.solve(problem.sites, &problem.offsets, problem.load()) {
        Ok(state) => match admit(problem, states, &linear_problem, state) {
            Ok(found) => CandidateOutcome::Holds(found),
            Err(RejectedStates { doubtful, .. }) => CandidateOutcome::Violated { doubtful },
        },
        Err(_) => CandidateOutcome::Unbalanced,
    }
}

/// Proposed contact states whose solution `at` breaks a condition, or does not balance the load.
pub(super) struct RejectedStates {
    pub(super) states: Vec<State>,
    pub(super) at: ForcesAndTwist,
    /// True if the violation of a condition may be rounding. The violation then does not prove that these states have no equilibrium.
    doubtful: bool,
}

/// Checks every inequality of the contact laws for the solution `at`: forces and twist that solve `linear_problem` in these contact states. If the
/// solution is not unique and breaks an inequality, another solution that satisfies all inequalities is returned, if one exists. The error holds the
/// rejected states.
pub(super) fn admit(
    problem: &Problem,
    states: Vec<State>,
    linear_problem: &LinearProblem,
    at: ForcesAndTwist,
) -> Result<SearchSolution, RejectedStates> {
    let mut worst = violation(problem, &states, &at);
    let growth = OnceCell::new();
    // The factor by which the linear problem amplifies rounding errors costs as much as the factorisation. Most checks do not need this factor,
    // so it is computed on demand.
    let exceeds = |worst: f64, part: f64| {
        // A relative violation above `MOST_SLACK` exceeds every tolerance, however badly conditioned the linear problem is.
        worst > MOST_SLACK || worst > part && worst > part * growth.get_or_init(|| linear_problem.growth())
    };
    let mut shifted = None;
    let free_motions = linear_problem.free_motions().to_vec();
    let neutral_motions = linear_problem.neutral_motions();
    // An inequality counts as satisfied if its value, divided by its rounding scale, is not more negative than a tolerance. The tolerance is
    // `ZERO_SLACK`, times the factor by which the linear problem amplifies rounding errors. It is needed because in symmetric grasps a value is often
    // exactly zero, and is computed as a few roundings of 1e-16.
    if exceeds(worst, ZERO_SLACK) && !(free_motions.is_empty() && neutral_motions.is_empty()) {
        // In these contact states the solution is not unique. The solution of least norm violates an inequality, but another solution may
        // satisfy all inequalities.
        let mut motions = mapped(&free_motions, &|v| (v.clone(), vec![SVector::zeros(); problem.len()]));
        motions.extend(mapped(&neutral_motions, &|v| (v.clone(), linear_problem.forces_along(problem, v))));
        let (values, sizes) = slacks(problem, &states, &at);
        if let Some(tau) = least_admissible_shift(problem, &states, &values, &sizes, &motions) {
            let there = shifted.insert(at.clone());
            for ((motion, along), tau) in motions.iter().zip(tau.iter()) {
                there.twist += motion * *tau;
                add_times(&mut there.forces, along, *tau);
            }
            // The solution has been shifted to another solution. Violations are divided by the rounding scales before the shift. A shift so long that
            // its rounding exceeds the tolerance is thus refused.
            let values = slacks(problem, &states, there).0;
            worst = values.iter().zip(&sizes).fold(0.0, |worst, (value, size)| worse(worst, *value, *size));
        }
    }
    if exceeds(worst, ZERO_SLACK) {
        // A violation above the tolerance, but below 1e-12 times the amplification of rounding errors, may or may not be rounding. The proposed
        // contact states are refused, but they are marked as doubtful, so that the refusal counts as no proof.
        return Err(RejectedStates { states, at, doubtful: !exceeds(worst, 1e-12) });
    }
    let there = shifted.as_ref().unwrap_or(&at);
    // Contact forces that leave an imbalance of more than 1e-11 of their magnitudes are no solution. In well-conditioned problems the imbalance is
    // about 1e-15.
    if out_of_balance(problem, &there.forces, &there.twist) > 1e-11 {
        return Err(RejectedStates { states, at, doubtful: true });
    }
    let ForcesAndTwist { forces, twist } = shifted.unwrap_or(at);
    Ok(SearchSolution { free_motions, neutral_motions, ..SearchSolution::new(states, forces, twist) })
}

/// Returns the solution if it satisfies every condition of the contact states. The linear problem must be regular and well conditioned: the tolerance
/// does not allow for an amplification of rounding errors.
pub(super) fn admit_regular(
    problem: &Problem,
    states: Vec<State>,
    state: ForcesAndTwist,
) -> Option<SearchSolution> {
    let mut holds = true;
    for_each_condition(problem, &states, &state.forces, &state.twist, &mut |value, size| {
        // For NaN the comparison is false, so the contact states are refused.
        holds &= value >= -ZERO_SLACK * size;
    });
    holds.then(|| SearchSolution::new(states, state.forces, state.twist))
}

/// The contacts and drives that break a condition of their states by more than rounding, by index in ascending order.
pub(super) fn breaking(problem: &Problem, states: &[State], at: &ForcesAndTwist) -> Vec<usize> {
    let largest = problem.largest_force(&at.forces, &at.twist);
    let norm = problem.size_of_motion(&at.twist, largest);
    let breaks = |contact: &usize| {
        let force = &at.forces[*contact];
        let (mut holds, at) = (true, problem.at_moved((*contact, force), &at.twist, norm, largest));
        problem.local(*contact).for_each_condition(&states[*contact], &at, &mut |value, size| {
            holds &= value >= -ZERO_SLACK * size;
        });
        !holds
    };
    chosen(problem.len(), &breaks)
}

/// Calls `visit(value, size)` for every condition `value >= 0` of the states of all contacts and drives; `size` is the rounding scale of `value`.
pub(crate) fn for_each_condition(
    problem: &Problem,
    states: &[State],
    forces: &[SVector<f64, 3>],
    twist: &Vector,
    visit: &mut dyn FnMut(f64, f64),
) {
    let largest = problem.largest_force(forces, twist);
    let norm = problem.size_of_motion(twist, largest);
    for (contact, (state, force)) in states.iter().zip(forces).enumerate() {
        let at = problem.at_moved((contact, force), twist, norm, largest);
        problem.local(contact).for_each_condition(state, &at, visit);
    }
}

/// The norm of the imbalance `Σ G_i F_i + W` of contact forces F_i (grasp maps G_i) and load W, divided by its rounding scale. This scale is the sum
/// of the norms of the contact forces, plus the larger of the load and the largest contact force. If commands alone move a statically determinate
/// grasp, its exact forces are zero, and the computed forces are rounding errors. The largest force is therefore at least the fraction `NO_FORCE` of
/// the force that the displacements could cause in the softest spring.
fn out_of_balance(problem: &Problem, forces: &[SVector<f64, 3>], twist: &Vector) -> f64 {
    let (left, carried) = problem.imbalance(forces);
    let size = problem.largest_force(forces, twist) + carried;
    if size > 0.0 { left / size } else { 0.0 }
}

/// Values of the inequalities of all contacts and drives, which should not be negative, and for each value its rounding scale.
fn slacks(problem: &Problem, states: &[State], at: &ForcesAndTwist) -> (Vec<f64>, Vec<f64>) {
    let (mut values, mut sizes) = (Vec::new(), Vec::new());
    for_each_condition(problem, states, &at.forces, &at.twist, &mut |value, size| {
        values.push(value);
        sizes.push(size);
    });
    (values, sizes)
}

/// The largest violation of an inequality by any contact or drive, divided by its rounding scale. Zero if all inequalities hold, infinite if a value
/// is NaN.
fn violation(problem: &Problem, states: &[State], at: &ForcesAndTwist) -> f64 {
    let mut worst = 0.0;
    for_each_condition(problem, states, &at.forces, &at.twist, &mut |value, size| {
        worst = worse(worst, value, size);
    });
    worst
}

fn worse(worst: f64, value: f64, size: f64) -> f64 {
    if value.is_nan() { f64::INFINITY } else { worst.max(-value / size) }
}

/// The shortest shift of a solution after which the inequalities of all contact states hold. Returns its coefficients τ_k, of least norm: the object
/// moves by `Σ τ_k · motion_k`. Each entry of `motions` is such a motion with the change of all contact forces along it; the motions are orthonormal
/// in the engine's coordinates. `None` if no shift satisfies the inequalities.
fn least_admissible_shift(
    problem: &Problem,
    states: &[State],
    values: &[f64],
    sizes: &[f64],
    motions: &[(Vector, Vec<SVector<f64, 3>>)],
) -> Option<Vec<f64>> {
    let mut rows: Vec<_> =
        values.iter().zip(sizes).map(|(value, size)| (value / size, vec![0.0; motions.len()])).list();
    let at_rest = vec![SVector::zeros(); problem.len()];
    for (k, (motion, along)) in motions.iter().enumerate() {
        let forces = along.iter().map(Matrix::norm);
        let largest = largest_force(problem.sites, &at_rest, motion, problem.wrench.norm(), forces);
        let mut i = 0;
        for (contact, (state, force)) in states.iter().zip(along).enumerate() {
            let site = &problem.sites[contact];
            let stretch = -site.map.tr_mul(motion);
            let at = SpringState { stretch, force, span: site.span(&SVector::zeros(), motion), largest };
            problem.local(contact).for_each_condition(state, &at, &mut |rate, rate_size| {
                // `rate` is the change of an inequality's value under a unit motion. A rate up to the fraction `SOLVED_ROUNDING` of its rounding
                // scale is taken as zero. If such a rate were kept, a very long motion could seem to satisfy the inequality.
                if rate.abs() > SOLVED_ROUNDING * rate_size {
                    rows[i].1[k] = rate / sizes[i];
                }
                i += 1;
            });
        }
    }
    rows.retain(|(_, rates)| rates.iter().any(|rate| *rate != 0.0));
    least_distance(rows)
}
