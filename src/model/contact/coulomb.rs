//! Coulomb's cone `|F_t| <= μ F_n` of one contact. All other code of the contact law uses friction coefficients through this type.
//!
//! A facet of a polygonal cone is `h·F_t <= μ F_n` with an outward normal h. A margin is what is left of a friction limit, such as `μ F_n - |F_t|`.
//! In code names the edges of a cone are its boundary, which separates sticking from sliding.

use nalgebra::SVector;

use super::compliance::Compliance;
use super::tangential::tangential_norm;
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// A coefficient of friction, from 0 to infinity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Coulomb {
    mu: f64,
}

impl Coulomb {
    pub(crate) fn new(mu: f64) -> Self {
        Self { mu }
    }

    pub(crate) fn is_frictionless(self) -> bool {
        self.mu == 0.0
    }

    pub(crate) fn is_infinite(self) -> bool {
        self.mu.is_infinite()
    }

    /// Whether the cone has a boundary with friction, which is so if the coefficient is neither zero nor infinite.
    #[inline(always)]
    pub(crate) fn has_edges(self) -> bool {
        self.mu > 0.0 && self.mu.is_finite()
    }

    /// This cone or, if friction is infinite, a cone with a very large finite coefficient. An infinite coefficient allows every tangential force and
    /// so has no facets.
    pub(crate) fn with_edges(self, springs: &Compliance) -> Self {
        if self.mu.is_finite() {
            return self;
        }
        // Facets are needed only so that the tangential force vanishes with the normal force, when the contact opens. The coefficient is so large
        // that the contact does not slide before it opens. If the normal spring is stiffer than the tangential springs, the coefficient grows with
        // √(k_n/k_t).
        Self { mu: 1e8 * springs.ratio_to_the_last().sqrt().max(1.0) }
    }

    /// The friction limit `μ F_n`, N.
    #[inline(always)]
    pub(crate) fn limit(self, normal_force: f64) -> f64 {
        self.mu * normal_force
    }

    /// The force `e_n + μ t` on the boundary of the cone, for unit normal force and a tangential unit vector t.
    pub(crate) fn generator(self, t: &SVector<f64, 3>) -> SVector<f64, 3> {
        let mut force = t * self.mu;
        force[0] = 1.0;
        force
    }

    /// The vector `(μ, -h)`, whose product with a force is the margin `μ F_n - h·F_t` of the facet with normal h.
    pub(crate) fn facet_row(self, h: &SVector<f64, 3>) -> SVector<f64, 3> {
        let mut row = -h;
        row[0] = self.mu;
        row
    }

    /// Margin at a facet, `μ F_n - h·F_t`, N.
    #[inline(always)]
    pub(crate) fn facet_margin(self, force: &SVector<f64, 3>, h: &SVector<f64, 3>) -> f64 {
        self.mu * force[0] - h.dot(force)
    }

    /// Margin on the round cone, `μ F_n - |F_t|`, N.
    #[inline(always)]
    pub(crate) fn round_margin(self, force: &SVector<f64, 3>) -> f64 {
        self.mu * force[0] - tangential_norm(force)
    }

    /// Rounding error of a facet's margin `μ F_n - h·F_t`, as a multiple of the rounding error of the force.
    #[inline(always)]
    pub(crate) fn facet_weight(self, h: &SVector<f64, 3>) -> f64 {
        self.mu + h.norm()
    }

    /// Rounding error of the round cone's margin `μ F_n - |F_t|`, as a multiple of the rounding error of the force. For infinite friction the
    /// margin is infinite and has no rounding error; 1 then keeps products with this factor finite.
    #[inline(always)]
    pub(crate) fn round_weight(self) -> f64 {
        if self.mu.is_finite() { 1.0 + self.mu } else { 1.0 }
    }
}
