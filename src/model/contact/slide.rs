//! Sliding on the round cone, to first order: the direction of slip turns with the stretch.
//!
//! With `s = λ F_t`, p = F_t / |F_t| and S = (K_t⁻¹ + λ)⁻¹ the force changes with the stretch like the force of two springs,
//!
//! ```text
//! dF_t = μ dF_n P + κ d (d·dv),     P = S p / (p·S p),     κ = det S / (p·S p)
//! ```
//!
//! with d the tangent across p: a facet of the cone with normal p, and a spring across the slip, softened by the slip.

use nalgebra::SVector;

use super::compliance::Compliance;
use super::tangential::{right_angle, tangential, tangential_norm};

/// A slide on the round cone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Slide {
    /// Unit direction p of the friction force and of the slip; no normal component.
    pub(crate) direction: SVector<f64, 3>,
    /// Slip per force λ, m/N.
    pub(crate) lambda: f64,
}

/// The edge of the cone on which a contact slides, to first order: `F_t = μ F_n P + κ d (d·v)`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Edge {
    /// P, the friction force for μ F_n = 1 at zero stretch of the spring across.
    pub(crate) pull: SVector<f64, 3>,
    /// d, the tangent across the slip, with the length of the direction of the slip.
    pub(crate) across: SVector<f64, 3>,
    /// κ, N/m; zero in the plane, at a corner of a polygon and without tangential springs.
    pub(crate) stiffness: f64,
}

impl Edge {
    /// An edge without a spring across.
    #[inline]
    pub(super) fn without_spring(pull: SVector<f64, 3>) -> Self {
        Self { pull, across: SVector::zeros(), stiffness: 0.0 }
    }
}

impl Slide {
    /// The slide of a contact with a friction force along this vector and this slip per force λ.
    pub(crate) fn new(friction: &SVector<f64, 3>, lambda: f64) -> Self {
        Self { direction: tangential(friction) / tangential_norm(friction), lambda }
    }

    /// The edge of the cone on which the contact slides. The direction may be a facet normal h of any length: P and
    /// `κ d dᵀ` then belong to the facet `h·F_t <= μ F_n`.
    #[inline]
    pub(super) fn edge(&self, springs: &Compliance) -> Edge {
        if springs.axes() < 3 {
            return Edge::without_spring(self.direction);
        }
        let softened = springs.softened(self.lambda);
        let pulled = softened.component_mul(&self.direction);
        let along = 1.0 / self.direction.dot(&pulled);
        Edge { pull: pulled * along, across: self.across(), stiffness: softened[1] * (softened[2] * along) }
    }

    /// The direction of the slip turned by a right angle, in space.
    #[inline]
    pub(crate) fn across(&self) -> SVector<f64, 3> {
        right_angle(&self.direction)
    }
}
