//! Newton's method on cones, in the memory of a workspace.
//!
//! Newton's method on the contacts' responses to a motion of the object starts from the elastic trial state, or on the round cone from an
//! equilibrium on polygons. Once forces balance, the result is an equilibrium: the friction law holds in every response.

use nalgebra::SVector;

use super::solution::Solution;
use super::tolerances::{ACCURATE_SOLUTION, BALANCED_SOLUTION};
use crate::contact::{ContactResponse, ZERO_SLACK};
use crate::numerics::Vector;
use crate::object::{Problem, newton_on_cones};
use crate::prelude::*;

/// Newton's method from a twist. Returns the number of steps if it converges; the responses of the contacts are then in `answers`.
pub(super) fn newton(
    problem: &Problem,
    from: Vector,
    answers: &mut Vec<ContactResponse>,
    found: &mut Solution,
) -> Option<usize> {
    let (twist, steps, here) = newton_on_cones(problem, (from, BALANCED_SOLUTION), answers)?;
    // A contact that is kept closed may pull, but then it has no friction to slide with.
    let lawful = problem
        .locals()
        .zip(answers.iter())
        .all(|(local, answer)| answer.force[0] >= 0.0 || !local.may_slide());
    if !lawful {
        return None;
    }
    found.twist = twist;
    found.forces.clear();
    found.forces.extend(answers.iter().map(|answer| answer.force));
    found.residual = here.left.norm() / here.size;
    Some(steps)
}

/// Whether the elastic trial at a twist is an equilibrium; x are the stretches of the contacts' springs there.
pub(super) fn trial_holds(
    problem: &Problem,
    (x, twist): (&[f64], &Vector),
    answers: &mut Vec<ContactResponse>,
    found: &mut Solution,
) -> bool {
    answers.clear();
    found.forces.clear();
    let mut rest = x;
    for (local, site) in problem.locals().zip(problem.sites) {
        let (own, others) = rest.split_at(site.springs.axes());
        rest = others;
        let mut force = SVector::zeros();
        for (axis, x) in own.iter().enumerate() {
            force[axis] = x * site.springs.root_along(axis);
        }
        answers.push(ContactResponse { state: local.unjumped(), force });
        found.forces.push(force);
    }
    let largest = problem.largest_force(&found.forces, twist);
    let mut worst = 0.0_f64;
    for (i, answer) in answers.iter().enumerate() {
        let at = problem.at(i, &answer.force, twist, largest);
        problem
            .local(i)
            .for_each_condition(&answer.state, &at, |value, size| worst = worst.max(-value / size));
    }
    found.twist.clone_from(twist);
    let (left, carried) = problem.imbalance(&found.forces);
    found.residual = worst.max(left / (carried + problem.wrench.norm() + f64::MIN_POSITIVE));
    worst <= ZERO_SLACK && found.residual <= ACCURATE_SOLUTION
}
