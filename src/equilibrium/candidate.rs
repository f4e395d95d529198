//! A proposal of contact states, solved and checked: the only way to an answer, whoever proposed.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector, SVector};

use super::only_lemke;
use super::slack::{There, for_each_slack, scene_force};
use crate::formulation::{Law, Piece, PieceState, Problem, Slide, State};
use crate::lcp::{Lcp, Outcome};

/// Inequalities may be violated by this much of their size, times the growth of errors in the piece. Ties are the
/// normal case in symmetric grasps: a slack that is exactly zero comes out as a few roundings of 1e-16.
const ROUNDING: f64 = 5e-14;
/// Errors are not believed to grow beyond this, whatever the condition of the piece.
const MOST_ROUNDING: f64 = 1e-10;
/// A violation below this (times growth) is neither rounding nor clearly a violation: the proposal is not accepted,
/// but nothing may be concluded from its failure either.
const DOUBTFUL: f64 = 1e-12;

/// A rate of an inequality along a unit motion below this part of its size is rounding of zero.
const UNFELT: f64 = 1e-12;
/// A shift is sought for so many inequalities at once.
const ALL_AT_ONCE: usize = 200;
/// Forces that fail to balance the load by more than this part of their sizes are no solution; the pieces reach 1e-15.
const OUT_OF_BALANCE: f64 = 1e-11;

/// A solution of the local problem.
#[derive(Debug, Clone)]
pub(crate) struct Found<const D: usize, const C: usize> {
    pub(crate) states: Vec<State>,
    pub(crate) forces: Vec<SVector<f64, C>>,
    pub(crate) twist: SVector<f64, D>,
    pub(crate) free_motions: Vec<SVector<f64, D>>,
    pub(crate) neutral_motions: Vec<SVector<f64, D>>,
    /// On a path, sizes of the forces and displacements that these are sums of: what rounding is measured against where
    /// they vanish. Zero for a solution of its own.
    pub(crate) sizes: [f64; 2],
    /// On the round cone, how each contact slides; empty where the states are those of a polygon.
    pub(crate) slides: Vec<Option<Slide<C>>>,
    /// On the round cone, the largest change of a contact force from the polygon's answer.
    pub(crate) from_polygon: Option<f64>,
    /// The piece that it solves, where that is at hand.
    pub(crate) piece: Option<Arc<Piece<D, C>>>,
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
    match piece.solve(problem.sites, &problem.drives, problem.load()) {
        Ok(state) => match admit(problem, states, &piece, state) {
            Verdict::Holds(found) => Verdict::Holds(Found { piece: Some(Arc::new(piece)), ..found }),
            other => other,
        },
        Err(_) => Verdict::Unbalanced,
    }
}

/// Checks every inequality for a solution of the piece with these states.
pub(super) fn admit<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    states: Vec<State>,
    piece: &Piece<D, C>,
    mut state: PieceState<D, C>,
) -> Verdict<D, C> {
    let rounding = (ROUNDING * piece.growth()).min(MOST_ROUNDING);
    let doubtful = (DOUBTFUL * piece.growth()).min(MOST_ROUNDING);
    let (values, sizes) = slacks(problem, &states, &state.forces, &state.twist);
    let mut worst = violation(&values, &sizes);
    let free_motions = piece.free_motions().to_vec();
    let neutral_motions = piece.neutral_motions();
    if worst > rounding && !(free_motions.is_empty() && neutral_motions.is_empty()) {
        // The piece has a whole family of solutions, and the one of least norm is not admissible: is another?
        let free = free_motions.iter().map(|v| (*v, vec![SVector::zeros(); problem.len()]));
        let neutral = neutral_motions.iter().map(|v| (*v, piece.forces_along(problem, v)));
        let motions: Vec<_> = free.chain(neutral).collect();
        if let Some(tau) = least_admissible_shift(problem, &states, &values, &sizes, &motions) {
            for ((motion, along), tau) in motions.iter().zip(tau.iter()) {
                state.twist += motion * *tau;
                for (f, change) in state.forces.iter_mut().zip(along) {
                    *f += change * *tau;
                }
            }
            // Against the sizes of before: a shift so long that its own rounding shows is none.
            worst = violation(&slacks(problem, &states, &state.forces, &state.twist).0, &sizes);
        }
    }
    if worst > rounding {
        return Verdict::Violated { doubtful: worst <= doubtful };
    }
    if out_of_balance(problem, &state.forces, &state.twist) > OUT_OF_BALANCE {
        return Verdict::Violated { doubtful: true };
    }
    let sizes = [0.0; 2];
    Verdict::Holds(Found {
        states,
        forces: state.forces,
        twist: state.twist,
        free_motions,
        neutral_motions,
        sizes,
        slides: Vec::new(),
        from_polygon: None,
        piece: None,
    })
}

