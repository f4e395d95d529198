//! The compliance of one contact: one spring along each axis of its frame, which stands for the object's spring and the finger's spring in series.
//! All other code of the contact law uses stiffnesses through this type.
//!
//! Let a be the commanded displacement of the finger less the clearance, u_c the displacement of the object's contact point, g the gap and s the
//! slip. Then
//!
//! ```text
//! F = K v,   K = diag(k_n, k_t…),   v = a - u_c + g - s        spring deflection v, m; force F, N; stiffness K, N/m
//! ```
//!
//! **Energy units.** `x = K^{-1/2}F = K^{1/2}v` has the unit √J, and `½|x|²` is the stored energy. In these units every spring has the stiffness one.

use nalgebra::SVector;

use crate::numerics::{DoubleDouble, Reals, by_axis};
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// The springs of one contact along the axes of its frame, the normal first. Each is the object's spring and the finger's spring in series.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Compliance {
    /// Stiffness along each axis of the contact frame, N/m; zero along an axis without a spring.
    k: SVector<f64, 3>,
    /// Number of axes with a spring: 1 without friction, else 2 in the plane and 3 in space.
    axes: usize,
}

impl Compliance {
    /// Springs along the first `axes` axes, with the positive stiffnesses `series`, N/m.
    pub(crate) fn new(series: &SVector<f64, 3>, axes: usize) -> Self {
        Self { k: by_axis(|a| if a < axes { series[a] } else { 0.0 }), axes }
    }

    #[inline(always)]
    pub(crate) fn axes(&self) -> usize {
        self.axes
    }

    /// Whether the contact has tangential springs, and so can carry a tangential force.
    pub(crate) fn resists_tangentially(&self) -> bool {
        self.axes > 1
    }

    /// Elastic force `K v` of a stretch v, N.
    #[inline(always)]
    pub(crate) fn force(&self, stretch: &SVector<f64, 3>) -> SVector<f64, 3> {
        self.k.component_mul(stretch)
    }

    /// Component of the elastic force `K v` along an axis, N.
    #[inline(always)]
    pub(crate) fn force_along(&self, axis: usize, stretch: f64) -> f64 {
        self.k[axis] * stretch
    }

    /// The stiffnesses along the axes, the diagonal of K, N/m.
    #[inline(always)]
    pub(crate) fn diagonal(&self) -> SVector<f64, 3> {
        self.k
    }

    /// Elastic deflection `K⁻¹F` under a force F, m; zero along axes without a spring.
    pub(crate) fn deflection(&self, force: &SVector<f64, 3>) -> SVector<f64, 3> {
        by_axis(|a| if a < self.axes { force[a] / self.k[a] } else { 0.0 })
    }

    /// Component of the deflection `K⁻¹F` along an axis that has a spring, m.
    #[inline(always)]
    pub(crate) fn deflection_along(&self, axis: usize, force: f64) -> f64 {
        force / self.k[axis]
    }

    /// Component of the deflection `K⁻¹F` along an axis that has a spring, in double-double precision, m.
    pub(crate) fn precise_deflection_along(&self, axis: usize, force: DoubleDouble) -> DoubleDouble {
        force.over(self.k[axis])
    }

    /// The slip at a stretch v under a force F, m: the tangential part of `v - K⁻¹F`, or of v itself along axes without a spring.
    pub(crate) fn slip(&self, stretch: &SVector<f64, 3>, force: &SVector<f64, 3>) -> SVector<f64, 3> {
        let mut slip = stretch - self.deflection(force);
        slip[0] = 0.0;
        slip
    }

    /// Elastic energy `½ F·K⁻¹F` that the springs store under a force F, J.
    pub(crate) fn stored(&self, force: &SVector<f64, 3>) -> f64 {
        (0..self.axes).map(|a| 0.5 * force[a] * force[a] / self.k[a]).added()
    }

    /// The diagonal of `K^{1/2}`, which converts forces from energy units to N, and stretches from m to energy units.
    pub(crate) fn root(&self) -> SVector<f64, 3> {
        self.k.map(f64::sqrt)
    }

    /// The square root of the stiffness along an axis, √(N/m): the entry of `K^{1/2}`.
    #[inline(always)]
    pub(crate) fn root_along(&self, axis: usize) -> f64 {
        self.k[axis].sqrt()
    }

    /// Stiffness along the axis `one` divided by the stiffness along the axis `other`, which must have a spring.
    pub(crate) fn ratio(&self, one: usize, other: usize) -> f64 {
        self.k[one] / self.k[other]
    }

    /// Whether the tangential springs are equally stiff; always true in the plane, where a contact has only one tangential spring.
    pub(crate) fn is_isotropic(&self) -> bool {
        self.axes < 3 || self.k[1] == self.k[2]
    }

    /// Normal stiffness divided by the stiffness along the last axis with a spring; 1 without tangential springs.
    pub(crate) fn ratio_to_the_last(&self) -> f64 {
        self.k[0] / self.k[self.axes - 1]
    }

    /// The largest of all spring stiffnesses, N/m.
    #[inline(always)]
    pub(crate) fn stiffest(&self) -> f64 {
        self.k.amax()
    }

    /// The smallest of all spring stiffnesses, N/m.
    pub(crate) fn softest(&self) -> f64 {
        self.k.iter().take(self.axes).fold(f64::INFINITY, |least, k| least.min(*k))
    }

    /// The softer and the stiffer of the tangential springs, N/m; in the plane both are the stiffness of the only tangential spring.
    pub(crate) fn tangential_range(&self) -> [f64; 2] {
        let last = self.k[self.axes - 1];
        [self.k[1].min(last), self.k[1].max(last)]
    }

    /// The diagonal of `S = (K_t⁻¹ + λ)⁻¹`, N/m, with zero along the normal. K_t has the tangential stiffnesses, λ is the slip per unit of friction
    /// force, m/N. S is the stiffness of the tangential springs in series with this slip.
    #[inline(always)]
    pub(crate) fn softened(&self, lambda: f64) -> SVector<f64, 3> {
        by_axis(|a| if a == 0 { 0.0 } else { self.k[a] * self.softening(a, lambda) })
    }

    /// Factor `1 / (1 + λ k)` by which slip softens the spring of stiffness k along a tangential axis. λ is the slip per unit of friction force, m/N.
    #[inline(always)]
    pub(crate) fn softening(&self, axis: usize, lambda: f64) -> f64 {
        1.0 / (1.0 + lambda * self.k[axis])
    }
}
