//! Exact derivatives of the onset of sliding by friction, springs, commands and load.

use nalgebra::SVector;

use super::onset::OnsetEvent;
use super::onset_margins::{Leaver, OnsetMargins};
use crate::equilibrium::Parameter;
use crate::grasp::Engine;
use crate::numerics::moved;
use crate::prelude::*;

/// Derivatives of the load factor (without unit) at which one contact stops sticking. Derivatives with respect to positions and normals are a
/// separate question, [`Sensitivity::onset_gradients_by_geometry`](crate::ask::Sensitivity::onset_gradients_by_geometry).
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct OnsetGradient<const C: usize> {
    /// The contact or drive that stops sticking. If several do so together, the onset is the least of their load factors. Its one-sided derivative
    /// along a change of the data is then the least of their derivatives.
    pub leaving: Leaver,
    /// Derivatives with respect to every contact's coefficient of friction.
    pub friction: Vec<f64>,
    /// Derivatives with respect to every contact's series stiffness, axis by axis, m/N.
    pub stiffness: Vec<SVector<f64, C>>,
    /// Derivatives with respect to every contact's command in its contact frame, axis by axis, 1/m.
    pub command: Vec<SVector<f64, C>>,
    /// Derivatives with respect to the commands of the joints of a hand, then of its tendons, 1/rad or 1/m.
    pub joint_command: Vec<f64>,
    /// Derivatives with respect to the stiffnesses of the own springs of joints, then of tendons, rad/(N m) or m/N.
    pub joint_stiffness: Vec<f64>,
    /// Derivatives with respect to the limits of joints, then of tendons, 1/(N m) or 1/N.
    pub joint_limit: Vec<f64>,
    /// Derivatives with respect to the components of the base load, or of the constant part of a load that turns, 1/N and 1/(N m). Times the load
    /// factor, they are derivatives by the load direction; times cos θ and sin θ, those by the parts that turn. Not a number if a component works on
    /// a motion that nothing resists: under such a load there is no equilibrium.
    pub base_load: Vec<f64>,
    /// Derivative with respect to a factor on the whole load (base and direction, or all parts of a load that turns), at the value 1 of this factor.
    /// Without a base load, and with constant commands, it is minus the load factor of the onset.
    pub load_scale: f64,
}

impl Engine {
    /// [`Sensitivity::onset_gradients`](crate::ask::Sensitivity::onset_gradients).
    pub(crate) fn onset_gradients(&self, event: &OnsetEvent<3>) -> Vec<OnsetGradient<3>> {
        let Some(margins) = OnsetMargins::new(self, event) else { return Vec::new() };
        self.gradients_of(&margins, event).unwrap_or_default()
    }

    fn gradients_of(&self, margins: &OnsetMargins, event: &OnsetEvent<3>) -> Option<Vec<OnsetGradient<3>>> {
        let (n, actuators) = (self.len(), self.joint_commands().len());
        let empty = |leaving| OnsetGradient {
            leaving,
            friction: Vec::with_capacity(n),
            stiffness: vec![SVector::zeros(); n],
            command: vec![SVector::zeros(); n],
            joint_command: Vec::with_capacity(actuators),
            joint_stiffness: Vec::with_capacity(actuators),
            joint_limit: Vec::with_capacity(actuators),
            base_load: vec![f64::NAN; self.space().of_the_object()],
            load_scale: f64::NAN,
        };
        let mut gradients = moved(margins.leavers(), &empty);
        let mut put = |by: Option<Vec<f64>>, place: &dyn Fn(&mut OnsetGradient<3>, f64)| {
            by.map(|by| gradients.iter_mut().zip(by).for_each(|(gradient, value)| place(gradient, value)))
        };
        for i in 0..n {
            put(margins.by(Parameter::Friction { contact: i }), &|g, value| g.friction.push(value))?;
            for axis in 0..self.space().axes() {
                let (stiffness, command) =
                    (Parameter::Stiffness { contact: i, axis }, Parameter::Command { contact: i, axis });
                put(margins.by(stiffness), &|g, value| g.stiffness[i][axis] = value)?;
                put(margins.by(command), &|g, value| g.command[i][axis] = value)?;
            }
        }
        for joint in 0..actuators {
            put(margins.by(Parameter::JointCommand { joint }), &|g, value| g.joint_command.push(value))?;
            put(margins.by(Parameter::JointStiffness { joint }), &|g, value| g.joint_stiffness.push(value))?;
            put(margins.by(Parameter::JointLimit { joint }), &|g, value| g.joint_limit.push(value))?;
        }
        for component in 0..self.space().of_the_object() {
            // A load along a free motion cannot be carried at all, so that its derivative stays not a number.
            put(margins.by(Parameter::Load { component }), &|g, value| g.base_load[component] = value);
        }
        put(margins.by_load(&event.load), &|g, value| g.load_scale = value);
        Some(gradients)
    }
}
