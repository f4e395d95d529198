//! Forces and motions under a load that turns while contacts keep their states: harmonics of its angle. The first exit, where the present state of a
//! contact stops being valid, is a root of a trigonometric polynomial.

use super::first_exits::{FirstExits, first_reached};
use crate::contact::{Exit, State, TurningExit, Wave};
use crate::numerics::{Harmonic, Vector, mapped};
use crate::object::{PieceState, Problem};
use crate::prelude::*;

/// Forces, stretches and twist as harmonic functions of the load's angle, counted from a place on the path, while contacts keep their states.
#[derive(Debug)]
pub(super) struct TurningState {
    /// Force and stretch of every contact as harmonic functions of the angle.
    pub(super) waves: Vec<[Wave; 2]>,
    pub(super) twist: Harmonic<Vector>,
    pub(super) load: Harmonic<Vector>,
    /// Angle for one unit of the load factor, rad.
    pub(super) angle: f64,
}

impl TurningState {
    /// Forces after a step of the load factor, and the change of the twist.
    pub(super) fn after(&self, step: f64) -> PieceState {
        let angle = self.angle * step;
        let forces = mapped(&self.waves, &|[force, _]| force.of.at(angle));
        PieceState { forces, twist: self.twist.at(angle) - self.twist.at(0.0) }
    }

    /// The first places at which the contact states `states` stop being valid, within a step `rest` of the load factor.
    pub(super) fn first_exits(&self, problem: &Problem<'_>, states: &[State], rest: f64) -> FirstExits {
        let (mut ways, mut touches) = (Vec::new(), Vec::new());
        for (i, ((local, state), [force, stretch])) in
            problem.locals().zip(states).zip(&self.waves).enumerate()
        {
            let mut exits = Vec::new();
            for exit in local.turning_exits(state, [force, stretch], rest * self.angle) {
                match exit {
                    // Converts an angle to the load factor of the leg, which is 1 at its end.
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
