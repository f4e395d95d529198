//! Exact derivatives of the onset of sliding by where contacts are and where their normals point.

use nalgebra::SVector;

use super::onset::OnsetEvent;
use super::onset_margins::{Leaver, OnsetMargins};
use super::sensitivity::Parameter;
use crate::error::Error;
use crate::grasp::Grasp;

/// Derivatives of the load factor (without unit) at which one contact leaves rolling, by the geometry of every contact. Commands,
/// clearances and stiffnesses stay along the axes of the contact frames, changes of commands along a ramp too.
///
/// A command a that stays along the **coordinate** axes changes in a frame that tilts by φ towards the tangent t: by φ `a·t` along the
/// normal, by -φ `a·n` along t. With [`OnsetGradient::command`](super::OnsetGradient::command) that adds its part to `normal`.
///
/// Not a number where another geometry leaves the load unbalanced, or holds a motion that is free in this one. Such are two point
/// fingers in space that do not meet the line of the load any more.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct GeometryGradient<const C: usize> {
    /// What leaves. Where several leave together the onset is the least of their factors.
    pub leaving: Leaver,
    /// By the position of every contact along the coordinate axes, 1/m, its frame as it is.
    pub point: Vec<SVector<f64, C>>,
    /// By the direction of every normal, 1/rad, in the contact frame: along a tangent t, by the angle by which the normal tilts towards
    /// it, `dn = φ t`, and the frame with it. Along the normal, by a turn of the tangents about it, from t₁ to t₂; zero in the plane.
    ///
    /// A rotation vector θ along the coordinate axes tilts by `φ_a = (θ × n)·t_a`; in the plane `t = (n_y, -n_x)`, and φ is an
    /// angle from y to x.
    pub normal: Vec<SVector<f64, C>>,
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// Derivatives of the onset by positions and normals of the contacts, one answer for each leaving contact, exact to first order: one
    /// linear solve for each datum. Empty where [`Self::onset_gradients`] is.
    ///
    /// What a contact carries is seen from its frame: a frame that turns or moves changes the grasp map,
    ///
    /// ```text
    /// dF_i = -K_i (G_iᵀdq + dG_iᵀq),      Σ (G_i dF_i + dG_i F_i) = 0,      dτ = -dm / m'
    /// ```
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    ///
    /// // Two fingers that each press with 10 N, μ = 0.5, under a weight whose line is the middle: each carries half of it.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(10.0);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    /// let onset = grasp.onset(&Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0])))?;
    ///
    /// // The left finger comes nearer to that line by d: its share is 1 / (2 - d), the onset 2 μ N (1 - d/2).
    /// let gradient = &grasp.onset_gradients_by_geometry(onset.event().expect("slides"))?[0];
    /// assert!((gradient.point[0][0] + 5.0).abs() < 1e-12);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotForHands`] for a grasp by a hand, whose joints would move a contact at another place otherwise. Directions of normals
    /// alone [`Self::sensitivity`] knows for hands, too.
    pub fn onset_gradients_by_geometry(
        &self,
        event: &OnsetEvent<D, C>,
    ) -> Result<Vec<GeometryGradient<C>>, Error> {
        self.refuse_hands("onset_gradients_by_geometry")?;
        let Some(margins) = OnsetMargins::new(self, event) else { return Ok(Vec::new()) };
        let none = vec![SVector::repeat(f64::NAN); self.len()];
        let empty = |leaving| GeometryGradient { leaving, point: none.clone(), normal: none.clone() };
        let mut gradients: Vec<_> = margins.leavers().map(empty).collect();
        for contact in 0..self.len() {
            for axis in 0..C {
                let by = margins.by(Parameter::Point { contact, axis });
                for (gradient, value) in gradients.iter_mut().zip(by.into_iter().flatten()) {
                    gradient.point[contact][axis] = value;
                }
                if C == 2 && axis == 0 {
                    // No tangents turn about a normal of the plane.
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
