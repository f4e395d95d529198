//! Exact derivatives of the onset of sliding by the positions and normals of contacts.

use nalgebra::SVector;

use super::onset::OnsetEvent;
use super::onset_margins::{Leaver, OnsetMargins};
use crate::equilibrium::Parameter;
use crate::error::Error;
use crate::grasp::{Engine, Space};
use crate::numerics::moved;
use crate::prelude::*;

/// Derivatives of the load factor (without unit) at which one contact stops sticking, with respect to the geometry of every contact. Commands,
/// clearances and stiffnesses keep their components along the axes of the contact frames, and so do changes of commands along a ramp.
///
/// A command a that stays along the **coordinate** axes changes in a frame that tilts by φ towards the tangent t: by φ `a·t` along the
/// normal, by -φ `a·n` along t. Multiplied by [`OnsetGradient::command`](super::OnsetGradient::command), that is the term to add to `normal`.
///
/// Not a number if a changed geometry leaves the load unbalanced, or resists a motion that is free in this one. An example is two point fingers in
/// space that no longer meet the line of the load.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct GeometryGradient<const C: usize> {
    /// The contact or drive that stops sticking. If several do so together, the onset is the least of their load factors.
    pub leaving: Leaver,
    /// Derivatives with respect to the position of every contact along the coordinate axes, 1/m, at a fixed frame.
    pub point: Vec<SVector<f64, C>>,
    /// Derivatives with respect to the direction of every normal, 1/rad, in the contact frame. Along a tangent t: the angle by which the normal tilts
    /// towards it, `dn = φ t`, and the frame with it. Along the normal: a turn of the tangents about it, from t₁ to t₂; zero in the plane.
    ///
    /// A rotation vector θ along the coordinate axes tilts by `φ_a = (θ × n)·t_a`; in the plane `t = (n_y, -n_x)`, and φ is an
    /// angle from y to x.
    pub normal: Vec<SVector<f64, C>>,
}

impl Engine {
    /// [`Sensitivity::onset_gradients_by_geometry`](crate::ask::Sensitivity::onset_gradients_by_geometry).
    pub(crate) fn onset_gradients_by_geometry(
        &self,
        event: &OnsetEvent<3>,
    ) -> Result<Vec<GeometryGradient<3>>, Error> {
        self.refuse_hands("onset_gradients_by_geometry")?;
        let Some(margins) = OnsetMargins::new(self, event) else { return Ok(Vec::new()) };
        let none = vec![SVector::repeat(f64::NAN); self.len()];
        let empty = |leaving| GeometryGradient { leaving, point: none.clone(), normal: none.clone() };
        let mut gradients = moved(margins.leavers(), &empty);
        for contact in 0..self.len() {
            for axis in 0..self.space().axes() {
                let by = margins.by(Parameter::Point { contact, axis });
                for (gradient, value) in gradients.iter_mut().zip(by.into_iter().flatten()) {
                    gradient.point[contact][axis] = value;
                }
                if self.space() == Space::Planar && axis == 0 {
                    // In the plane no tangents can turn about a normal.
                    for gradient in &mut gradients {
                        gradient.normal[contact][axis] = 0.0;
                    }
                    continue;
                }
                let by = margins.by(Parameter::Normal { contact, axis });
                for (gradient, value) in gradients.iter_mut().zip(by.into_iter().flatten()) {
                    gradient.normal[contact][axis] = value;
                }
            }
        }
        Ok(gradients)
    }
}
