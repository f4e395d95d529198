//! Sliding on the round cone, linearised: the slip direction turns as the stretch changes.
//!
//! Let v be the stretch of the contact's springs, K_t the diagonal matrix of the tangential stiffnesses, and F_n and F_t the normal and the friction
//! force. The slip is `s = λ F_t`, which defines λ. Let p = F_t / |F_t| and S = (K_t⁻¹ + λ)⁻¹. Then the differential of the friction force is the sum
//! of two terms,
//!
//! ```text
//! dF_t = μ dF_n P + κ d (d·dv),     P = S p / (p·S p),     κ = det S / (p·S p)
//! ```
//!
//! where d is the unit tangent at right angles to p. The first term is the friction on a facet of the cone with normal p. The second term is the
//! force of a spring across the slip direction, which the slip softens. In code names an edge is the linearised boundary of the cone.

use nalgebra::SVector;

use super::compliance::Compliance;
use super::tangential::{right_angle, tangential, tangential_norm};

/// A slide of a contact on the round cone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Slide {
    /// Unit direction p of the friction force and of the slip; no normal component.
    pub(crate) direction: SVector<f64, 3>,
    /// λ, the slip per unit of friction force, m/N.
    pub(crate) lambda: f64,
}

/// The law of a contact that slides on the boundary of its cone, linearised: the friction force is `F_t = μ F_n P + κ d (d·v)` at the stretch v.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Edge {
    /// P, the friction force for μ F_n = 1 if the spring across the slip is not stretched.
    pub(crate) pull: SVector<f64, 3>,
    /// d, the tangent at right angles to the slip direction. It is as long as the vector from which it was turned: 1 for a unit slip direction, |h|
    /// for a facet normal h.
    pub(crate) across: SVector<f64, 3>,
    /// κ, the stiffness across the slip, N/m; zero in the plane, at a corner of a polygon and without tangential springs.
    pub(crate) stiffness: f64,
}

impl Edge {
    /// Sliding without stiffness across the slip; `pull` is the friction force for μ F_n = 1.
    #[inline]
    pub(super) fn without_spring(pull: SVector<f64, 3>) -> Self {
        Self { pull, across: SVector::zeros(), stiffness: 0.0 }
    }
}

impl Slide {
    /// The slide of a contact whose friction force points along this vector, with the slip λ per unit of friction force, m/N.
    pub(crate) fn new(friction: &SVector<f64, 3>, lambda: f64) -> Self {
        Self { direction: tangential(friction) / tangential_norm(friction), lambda }
    }

    /// The linearised boundary of the cone on which the contact slides. The direction of this slide may also be a facet normal h of any length; P and
    /// `κ d dᵀ` then describe sliding on the facet `h·F_t <= μ F_n`.
    #[inline]
    pub(super) fn edge(&self, springs: &Compliance) -> Edge {
        if springs.axes() < 3 {
            return Edge::without_spring(self.direction);
        }
        let softened = springs.softened(self.lambda);
        let pulled = softened.component_mul(&self.direction);
        let along = 1.0 / self.direction.dot(&pulled);
        Edge {
            pull: pulled * along,
            across: self.perpendicular(),
            stiffness: softened[1] * (softened[2] * along),
        }
    }

    /// The slip direction turned by a right angle, in space.
    #[inline]
    pub(crate) fn perpendicular(&self) -> SVector<f64, 3> {
        right_angle(&self.direction)
    }
}
