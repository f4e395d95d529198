//! A start for many contacts: semismooth Newton on the return maps.
//!
//! Given the motion q of the object every contact's force is explicit. It sticks, or its force is
//! the nearest one of the cone in the metric of its springs. Equilibrium is then d piecewise linear
//! equations,
//!
//! ```text
//! R(q) = Σ G_i F_i(a_i - G_iᵀq) + W = 0,      T dq = R,   T = Σ G_i (∂F_i/∂v) G_iᵀ
//! ```
//!
//! and where forces balance that is an equilibrium: every inequality of the law is part of the
//! return map. A few steps do at any number of contacts, but it may go round in circles, most often
//! with few contacts, where Lemke's method does not.

use std::ops::Range;

use nalgebra::{SMatrix, SVector};

use super::solution::{BALANCED, Solution};
use crate::contact::{Mode, PolygonState, Tangent};
use crate::grasp::Site;
use crate::numerics::{Bordered, SUMMED_IN_TURN, both, in_halves};
use crate::object::Problem;

/// Steps: it converges in a few of them or goes round in circles.
const STEPS: usize = 16;

/// R, the sizes of its terms and T.
#[derive(Clone, Copy)]
struct Imbalance<const D: usize> {
    left: SVector<f64, D>,
    size: f64,
    stiffness: SMatrix<f64, D, D>,
    /// No contact that is kept closed pulls while it should carry friction.
    lawful: bool,
}

/// The number of steps after which the method has arrived at an equilibrium from the states in
/// which everything sticks. Rates on an edge are not for it.
pub(super) fn newton<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    found: &mut Solution<D, C>,
) -> Option<usize> {
    if problem.locals().any(|local| local.is_on_an_edge()) {
        return None;
    }
    found.twist.fill(0.0);
    found.forces.clear();
    found.states.clear();
    found.forces.resize(problem.len(), SVector::zeros());
    found.states.resize(problem.len(), Mode::Rolling);
    let mut here = stick(problem);
    here.left += problem.wrench;
    for step in 1..=STEPS {
        found.twist += solve(&here.stiffness, &here.left)?;
        here = answer(problem, &found.twist, 0, &mut found.states, &mut found.forces);
        here.left += problem.wrench;
        here.size += problem.wrench.norm() + f64::MIN_POSITIVE;
        found.residual = here.left.norm() / here.size;
        if found.residual <= BALANCED {
            return here.lawful.then_some(step);
        }
        if !found.residual.is_finite() {
            return None;
        }
    }
    None
}

/// R without the load and T where everything sticks and the object has not moved.
fn stick<const D: usize, const C: usize>(problem: &Problem<D, C>) -> Imbalance<D> {
    let part = |contacts: Range<usize>| {
        let mut sum = Imbalance::zero();
        for contact in contacts {
            let (site, local) = (&problem.sites[contact], problem.local(contact));
            let state = local.unjumped();
            if !state.is_open() {
                add_tangent(&mut sum.stiffness, site, &local.tangent(&state));
                sum.left += site.map * local.springs.force(&problem.drives[contact]);
            }
        }
        sum
    };
    in_halves(0..problem.len(), &part, &Imbalance::plus)
}

/// Forces and states of the contacts from number `first` on at a twist, R without the load and T.
/// Sums are made of halves, so that their rounding grows with the logarithm of their length, and
/// are the same for any number of threads.
fn answer<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    twist: &SVector<f64, D>,
    first: usize,
    states: &mut [PolygonState],
    forces: &mut [SVector<f64, C>],
) -> Imbalance<D> {
    if states.len() > SUMMED_IN_TURN {
        let (count, middle) = (states.len(), states.len() / 2);
        let (states, more_states) = states.split_at_mut(middle);
        let (forces, more_forces) = forces.split_at_mut(middle);
        let (a, b) = both(
            count,
            || answer(problem, twist, first, states, forces),
            || answer(problem, twist, first + middle, more_states, more_forces),
        );
        return a.plus(b);
    }
    let mut sum = Imbalance::<D>::zero();
    for (contact, (state, force)) in (first..).zip(states.iter_mut().zip(forces)) {
        let (site, local) = (&problem.sites[contact], problem.local(contact));
        if local.is_absent() {
            *state = Mode::Open;
            continue;
        }
        let tangent;
        (*state, *force, tangent) = local.answer_on_polygon(&problem.stretch(contact, twist));
        if state.is_open() {
            continue;
        }
        sum.lawful &= force[0] >= 0.0 || local.facets().is_empty();
        add_tangent(&mut sum.stiffness, site, &tangent);
        sum.left += site.map * *force;
        sum.size += force.norm();
    }
    sum
}

/// Adds `G_i C_i G_iᵀ` of one contact to T, dyad by dyad.
#[inline]
fn add_tangent<const D: usize, const C: usize>(
    t: &mut SMatrix<f64, D, D>,
    site: &Site<D, C>,
    tangent: &Tangent<C>,
) {
    match tangent {
        Tangent::Open => {}
        Tangent::Rolling(k) => {
            for (axis, k) in k.iter().enumerate() {
                let g = site.map.column(axis);
                t.ger(*k, &g, &g, 1.0);
            }
        }
        Tangent::Sliding { drag, across, stiffness } => {
            t.ger(1.0, &(site.map * drag), &site.map.column(0), 1.0);
            if *stiffness > 0.0 {
                let g = site.map * across;
                t.ger(*stiffness, &g, &g, 1.0);
            }
        }
    }
}

impl<const D: usize> Imbalance<D> {
    fn zero() -> Self {
        Self { left: SVector::zeros(), size: 0.0, stiffness: SMatrix::zeros(), lawful: true }
    }

    fn plus(self, other: Self) -> Self {
        Self {
            left: self.left + other.left,
            size: self.size + other.size,
            stiffness: self.stiffness + other.stiffness,
            lawful: self.lawful && other.lawful,
        }
    }
}

/// T dq = R with the units of the twist taken out; `None` if T is singular.
fn solve<const D: usize>(stiffness: &SMatrix<f64, D, D>, left: &SVector<f64, D>) -> Option<SVector<f64, D>> {
    let unit = SVector::<f64, D>::from_fn(|i, _| {
        let size = stiffness.row(i).amax();
        if size > 0.0 { 1.0 / size.sqrt() } else { 1.0 }
    });
    let scaled = SMatrix::<f64, D, D>::from_fn(|i, j| stiffness[(i, j)] * unit[i] * unit[j]);
    let zero = SVector::zeros();
    let factors = Bordered::new(&scaled, &zero, &zero, 1.0)?;
    Some(factors.solve(&left.component_mul(&unit), 0.0).0.component_mul(&unit))
}
