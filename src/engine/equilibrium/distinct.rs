//! Contact states that working precision distinguishes from their neighbours.
//!
//! Neighbouring contact states are open and touching, sticking and sliding, or sliding in two directions. They meet where a gap, a force, a slip or
//! the friction margin `μ F_n - |F_t|` vanishes. Next to such a point the last digits of the numbers given for grasp and load determine the contact
//! state.

use super::answer::Equilibrium;
use crate::contact::{Mode, State};
use crate::grasp::Engine;
use crate::numerics::IntoList;
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::object::largest_force;
use crate::prelude::*;

impl Engine {
    /// For each contact, but not for joints and tendons: true if working precision distinguishes its state from neighbouring contact states. `None`
    /// if the equilibrium lacks the solution that the engine stores with it, for example because it was read from a file.
    pub(crate) fn distinct(&self, equilibrium: &Equilibrium<3>) -> Option<Vec<bool>> {
        let problem = self.problem_of(equilibrium)?;
        let [force_error, displacement_error] =
            self.accuracy(equilibrium).map_or([0.0; 2], |accuracy| [accuracy.force, accuracy.displacement]);
        let twist = &equilibrium.local.twist.to();
        let forces = equilibrium.site_forces();
        let sizes = forces.iter().map(nalgebra::Matrix::norm);
        let largest = largest_force(self.sites(), &problem.offsets, twist, problem.wrench.norm(), sizes);
        // A gap, force, slip or margin below ten times its estimated error may be zero in exact arithmetic. `part` gives this limit as a fraction of
        // `size`: the largest force, or an upper bound of the terms of the contact's displacement.
        let part = |error: f64, size: f64| if size > 0.0 { 10.0 * error / size } else { 0.0 };
        let distinct = |(i, state): (usize, &State)| {
            let at = problem.at(i, &forces[i], twist, largest);
            let of_forces = part(force_error, largest);
            let of_displacements = part(displacement_error, at.span);
            // The numbers given for grasp and load are rounded. For the exact numbers, a gap, force, slip or margin below the fraction
            // `SOLVED_ROUNDING` of its terms may be zero. Normals, arms and their products have errors of a few 1e-16, which even well-posed grasps
            // magnify a hundredfold.
            let least = SOLVED_ROUNDING.max(match state {
                Mode::Open => of_displacements,
                Mode::Sticking => of_forces,
                _ => of_forces.max(of_displacements),
            });
            let mut distinct = true;
            problem
                .local(i)
                .for_each_condition(state, &at, &mut |value, size| distinct &= value > least * size);
            distinct
        };
        Some(equilibrium.local.states.iter().enumerate().take(self.len()).map(distinct).list())
    }
}
