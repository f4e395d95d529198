//! Joints and tendons of a hand in pictures. Joints and tendons whose torque or tension is at its limit are marked.

use nalgebra::SVector;

use crate::ask::Grasp;
use crate::equilibrium::{DriveState, Equilibrium};
use crate::grasp::HandPart;
use crate::numerics::{indexed, numbered};

/// Names of the joints and tendons of a hand, and the centres of the joints, m, where these are known.
#[derive(Debug, Clone)]
pub(super) struct Actuators {
    pub(super) joints: Vec<(String, Option<SVector<f64, 3>>)>,
    tendons: Vec<String>,
}

impl Actuators {
    pub(super) fn of(grasp: &Grasp<3>) -> Self {
        let joint = |(j, at): (usize, &Option<SVector<f64, 3>>)| (grasp.label_of(HandPart::Joint(j)), *at);
        let joints: Vec<_> = indexed(grasp.joint_centres(), &joint);
        let tendons = grasp.joint_commands().len() - joints.len();
        Self { joints, tendons: numbered(tendons, &|t| grasp.label_of(HandPart::Tendon(t))) }
    }

    /// Names of the joints and tendons whose torque or tension is at its limit in the equilibrium `state`. Each joint comes with its centre, m, if
    /// the centre is known; tendons come with `None`.
    pub(super) fn that_yield(&self, state: &Equilibrium<3>) -> Vec<(&str, Option<SVector<f64, 3>>)> {
        let mut yielding = Vec::new();
        for ((name, at), answer) in self.joints.iter().zip(&state.joints) {
            if answer.state == DriveState::Yields {
                yielding.push((name.as_str(), *at));
            }
        }
        for (name, answer) in self.tendons.iter().zip(&state.tendons) {
            if answer.state == DriveState::Yields {
                yielding.push((name.as_str(), None));
            }
        }
        yielding
    }
}
