//! Relaxation of a stuck grasp: the object moves as slowly as viscous contacts would let it.
//!
//! With Coulomb friction a grasp may rest in several ways, down to the object beside the fingers. Steps with the stiffness of the stuck grasp,
//!
//! ```text
//! q <- q + T⁻¹R(q),   T = Σ G_i K_i G_iᵀ
//! ```
//!
//! go as viscous contacts would: what is beyond a cone slips little by little. Where they go straight on they are made longer. They end at one
//! equilibrium, which is stable, and which varies with loads, commands and friction without a jump for as long as it is. Newton's method from afar
//! jumps from one equilibrium to another.

use super::newton::{on_cones, respond};
use super::problem::Problem;
use super::tangent::TangentFactors;
use super::tolerances::{LONGEST_PACE, NEARLY_RELAXED, RELAXING_STEPS, STRAIGHT_ON};
use crate::contact::ContactResponse;
use crate::numerics::Vector;
use crate::prelude::*;

/// The way on which the object relaxes from where everything sticks.
///
/// The items are twists at which the object has nearly relaxed, each a hundred times as nearly as the last. Steps that become short show an
/// equilibrium, or a place where a stable one has just vanished: if Newton's method finds none there, the object relaxes further.
pub(crate) struct ViscousRelaxation<'p, 'a> {
    problem: &'p Problem<'a>,
    factors: TangentFactors,
    contacts: Vec<ContactResponse>,
    stuck: Vector,
    twist: Vector,
    last: Option<Vector>,
    /// Factor by which the next step is made longer.
    pace: f64,
    steps: usize,
    /// The part of the way gone that may be left at the next item.
    nearly: f64,
}

impl<'p, 'a> ViscousRelaxation<'p, 'a> {
    /// The way from the twist of the stuck grasp; `None` where a motion of the stuck grasp is free.
    pub(crate) fn from_stuck(problem: &'p Problem<'a>, stuck: &Vector) -> Option<Self> {
        let factors = problem.tangent_factors(&|i| problem.local(i).unjumped());
        let contacts = vec![ContactResponse::open(); problem.len()];
        let (stuck, twist) = (stuck.clone(), stuck.clone());
        let (last, pace, steps, nearly) = (None, 1.0, 0, NEARLY_RELAXED);
        let of = Self { problem, factors, contacts, stuck, twist, last, pace, steps, nearly };
        of.factors.is_regular().then_some(of)
    }

    /// The distance of a twist from the present one, as a part of the way gone.
    pub(crate) fn part_of_the_way(&self, twist: &Vector) -> f64 {
        (twist - &self.twist).norm() / (&self.twist - &self.stuck).norm()
    }
}

impl Iterator for ViscousRelaxation<'_, '_> {
    type Item = Vector;

    fn next(&mut self) -> Option<Vector> {
        if self.steps >= RELAXING_STEPS {
            return None;
        }
        while self.steps < RELAXING_STEPS {
            let response =
                respond(self.problem, (&self.twist, 0.0), &mut self.contacts, &on_cones(self.problem));
            let step = self.factors.solve(&response.left);
            let size = step.norm();
            // `whole` is the number of steps like this one in the whole way to rest, if steps keep shrinking by the same ratio. Past an unstable
            // equilibrium steps are short, but grow.
            let (mut whole, mut next) = (f64::INFINITY, 1.0);
            if let Some(last) = &self.last {
                let before = last.norm();
                if size < before {
                    whole = self.pace * before / (before - size);
                }
                if step.dot(last) >= STRAIGHT_ON * size * before {
                    next = (2.0 * self.pace).min(LONGEST_PACE).min(whole);
                }
            }
            self.twist += &step * next;
            (self.last, self.pace) = (Some(step), next);
            self.steps += 1;
            if size == 0.0 {
                self.steps = RELAXING_STEPS;
            }
            if size * whole <= self.nearly * (&self.twist - &self.stuck).norm() {
                self.nearly *= NEARLY_RELAXED;
                break;
            }
        }
        Some(self.twist.clone())
    }
}
