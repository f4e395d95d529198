//! Forces and motions that turn with the load while states last: the first exit is a root of a trigonometric polynomial.

use super::first_exits::FirstExits;
use crate::contact::{Exit, State, TurningExit, Wave};
use crate::numerics::{Harmonic, Vector};
use crate::object::{PieceState, Problem};
use crate::prelude::*;

/// The turn of all quantities from a place on, while contacts keep their states.
#[derive(Debug)]
pub(super) struct TurningState {
    /// Force and stretch of every contact.
    pub(super) waves: Vec<[Wave; 2]>,
    pub(super) twist: Harmonic<Vector>,
    pub(super) load: Harmonic<Vector>,
    /// Angle for one unit of the factor, rad.
    pub(super) angle: f64,
}

impl TurningState {
    /// Forces after a step of the factor, and the change of the twist.
    pub(super) fn after(&self, step: f64) -> PieceState {
        let angle = self.angle * step;
        let forces = self.waves.iter().map(|[force, _]| force.of.at(angle)).collect();
        PieceState { forces, twist: self.twist.at(angle) - self.twist.at(0.0) }
    }

    /// The first exits of contacts in these states, within a step of the factor.
    pub(super) fn first_exits(&self, problem: &Problem<'_>, states: &[State], rest: f64) -> FirstExits {
        let contacts = problem.locals().zip(states).zip(&self.waves).enumerate();
        let ways = contacts.map(|(i, ((local, state), [force, stretch]))| {
            (i, local.turning_exits(state, [force, stretch], rest * self.angle))
        });
        first_of(ways.collect(), self.angle)
    }
}

/// The first of all exits; converts steps from angles to parts of `angle`.
fn first_of(ways: Vec<(usize, Vec<TurningExit>)>, angle: f64) -> FirstExits {
    let leaving = |exit: &TurningExit| match exit {
        TurningExit::Leaves(exit) => {
            Some(Exit { step: exit.step / angle, uncertainty: exit.uncertainty / angle, ..*exit })
        }
        TurningExit::Touches(_) => None,
    };
    let all = ways.iter().flat_map(|(_, exits)| exits.iter().filter_map(leaving));
    let first = all.min_by(|a, b| a.step.total_cmp(&b.step));
    let end = first.map_or(f64::INFINITY, |first| first.step * angle);
    let mut touches = Vec::new();
    let mut standing = Vec::new();
    for (contact, exits) in ways {
        touches.extend(exits.iter().filter_map(|exit| match exit {
            TurningExit::Touches(angle) if *angle < end => Some((contact, *angle)),
            _ => None,
        }));
        // Symmetric grasps reach several edges at once: steps equal up to the rounding of both count as tied.
        let tied = |exit: &Exit| {
            first.is_some_and(|first| exit.step - first.step <= exit.uncertainty + first.uncertainty)
        };
        let together: Vec<_> = exits.iter().filter_map(leaving).filter(tied).collect();
        if !together.is_empty() {
            standing.push((contact, together));
        }
    }
    FirstExits { standing: first.map(|first| (first.step, standing)), touches }
}
