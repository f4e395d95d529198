//! Response of an equilibrium to commands of fingers or joints: the matrices of position control.

use nalgebra::{DMatrix, DVector, DVectorView};

use crate::equilibrium::{Equilibrium, Parameter};
use crate::grasp::{Engine, Twist};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{IntoList, Size, Vector};
use crate::object::{PieceState, least_combination};
use crate::prelude::*;

/// Derivatives of twist and contact forces of an equilibrium by the commands, as long as every contact keeps its state: the matrices of position
/// control. Columns are the commands, contact by contact, axis by axis (m): with c axes, column `c i + a` is axis a of contact i. Columns of a
/// [response to joint commands](crate::ask::Sensitivity::joint_response) are joints, then tendons (rad, m).
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Response {
    /// Derivative of the twist by the commands: one row for each component of the twist about the origin, translation first (m/m), then rotation
    /// (rad/m).
    pub twist: DMatrix<f64>,
    /// Derivative of the contact forces by the commands, N/m; N/rad or N/m for joint commands. Rows are forces in the contact frames, contact by
    /// contact, axis by axis.
    pub forces: DMatrix<f64>,
}

impl Engine {
    /// Implements [`Sensitivity::response`](crate::ask::Sensitivity::response).
    pub(crate) fn response(&self, equilibrium: &Equilibrium<3>) -> Option<Response> {
        let axes = self.space().axes();
        let commands =
            (0..self.len() * axes).map(|k| Parameter::Command { contact: k / axes, axis: k % axes });
        self.response_to(equilibrium, commands)
    }

    /// Implements [`Sensitivity::joint_response`](crate::ask::Sensitivity::joint_response).
    pub(crate) fn joint_response(&self, equilibrium: &Equilibrium<3>) -> Option<Response> {
        let commands = (0..self.joint_commands().len()).map(|joint| Parameter::JointCommand { joint });
        self.response_to(equilibrium, commands)
    }

    fn response_to(
        &self,
        equilibrium: &Equilibrium<3>,
        parameters: impl ExactSizeIterator<Item = Parameter>,
    ) -> Option<Response> {
        let (local, state) = self.response_of(equilibrium)?;
        let (object, axes, columns) = (self.space().of_the_object(), self.space().axes(), parameters.len());
        let mut response = Response {
            twist: DMatrix::zeros(object, columns),
            forces: DMatrix::zeros(self.len() * axes, columns),
        };
        for (column, parameter) in parameters.enumerate() {
            let PieceState { twist, forces } = local.derivative(&state, parameter)?;
            let twist = self.outside_coordinates(&twist);
            for k in 0..object {
                response.twist[(k, column)] = twist[k];
            }
            for (i, force) in forces.iter().take(self.len()).enumerate() {
                for a in 0..axes {
                    response.forces[(i * axes + a, column)] = force[a];
                }
            }
        }
        Some(response)
    }
}

impl Response {
    /// The smallest commands that move the object by a twist about the origin, to be added to the present commands: `da = (dq/da)⁺ dq`, m. They are a
    /// least squares solution over all contacts and axes, in the order of the columns. `None` if the fingers cannot produce the twist while contacts
    /// keep their states, or if `wanted` has another number of components.
    #[must_use]
    pub fn smallest_command<const C: usize>(&self, wanted: &Twist<C>) -> Option<DVector<f64>> {
        let wanted = wanted.components();
        if self.twist.nrows() != wanted.len() {
            return None;
        }
        let command = DVector::from_vec(self.least_combination(Size::of(wanted.len()), wanted));
        let wanted = DVectorView::from_slice(wanted, wanted.len());
        let missed = (&self.twist * &command - wanted).norm();
        // The fingers can produce a twist if the best commands miss it by at most this fraction of its size.
        (missed <= NEGLIGIBLE * wanted.norm()).then_some(command)
    }

    fn least_combination(&self, size: Size, wanted: &[f64]) -> Vec<f64> {
        let columns = self.twist.column_iter().map(|column| Vector::from_fn(size, |k| column[k]));
        least_combination(size, &columns.list(), &Vector::from_fn(size, |k| wanted[k]))
    }
}
