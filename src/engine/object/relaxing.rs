//! Relaxation of a stuck grasp: contacts beyond their friction cones slip, and the object moves as it would with viscous contacts.
//!
//! With Coulomb friction a grasp may have several equilibria; in an extreme case the object lies next to the fingers. Steps of the twist q with the
//! stiffness T of the stuck grasp,
//!
//! ```text
//! q <- q + T⁻¹R(q),   T = Σ G_i K_i G_iᵀ
//! ```
//!
//! move the object as viscous contacts would. R is the imbalance of forces, G_i the grasp map and K_i the stiffness of contact i. In each step,
//! contacts with forces beyond their cones slip little by little. Steps in nearly the same direction are made longer. The steps approach one
//! equilibrium. It is stable, and as long as it remains stable, it varies continuously with loads, commands and friction. Newton's method from a
//! distant start jumps from one equilibrium to another.

use super::newton::{on_cones, respond};
use super::problem::Problem;
use super::tangent::TangentFactors;
use super::tolerances::{LONGEST_PACE, NEARLY_RELAXED, RELAXING_STEPS, STRAIGHT_ON};
use crate::contact::ContactResponse;
use crate::numerics::Vector;
use crate::prelude::*;

/// The sequence of twists along which the object relaxes, from the equilibrium in which everything sticks.
///
/// It iterates over twists at which the object has nearly relaxed. At the first, the estimated rest of the way is a hundredth of the way covered, at
/// the next a hundredth of that, and so on. The last twist comes after `RELAXING_STEPS` steps, or once the imbalance R of forces is zero. Short steps
/// indicate an equilibrium, or a twist near which a stable equilibrium has just vanished. If Newton's method finds no equilibrium from such a twist,
/// the caller asks for the next twist.
pub(crate) struct ViscousRelaxation<'p, 'a> {
    problem: &'p Problem<'a>,
    factors: TangentFactors,
    contacts: Vec<ContactResponse>,
    stuck: Vector,
    twist: Vector,
    last: Option<Vector>,
    /// Factor, at least 1, by which the last step was longer than `T⁻¹R`, the displacement that the imbalance R causes in the stuck grasp of
    /// stiffness T.
    pace: f64,
    steps: usize,
    /// The next twist is returned once the estimated rest of the way is at most this fraction of the distance from the twist at which everything
    /// sticks.
    nearly: f64,
}

impl<'p, 'a> ViscousRelaxation<'p, 'a> {
    /// The relaxation from the twist `stuck`, at which everything sticks and is in balance. `None` if no spring resists some motion of the stuck
    /// grasp.
    pub(crate) fn from_stuck(problem: &'p Problem<'a>, stuck: &Vector) -> Option<Self> {
        let factors = problem.tangent_factors(&|i| problem.local(i).trial_state());
        let contacts = vec![ContactResponse::open(); problem.len()];
        let (stuck, twist) = (stuck.clone(), stuck.clone());
        let (last, pace, steps, nearly) = (None, 1.0, 0, NEARLY_RELAXED);
        let of = Self { problem, factors, contacts, stuck, twist, last, pace, steps, nearly };
        of.factors.is_regular().then_some(of)
    }

    /// The distance of `twist` from the present twist of the relaxation, divided by the distance of the present twist from the twist at which
    /// everything sticks.
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
            // The estimated rest of the way is `whole` times this step, if steps keep shrinking by the same ratio. Steps that grow, as past an
            // unstable equilibrium, give no estimate.
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