/// The same for balanced forces of sliding contacts on the round cone, where the piece is regular: it has one solution,
/// and rounding does not grow in it.
pub(super) fn admit_sliding<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    states: Vec<State>,
    slides: Vec<Option<Slide<C>>>,
    state: PieceState<D, C>,
    largest: f64,
) -> Option<Found<D, C>> {
    let mut holds = true;
    for (contact, slide) in slides.iter().enumerate() {
        let there = There {
            drive: &problem.drives[contact],
            force: &state.forces[contact],
            twist: &state.twist,
            largest,
        };
        let facet = slide.as_ref().map(|slide| std::slice::from_ref(&slide.direction));
        let normals = facet.unwrap_or_else(|| problem.normals(contact));
        // Written so that it also turns away what is not a number.
        there.for_each_slack(problem, contact, states[contact], normals, |value, size| {
            holds &= value >= -ROUNDING * size;
        });
    }
    holds.then(|| Found {
        states,
        forces: state.forces,
        twist: state.twist,
        free_motions: Vec::new(),
        neutral_motions: Vec::new(),
        sizes: [0.0; 2],
        slides,
        from_polygon: None,
        piece: None,
    })
}

/// `|Σ G_i F_i + W|` over the sum of the sizes of its terms. Where commands alone move a statically determinate grasp
/// no force changes, and what is left of the forces is noise: it is not measured against itself.
fn out_of_balance<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    forces: &[SVector<f64, C>],
    twist: &SVector<f64, D>,
) -> f64 {
    let (left, carried) = imbalance(problem, forces);
    let size = scene_force(problem, forces, twist) + carried;
    if size > 0.0 { left / size } else { 0.0 }
}

/// `|Σ G_i F_i + W|` and `Σ |F_i|`.
pub(super) fn imbalance<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    forces: &[SVector<f64, C>],
) -> (f64, f64) {
    let (mut sum, mut carried) = (problem.wrench, 0.0);
    for (site, force) in problem.sites.iter().zip(forces) {
        sum += site.map * force;
        carried += force.norm();
    }
    (sum.norm(), carried)
}

/// Values and sizes of all inequalities.
fn slacks<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    states: &[State],
    forces: &[SVector<f64, C>],
    twist: &SVector<f64, D>,
) -> (Vec<f64>, Vec<f64>) {
    let (mut values, mut sizes) = (Vec::new(), Vec::new());
    for_each_slack(problem, states, &problem.drives, forces, twist, |value, size| {
        values.push(value);
        sizes.push(size);
    });
    (values, sizes)
}

/// The worst violation of an inequality, relative to its size.
fn violation(values: &[f64], sizes: &[f64]) -> f64 {
    let mut worst = 0.0_f64;
    for (value, size) in values.iter().zip(sizes) {
        if value.is_nan() {
            return f64::INFINITY;
        }
        worst = worst.max(-value / size);
    }
    worst
}

/// The smallest combination τ of motions (orthonormal, inside coordinates; each with its change of forces) that makes
/// every inequality hold:
///
/// ```text
/// min ½|τ|²  with  b + A τ >= 0      ⟺      0 <= λ ⟂ A Aᵀ λ + b >= 0,   τ = Aᵀλ
/// ```
///
/// AAᵀ is positive semidefinite, so Lemke finds λ whenever the inequalities can be met.
fn least_admissible_shift<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    states: &[State],
    values: &[f64],
    sizes: &[f64],
    motions: &[(SVector<f64, D>, Vec<SVector<f64, C>>)],
) -> Option<DVector<f64>> {
    let b = DVector::from_iterator(values.len(), values.iter().zip(sizes).map(|(value, size)| value / size));
    let at_rest = vec![SVector::zeros(); problem.len()];
    let mut a = DMatrix::zeros(b.len(), motions.len());
    for (k, (motion, along)) in motions.iter().enumerate() {
        let mut i = 0;
        for_each_slack(problem, states, &at_rest, along, motion, |rate, rate_size| {
            // An inequality that the motion does not feel must not become one that a very long motion satisfies.
            if rate.abs() > UNFELT * rate_size {
                a[(i, k)] = rate / sizes[i];
            }
            i += 1;
        });
    }
    let least = |rows: &[usize]| {
        let (a, b) = (a.select_rows(rows), b.select_rows(rows));
        let lcp = Lcp::new(&a * a.transpose(), b).ok()?;
        let Outcome::Solved(solution) = lcp.solve_with(&only_lemke()) else { return None };
        Some(a.tr_mul(&solution.z))
    };
    if b.len() <= ALL_AT_ONCE {
        return least(&(0..b.len()).collect::<Vec<_>>());
    }
    // A few of many inequalities decide: those that the shift for the others leaves most violated join them.
    let mut rows = Vec::new();
    let mut left = b.clone();
    loop {
        let joins = (0..b.len()).filter(|&i| left[i] < 0.0 && !rows.contains(&i));
        let mut joins: Vec<usize> = joins.collect();
        joins.sort_by(|&i, &j| left[i].total_cmp(&left[j]));
        joins.truncate(D);
        if joins.is_empty() || rows.len() > ALL_AT_ONCE {
            return least(&rows);
        }
        rows.extend(joins);
        left = &b + &a * least(&rows)?;
    }
}
