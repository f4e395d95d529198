//! A start for many contacts: Newton's method on polygons, with sums by halves on several threads.
//!
//! Its result is an equilibrium once forces balance, since every inequality of the law is part of the return map. It starts from the twist
//! with every contact sticking.

use core::ops::Range;

use nalgebra::SVector;

use super::solution::Solution;
use super::tolerances::BALANCED_SOLUTION;
use crate::contact::{Mode, PolygonState, State, Tangent};
use crate::grasp::Site;
use crate::numerics::{Factors, Size, Square, Vector, in_halves};
use crate::object::{self, Imbalance, Problem, StretchAnswers, TangentFactors, are_many};

/// Sums over some contacts: the imbalance R without the load, and the tangent stiffness T.
struct Sums {
    balance: Imbalance,
    stiffness: Square,
    /// Whether no contact that is kept closed pulls while it should carry friction.
    lawful: bool,
}

struct OnPolygons<'p, 'g> {
    problem: &'p Problem<'g>,
    states: &'p mut [PolygonState],
    forces: &'p mut [SVector<f64, 3>],
    /// The sums at the last twist.
    sums: Sums,
}

impl StretchAnswers for OnPolygons<'_, '_> {
    fn answer(&mut self, twist: &Vector) -> Imbalance {
        self.sums = answer(self.problem, twist, self.states, self.forces);
        let load = &self.problem.wrench;
        let Imbalance { left, size } = &self.sums.balance;
        Imbalance { left: left + load, size: size + load.norm() + f64::MIN_POSITIVE }
    }

    fn tangent(&mut self) -> Option<TangentFactors> {
        let state = |i: usize| self.states[i].into();
        let factors = self.sums.factors(self.problem, state)?;
        factors.is_regular().then_some(factors)
    }
}

/// Newton's method from the twist at which all contacts that stick would balance the load. Returns the number of steps,
/// or `None` if it does not converge. Rates on an edge are excluded.
pub(super) fn newton(problem: &Problem, found: &mut Solution) -> Option<usize> {
    if problem.locals().any(|local| local.is_on_an_edge()) {
        return None;
    }
    found.forces.clear();
    found.states.clear();
    found.forces.resize(problem.len(), SVector::zeros());
    found.states.resize(problem.len(), Mode::Sticking);
    let sums = stick(problem);
    let factors = sums.factors(problem, |i| problem.local(i).unjumped())?;
    // If a motion is free, the least one is wanted, which Newton's method does not find.
    let start = factors.is_regular().then(|| factors.solve(&(&sums.balance.left + &problem.wrench)))?;
    let mut answers = OnPolygons { problem, states: &mut found.states, forces: &mut found.forces, sums };
    let (twist, steps, here) = object::newton(&mut answers, start, BALANCED_SOLUTION)?;
    let lawful = answers.sums.lawful;
    found.twist = twist;
    found.residual = here.left.norm() / here.size;
    lawful.then_some(steps + 1)
}

/// R without the load and T, with every contact sticking and the object at rest.
fn stick(problem: &Problem) -> Sums {
    let part = |contacts: Range<usize>| {
        let mut sum = Sums::zero(problem.size());
        for contact in contacts {
            let (site, local) = (&problem.sites[contact], problem.local(contact));
            let state = local.unjumped();
            if !state.is_open() {
                sum.add_tangent(site, &local.tangent(&state));
                sum.balance.add(site, &local.springs.force(&problem.drives[contact]));
            }
        }
        sum
    };
    in_halves(0..problem.len(), &part, &Sums::plus)
}

/// Forces and states of the contacts at a twist, R without the load and T.
fn answer(
    problem: &Problem,
    twist: &Vector,
    states: &mut [PolygonState],
    forces: &mut [SVector<f64, 3>],
) -> Sums {
    let part = |(contacts, (states, forces)): (Range<usize>, (&mut [_], &mut [_]))| {
        let mut sum = Sums::zero(problem.size());
        for (contact, (state, force)) in contacts.zip(states.iter_mut().zip(forces)) {
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
            sum.add_tangent(site, &tangent);
            sum.balance.add(site, force);
        }
        sum
    };
    in_halves((0..states.len(), (states, forces)), &part, &Sums::plus)
}

/// Adds `G_i C_i G_iᵀ` of one contact to T, dyad by dyad.
#[inline]
fn add_tangent(t: &mut Square, site: &Site, tangent: &Tangent) {
    match tangent {
        Tangent::Open => {}
        Tangent::Sticking(k) => {
            for (axis, k) in k.iter().enumerate() {
                let g = site.map.column(axis);
                t.add_product(&g, &(&g * *k));
            }
        }
        Tangent::Sliding { drag, across, stiffness } => {
            t.add_product(&(&site.map * drag), &site.map.column(0));
            if *stiffness > 0.0 {
                let g = &site.map * across;
                t.add_product(&g, &(&g * *stiffness));
            }
        }
    }
}

impl Sums {
    fn zero(size: Size) -> Self {
        // For many coordinates T is kept in a band, see `factors`.
        let stiffness = Square::zeros(if are_many(size) { Size::of(0) } else { size });
        Self { balance: Imbalance::default(), stiffness, lawful: true }
    }

    fn add_tangent(&mut self, site: &Site, tangent: &Tangent) {
        if self.stiffness.size() == site.coordinates() {
            add_tangent(&mut self.stiffness, site, tangent);
        }
    }

    /// Factors of T in these states.
    fn factors(&self, problem: &Problem, state: impl Fn(usize) -> State) -> Option<TangentFactors> {
        if are_many(problem.size()) {
            return problem.tangent_in_a_band(&state);
        }
        Some(TangentFactors::Whole(Factors::new(&self.stiffness)))
    }

    fn plus(self, other: Self) -> Self {
        Self {
            balance: self.balance.plus(other.balance),
            stiffness: self.stiffness + &other.stiffness,
            lawful: self.lawful && other.lawful,
        }
    }
}
