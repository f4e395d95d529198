//! A proposal of contact states, solved and checked: the only way to an answer, whoever proposed.

use nalgebra::{DMatrix, DVector, SVector};

use super::slack::for_each_slack;
use crate::formulation::{Law, Piece, Problem, State};
use crate::lcp::{Lcp, Outcome};

/// Inequalities may be violated by this much of their size, times the growth of errors in the piece. Ties are the
/// normal case in symmetric grasps: a slack that is exactly zero comes out as a few roundings of 1e-16.
const ROUNDING: f64 = 5e-14;
/// Errors are not believed to grow beyond this, whatever the condition of the piece.
const MOST_ROUNDING: f64 = 1e-10;
/// A violation below this (times growth) is neither rounding nor clearly a violation: the proposal is not accepted,
/// but nothing may be concluded from its failure either.
const DOUBTFUL: f64 = 1e-12;

/// A solution of the local problem.
#[derive(Debug, Clone)]
pub(crate) struct Found<const D: usize, const C: usize> {
    pub(crate) states: Vec<State>,
    pub(crate) forces: Vec<SVector<f64, C>>,
    pub(crate) twist: SVector<f64, D>,
    pub(crate) free_motions: Vec<SVector<f64, D>>,
    pub(crate) neutral_motions: Vec<SVector<f64, D>>,
}

/// What became of a proposal.
#[derive(Debug, Clone)]
pub(crate) enum Verdict<const D: usize, const C: usize> {
    Holds(Found<D, C>),
    Violated {
        /// So close that rounding could have done it.
        doubtful: bool,
    },
    /// No forces of these states balance the load.
    Unbalanced,
}

/// Solves the piece with these states and checks every inequality.
pub(crate) fn try_states<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    states: Vec<State>,
) -> Verdict<D, C> {
    let impossible = |(i, state): (usize, &State)| match state {
        State::Open => problem.laws[i] != Law::Absent && !problem.may_open(i),
        State::Sliding { .. } => problem.sites[i].mu.is_infinite(),
        State::Rolling => false,
    };
    if states.iter().enumerate().any(impossible) {
        return Verdict::Violated { doubtful: false };
    }
    let piece = Piece::new(problem, &states);
    let Ok(mut state) = piece.solve(&problem.drives, &problem.wrench) else {
        return Verdict::Unbalanced;
    };
    let rounding = (ROUNDING * piece.growth()).min(MOST_ROUNDING);
    let mut worst = violation(problem, &states, &state.forces, &state.twist);
    let free_motions = piece.free_motions().to_vec();
    let neutral_motions = piece.neutral_motions();
    if worst > rounding && !(free_motions.is_empty() && neutral_motions.is_empty()) {
        // The piece has a whole family of solutions, and the one of least norm is not admissible: is another?
        let motions: Vec<_> = free_motions.iter().chain(&neutral_motions).copied().collect();
        if let Some(shift) =
            least_admissible_shift(problem, &piece, &states, &state.forces, &state.twist, &motions)
        {
            state.twist += shift;
            for (f, change) in state.forces.iter_mut().zip(piece.forces_along(problem, &shift)) {
                *f += change;
            }
            worst = violation(problem, &states, &state.forces, &state.twist);
        }
    }
    if worst > rounding {
        return Verdict::Violated { doubtful: worst <= (DOUBTFUL * piece.growth()).min(MOST_ROUNDING) };
    }
    Verdict::Holds(Found { states, forces: state.forces, twist: state.twist, free_motions, neutral_motions })
}

/// The worst violation of an inequality, relative to its size.
fn violation<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    states: &[State],
    forces: &[SVector<f64, C>],
    twist: &SVector<f64, D>,
) -> f64 {
    let mut worst = 0.0_f64;
    for_each_slack(problem, states, &problem.drives, forces, twist, |value, size| {
        if value.is_nan() {
            worst = f64::INFINITY;
        } else if value < 0.0 {
            worst = worst.max(-value / size);
        }
    });
    worst
}

/// The smallest combination of motions (orthonormal, inside coordinates) that makes every inequality hold:
///
/// ```text
/// min ½|τ|²  with  b + A τ >= 0      ⟺      0 <= λ ⟂ A Aᵀ λ + b >= 0,   τ = Aᵀλ
/// ```
///
/// AAᵀ is positive semidefinite, so Lemke finds λ whenever the inequalities can be met.
fn least_admissible_shift<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    piece: &Piece<D, C>,
    states: &[State],
    forces: &[SVector<f64, C>],
    twist: &SVector<f64, D>,
    motions: &[SVector<f64, D>],
) -> Option<SVector<f64, D>> {
    let (mut b, mut sizes) = (Vec::new(), Vec::new());
    for_each_slack(problem, states, &problem.drives, forces, twist, |value, size| {
        b.push(value / size);
        sizes.push(size);
    });
    let at_rest = vec![SVector::zeros(); problem.len()];
    let mut a = DMatrix::zeros(b.len(), motions.len());
    for (k, motion) in motions.iter().enumerate() {
        let along = piece.forces_along(problem, motion);
        let mut i = 0;
        for_each_slack(problem, states, &at_rest, &along, motion, |value, _| {
            a[(i, k)] = value / sizes[i];
            i += 1;
        });
    }
    let lcp = Lcp::new(&a * a.transpose(), DVector::from_vec(b)).ok()?;
    let Outcome::Solved(solution) = lcp.solve() else { return None };
    let tau = a.tr_mul(&solution.z);
    Some(motions.iter().zip(tau.iter()).fold(SVector::zeros(), |sum, (v, t)| sum + v * *t))
}
