//! Relaxation of a stuck grasp: an artificial motion of the object towards a nearby equilibrium. It starts at the twist at which forces balance if
//! every contact sticks. Its only use is to select the twist from which Newton's method starts.
//!
//! With Coulomb friction a grasp may have several equilibria; in an extreme case the object lies next to the fingers. Newton's method from a distant
//! start jumps from one equilibrium to another. Let R(q) be the imbalance of contact forces and load at the twist q, G_i the grasp map and K_i the
//! stiffness of contact i. With the stiffness T of the grasp in which everything sticks, the steps of the relaxation are
//!
//! ```text
//! q <- q + T⁻¹R(q),   T = Σ G_i K_i G_iᵀ
//! ```
//!
//! At every twist the contact forces follow from the contact law, with slip where the spring force is beyond the friction cone. The object then moves
//! as if every contact had a dashpot with a damping constant in proportion to its stiffness. Steps in nearly the same direction are made longer. The
//! steps approach one equilibrium. This equilibrium is stable, and as long as it remains stable, it varies continuously with loads, commands and
//! friction.

use super::newton::{on_cones, respond};
use super::problem::Problem;
use super::tangent::TangentFactors;
use super::tolerances::{MOST_STEP_FACTOR, NEARLY_RELAXED, RELAXING_STEPS, STRAIGHT_ON};
use crate::contact::ContactResponse;
use crate::numerics::Vector;
use crate::prelude::*;

/// The twists of the relaxation `q <- q + T⁻¹R(q)`, from the twist at which forces balance if everything sticks.
///
/// The iterator returns twists at which the object has nearly relaxed. At the first of them, the estimated remaining displacement is at most a
/// hundredth of the displacement so far. This fraction is a hundred times smaller at each further twist. The last twist is that after
/// `RELAXING_STEPS` steps, or the one at which T⁻¹R is zero. Short steps indicate an equilibrium, or a twist near which a stable equilibrium has just
/// vanished. If Newton's method finds no equilibrium from a returned twist, the caller asks for the next one.
pub(crate) struct SpringDashpotRelaxation<'p, 'a> {
    problem: &'p Problem<'a>,
    factors: TangentFactors,
    contacts: Vec<ContactResponse>,
    stuck: Vector,
    twist: Vector,
    last: Option<Vector>,
    /// Length of the last step divided by the length of `T⁻¹R`, at least 1.
    step_factor: f64,
    steps: usize,
    /// The next twist is returned once the estimated remaining displacement is at most this fraction of the displacement from the start.
    nearly: f64,
}

impl<'p, 'a> SpringDashpotRelaxation<'p, 'a> {
    /// The relaxation from the twist `stuck`, at which forces balance if everything sticks. `None` if some motion of the stuck grasp meets no
    /// resistance from springs.
    pub(crate) fn from_stuck(problem: &'p Problem<'a>, stuck: &Vector) -> Option<Self> {
        let factors = problem.tangent_factors(&|i| problem.local(i).trial_state());
        let contacts = vec![ContactResponse::open(); problem.len()];
        let (stuck, twist) = (stuck.clone(), stuck.clone());
        let (last, step_factor, steps, nearly) = (None, 1.0, 0, NEARLY_RELAXED);
        let of = Self { problem, factors, contacts, stuck, twist, last, step_factor, steps, nearly };
        of.factors.is_regular().then_some(of)
    }

    /// The distance of `twist` from the present twist of the relaxation, divided by the distance that the object has moved since everything stuck.
    pub(crate) fn relative_distance_from(&self, twist: &Vector) -> f64 {
        (twist - &self.twist).norm() / (&self.twist - &self.stuck).norm()
    }
}

impl Iterator for SpringDashpotRelaxation<'_, '_> {
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
            // The last step, of length `step_factor * before`, reduced the norm of T⁻¹R from `before` to `size`. If the norm keeps falling at this
            // rate, it is zero after the displacement `whole * size`. A growing norm gives no estimate; it grows where the object moves away from an
            // unstable equilibrium.
            let (mut whole, mut next) = (f64::INFINITY, 1.0);
            if let Some(last) = &self.last {
                let before = last.norm();
                if size < before {
                    whole = self.step_factor * before / (before - size);
                }
                if step.dot(last) >= STRAIGHT_ON * size * before {
                    next = (2.0 * self.step_factor).min(MOST_STEP_FACTOR).min(whole);
                }
            }
            self.twist += &step * next;
            (self.last, self.step_factor) = (Some(step), next);
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
