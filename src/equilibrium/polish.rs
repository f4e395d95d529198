//! From the polygon to the round cone: Newton's method on the return map, every contact free to change its state.
//!
//! Given the twist q each contact's force is explicit (`formulation/return_map`), so equilibrium is d equations
//!
//! ```text
//! R(q) = Σ G_i F_i(a_i - G_iᵀq) + W = 0,      dR = -(Σ G_i C_i G_iᵀ) dq
//! ```
//!
//! piecewise smooth, with the tangent stiffness C_i of each contact. From the twist of a polygon's answer a few steps do. The
//! last one is made on the piece: there the contacts are springs again, and the oblique projection gives forces that
//! balance to the last digits whatever the stiffness ratios.

use nalgebra::{SMatrix, SVector};

use super::candidate::{Found, Verdict, admit, try_states};
use super::slack::largest_force;
use crate::formulation::{FullPivot, Law, Piece, PieceState, Problem, Returned, Slide, State, respond};

/// A tiny friction force may still turn when all others have settled: it is then off its cone by the square of the angle. This
/// part of the largest force is rounding.
const ON_THE_CONE: f64 = 1e-14;
/// Newton's steps: it converges in a few of them or goes round in circles.
const STEPS: usize = 20;
/// A step must take away this part of the share of the imbalance that its length promises.
const GAIN: f64 = 0.1;
/// Shorter parts of a step than this are not tried.
const SHORTEST: f64 = 1e-3;
/// Steps on the piece: where Newton has converged the first is the last.
const FINISHING_STEPS: usize = 12;
/// A step that changes forces by less than this part of them is the last: what it leaves is the square of this.
const SETTLED: f64 = 1e-9;

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
pub(super) fn solution_near<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    states: &[State],
) -> Option<PieceState<D, C>> {
    match try_states(problem, states.to_vec()) {
        Verdict::Holds(found) => Some(PieceState { forces: found.forces, twist: found.twist }),
        Verdict::Violated { .. } => Piece::new(problem, states).solve(&problem.drives, &problem.wrench).ok(),
        Verdict::Unbalanced => None,
    }
}

/// The solution on the round cone near one on the polygon, if Newton's method finds it.
pub(crate) fn polish<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    near: &PieceState<D, C>,
) -> Option<Found<D, C>> {
    // On the pieces alone where stiffnesses lie so far apart that noise decides what Newton's matrix resists.
    let found = newton(problem, near.twist)
        .and_then(|twist| finish(problem, twist))
        .or_else(|| finish(problem, near.twist))?;
    let change = found.forces.iter().zip(&near.forces).map(|(round, polygon)| (round - polygon).norm());
    Some(Found { from_polygon: Some(change.fold(0.0, f64::max)), ..found })
}

/// Newton's method until forces settle. A step that leaves more out of balance than before is halved: without that it jumps
/// to and fro between two states of a contact. Where no shorter one does better the whole one is made.
fn newton<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    mut twist: SVector<f64, D>,
) -> Option<SVector<f64, D>> {
    let mut here = tangent(problem, &twist);
    for _ in 0..STEPS {
        let (step, _) = FullPivot::new(here.stiffness, D, D).solve(&here.left);
        if here.left.norm() <= SETTLED * here.size {
            return Some(twist + step);
        }
        let (mut part, mut next) = (1.0, tangent(problem, &(twist + step)));
        let whole = next.clone();
        while next.left.norm() > (1.0 - GAIN * part) * here.left.norm() && part > SHORTEST {
            part *= 0.5;
            next = tangent(problem, &(twist + step * part));
        }
        if part <= SHORTEST {
            (part, next) = (1.0, whole);
        }
        twist += step * part;
        here = next;
        if !here.left.norm().is_finite() {
            return None;
        }
    }
    None
}

/// R(q), the sizes of its terms and -dR/dq.
#[derive(Debug, Clone)]
struct Tangent<const D: usize> {
    left: SVector<f64, D>,
    size: f64,
    stiffness: SMatrix<f64, D, D>,
}

fn tangent<const D: usize, const C: usize>(problem: &Problem<D, C>, twist: &SVector<f64, D>) -> Tangent<D> {
    let left = problem.wrench;
    let mut t = Tangent { left, size: left.norm(), stiffness: SMatrix::zeros() };
    for (i, site) in problem.sites.iter().enumerate() {
        let stretch = problem.drives[i] - site.map.tr_mul(twist);
        match respond(problem, i, &stretch) {
            Returned::Open => {}
            Returned::Rolling(force) => {
                t.left += site.map * force;
                t.size += force.norm();
                for a in 0..site.axes {
                    let g = site.map.column(a);
                    t.stiffness.ger(site.k[a], &g, &g, 1.0);
                }
            }
            Returned::Sliding(force, slide) => {
                t.left += site.map * force;
                t.size += force.norm();
                let mut pushed = slide.pull() * site.mu;
                pushed[0] = 1.0;
                t.stiffness.ger(site.k[0], &(site.map * pushed), &site.map.column(0), 1.0);
                let (across, held) = slide.across();
                let g = site.map * across;
                t.stiffness.ger(held, &g, &g, 1.0);
            }
        }
    }
    t
}

/// Steps on the piece of the present slides until forces settle.
fn finish<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    mut twist: SVector<f64, D>,
) -> Option<Found<D, C>> {
    let n = problem.len();
    // Facets play no part in it.
    let mut linear = Problem {
        polygon: problem.polygon.clone(),
        turned: Vec::new(),
        laws: problem.laws.clone(),
        drives: problem.drives.clone(),
        slips: problem.slips.clone(),
        ..*problem
    };
    let mut forces = vec![SVector::<f64, C>::zeros(); n];
    let mut states = vec![State::Open; n];
    let mut slides: Vec<Option<Slide<C>>> = vec![None; n];
    for _ in 0..FINISHING_STEPS {
        let mut drives = problem.drives.clone();
        for (i, site) in problem.sites.iter().enumerate() {
            drives[i] -= site.map.tr_mul(&twist);
            slides[i] = None;
            states[i] = match respond(problem, i, &drives[i]) {
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
        let solved = piece.solve(&drives, &problem.wrench).ok()?;
        twist += solved.twist;
        let change = solved.forces.iter().zip(&forces).map(|(new, old)| (new - old).norm());
        let sizes = solved.forces.iter().map(nalgebra::Matrix::norm);
        let largest = largest_force(problem.sites, &problem.drives, &twist, problem.wrench.norm(), sizes);
        let on_cone = |i: usize| {
            let (f, r) = (&solved.forces[i], problem.sites[i].mu * solved.forces[i][0]);
            matches!(problem.laws[i], Law::Edge(_))
                || slides[i].is_none()
                || (f[1].hypot(f[2]) - r).abs() <= ON_THE_CONE * largest.max(r)
        };
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
