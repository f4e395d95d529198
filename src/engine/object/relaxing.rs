//! Relaxation: the object moves as slowly as viscous contacts would let it, until forces balance.
//!
//! With Coulomb friction a grasp may rest in several ways, down to the object beside the fingers. Steps with the stiffness of the stuck grasp,
//!
//! ```text
//! q <- q + T⁻¹R(q),   T = Σ G_i K_i G_iᵀ
//! ```
//!
//! go as viscous contacts would: what is beyond a cone slips little by little.

use super::newton::{on_cones, respond};
use super::problem::Problem;
use super::tolerances::{LONGEST_PACE, NEARLY_RELAXED, RELAXING_STEPS, STRAIGHT_ON};
use crate::contact::ContactResponse;
use crate::numerics::Vector;

/// Steps of a relaxation, which are made longer where they go straight on.
#[derive(Debug)]
pub(crate) struct RelaxingSteps {
    last: Option<Vector>,
    pace: f64,
}

impl RelaxingSteps {
    pub(crate) fn new() -> Self {
        Self { last: None, pace: 1.0 }
    }

    /// The step in place of `step`, and the number of steps like it after which the object rests, from the factor by which steps shrink. Past an
    /// equilibrium that is not stable steps are short, but grow, and the number is infinite.
    pub(crate) fn lengthened(&mut self, step: Vector) -> (Vector, f64) {
        let size = step.norm();
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
        let longer = &step * next;
        (self.last, self.pace) = (Some(step), next);
        (longer, whole)
    }
}

/// The twist to which the object relaxes from where everything sticks, nearly.
///
/// The steps end at one equilibrium, which is stable, and which varies with loads, commands and friction without a jump for as long as it is. Newton's
/// method from afar jumps from one equilibrium to another. `None` where a motion of the stuck grasp is free.
pub(crate) fn relaxed_on_cones(problem: &Problem, stuck: &Vector) -> Option<Vector> {
    let factors = problem.tangent_factors(&|i| problem.local(i).unjumped());
    if !factors.is_regular() {
        return None;
    }
    let mut contacts = vec![ContactResponse::open(); problem.len()];
    let (mut twist, mut steps) = (stuck.clone(), RelaxingSteps::new());
    for _ in 0..RELAXING_STEPS {
        let here = respond(problem, (&twist, 0.0), &mut contacts, &on_cones(problem));
        let step = factors.solve(&here.left);
        let size = step.norm();
        let (step, whole) = steps.lengthened(step);
        twist += step;
        if size == 0.0 || size * whole <= NEARLY_RELAXED * (&twist - stuck).norm() {
            break;
        }
    }
    Some(twist)
}
