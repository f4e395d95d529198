//! Forces, stretches and twist under a load that turns while contacts keep their states (open, sticking or sliding): harmonic functions of the load's
//! angle. The first exit, where the present state of a contact ends, is a root of a trigonometric polynomial. The load factor is here the angle by
//! which the load has turned, divided by a given angle. A drive is the spring of a joint or tendon of a hand, with its force limit.

use super::first_exits::{FirstExits, first_reached};
use crate::contact::{Exit, State, TurningExit, Wave};
use crate::numerics::{Harmonic, Vector, mapped};
use crate::object::{ForcesAndTwist, Problem};
use crate::prelude::*;

/// Forces, stretches and twist as harmonic functions of the angle by which the load has turned from a point of the path on. Contacts keep their
/// states.
#[derive(Debug)]
pub(super) struct TurningState {
    /// For every contact and drive `[force, stretch]` as harmonic functions of the angle: its force, N, and the stretch of its springs, m.
    pub(super) waves: Vec<[Wave; 2]>,
    pub(super) twist: Harmonic<Vector>,
    pub(super) load: Harmonic<Vector>,
    /// Angle, rad, by which the load turns in one unit of the load factor.
    pub(super) angle: f64,
}

impl TurningState {
    /// The contact forces after the change `step` of the load factor, and in the field `twist` the change of the twist in this step.
    pub(super) fn after(&self, step: f64) -> ForcesAndTwist {
        let angle = self.angle * step;
        let forces = mapped(&self.waves, &|[force, _]| force.of.at(angle));
        ForcesAndTwist { forces, twist: self.twist.at(angle) - self.twist.at(0.0) }
    }

    /// The first point, within the change `rest` of the load factor, at which one of the contact states `states` ends. The result also lists the
    /// contacts whose forces touch the boundary of their cones, without crossing it, before this point.
    pub(super) fn first_exits(&self, problem: &Problem<'_>, states: &[State], rest: f64) -> FirstExits {
        let (mut ways, mut touches) = (Vec::new(), Vec::new());
        for (i, ((local, state), [force, stretch])) in
            problem.locals().zip(states).zip(&self.waves).enumerate()
        {
            let mut exits = Vec::new();
            for exit in local.turning_exits(state, [force, stretch], rest * self.angle) {
                match exit {
                    // Converts the angle up to the exit to a change of the load factor.
                    TurningExit::Leaves(exit) => exits.push(Exit {
                        step: exit.step / self.angle,
                        uncertainty: exit.uncertainty / self.angle,
                        ..exit
                    }),
                    TurningExit::Touches(angle) => touches.push((i, angle)),
                }
            }
            ways.push((i, exits));
        }
        let reached = first_reached(ways);
        let end = reached.as_ref().map_or(f64::INFINITY, |(step, _)| step * self.angle);
        touches.retain(|(_, angle)| *angle < end);
        FirstExits { reached, touches }
    }
}
