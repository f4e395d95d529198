//! Derivatives of an equilibrium with respect to one parameter of the grasp or of the load, such as a coefficient of friction or a stiffness.

use nalgebra::SVector;

use crate::equilibrium::{Equilibrium, Parameter, StickingResponse};
use crate::grasp::{Engine, Motion, Twist};
use crate::object::ForcesAndTwist;
use crate::prelude::*;

/// Derivatives of twist, joints and contact forces of an equilibrium with respect to one parameter, as long as every contact keeps its state. Units
/// of the parameter: friction 1, stiffness N/m, command and position m, direction of a normal rad, load N or N m.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Derivative<const C: usize> {
    /// Derivative of the twist, m and rad per unit of the parameter; of least norm if nothing resists some motions.
    pub twist: Twist<C>,
    /// Derivatives of the displacements of the joints of a hand, finger by finger, rad or m per unit of the parameter; empty without a hand.
    pub joints: Vec<f64>,
    /// Derivatives of the contact forces in the contact frames, N per unit of the parameter, in the order of the grasp's contacts.
    pub forces: Vec<SVector<f64, C>>,
}

impl Engine {
    pub(crate) fn sensitivity(&self, equilibrium: &Equilibrium<3>, by: Parameter) -> Option<Derivative<3>> {
        let (local, problem) = (&equilibrium.local, self.problem_of(equilibrium)?);
        let state = ForcesAndTwist { forces: equilibrium.site_forces(), twist: local.twist.to() };
        let response = StickingResponse::of(self, problem, &local.states);
        let ForcesAndTwist { twist, mut forces } = response.derivative(&state, by)?;
        forces.truncate(self.len());
        let Motion { object: twist, joints, .. } = self.motion_outside(&twist);
        Some(Derivative { twist, joints, forces })
    }
}
