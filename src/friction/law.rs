//! Coulomb's law between force and velocity of a contact, and the residuals of a force and a velocity that violate it.

use super::problem::{FrictionProblem, part};
use crate::numerics::Reals;
use nalgebra::{DVector, SVector};

/// The state of a contact by Coulomb's law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum ContactMode {
    /// The force is zero.
    Open,
    /// The velocity is zero.
    Sticking,
    /// Friction has its largest magnitude, μ r_N for the normal force r_N, and opposes the slip.
    Sliding,
}

/// Residuals of Coulomb's law for the forces r and the velocities u = W r + q of all contacts (see the [module](super)), without units.
///
/// Each contact is measured on its own scale. Forces are relative to its own force, velocities relative to the largest terms of its rows of W r + q.
/// A contact with a small force must thus satisfy the law as strictly as the others. The residuals do not depend on the units.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Residuals {
    /// The largest approach speed of a contact, −u_N for its normal velocity u_N. It is relative to the terms of W r + q that add up to its velocity.
    pub approach: f64,
    /// The largest distance of a contact force r from its friction cone ‖r_T‖ ≤ μ r_N, relative to ‖r‖.
    pub cone: f64,
    /// Let û = u + μ ‖u_T‖ n for the velocity u and the normal n of a contact with force r. Let ρ be ‖r‖ divided by the largest magnitude of the
    /// terms of W r + q that add up to u. The residual is the largest distance between r and the projection of r − ρ û onto the friction cone,
    /// relative to ‖r‖. It is zero if Coulomb's law holds.
    pub law: f64,
}

/// Infinite residuals, which exceed every tolerance.
const INFINITE_RESIDUALS: Residuals =
    Residuals { approach: f64::INFINITY, cone: f64::INFINITY, law: f64::INFINITY };

impl Residuals {
    /// Whether all three residuals are at most `tolerance`.
    #[must_use]
    pub fn within(&self, tolerance: f64) -> bool {
        [self.approach, self.cone, self.law].iter().all(|r| *r <= tolerance)
    }

    /// The largest of the three residuals; NaN if any of them is NaN.
    #[must_use]
    pub fn max(&self) -> f64 {
        let all = [self.approach, self.cone, self.law];
        if all.iter().any(|r| r.is_nan()) { f64::NAN } else { all.into_iter().most() }
    }
}

/// The tangential components of a vector; its normal component becomes zero.
pub(super) fn tangent<const C: usize>(v: &SVector<f64, C>) -> SVector<f64, C> {
    let mut tangent = *v;
    tangent[0] = 0.0;
    tangent
}

/// The point of the friction cone ‖x_T‖ ≤ μ x_N that is closest to x.
pub(super) fn projection<const C: usize>(x: &SVector<f64, C>, mu: f64) -> SVector<f64, C> {
    let slip = tangent(x);
    let size = slip.norm();
    if size <= mu * x[0] {
        return *x;
    }
    if mu * size <= -x[0] {
        return SVector::zeros();
    }
    let normal = (x[0] + mu * size) / (1.0 + mu * mu);
    let mut out = slip * (mu * normal / size);
    out[0] = normal;
    out
}

/// The residuals of one contact with the force `force` and the velocity `velocity`. `size` is the largest magnitude of the terms of W r + q that add
/// up to this velocity. Force and velocity are scaled first, so that no square overflows or underflows.
fn contact_residuals<const C: usize>(
    force: &SVector<f64, C>,
    velocity: &SVector<f64, C>,
    size: f64,
    mu: f64,
) -> Residuals {
    let mut out = Residuals { approach: 0.0, cone: 0.0, law: 0.0 };
    let velocity = if size > 0.0 { velocity / size } else { SVector::zeros() };
    out.approach = (-velocity[0]).max(0.0);
    let largest = force.amax();
    if largest > 0.0 {
        let force = force / largest;
        let pressed = force.norm();
        let mut dilated = velocity;
        dilated[0] += mu * tangent(&velocity).norm();
        out.law = (force - projection(&(force - dilated * pressed), mu)).norm() / pressed;
        out.cone = (force - projection(&force, mu)).norm() / pressed;
    }
    out
}

impl<const C: usize> FrictionProblem<C> {
    /// The residuals of the forces r (C n entries); infinite for a vector of another length or with entries that are not finite.
    #[must_use]
    pub fn residuals(&self, r: &DVector<f64>) -> Residuals {
        self.worst_residuals(r).0
    }

    /// The residuals of the forces r, each the largest over all contacts, and the index (from 0) of the contact with the largest residual.
    pub(super) fn worst_residuals(&self, r: &DVector<f64>) -> (Residuals, usize) {
        if r.len() != self.q.len() || r.iter().any(|r| !r.is_finite()) {
            return (INFINITE_RESIDUALS, 0);
        }
        let u = self.velocities(r);
        let terms = self.w.abs() * r.abs() + self.q.abs();
        if u.iter().chain(&terms).any(|x| !x.is_finite()) {
            return (INFINITE_RESIDUALS, 0);
        }
        self.residuals_from(r, &u, &terms)
    }

    /// The residuals of the given forces r and velocities u, each the largest over all contacts. Also the index (from 0) of the contact with the
    /// largest residual. `terms` has, for each component of u, the sum of the magnitudes of the terms of W r + q that add up to it.
    pub(super) fn residuals_from(
        &self,
        r: &DVector<f64>,
        u: &DVector<f64>,
        terms: &DVector<f64>,
    ) -> (Residuals, usize) {
        let mut out = Residuals { approach: 0.0, cone: 0.0, law: 0.0 };
        let (mut worst, mut most) = (0, 0.0);
        for i in 0..self.len() {
            let (force, velocity, size) = (part(r, i), part(u, i), part::<C>(terms, i).amax());
            let residuals = contact_residuals::<C>(&force, &velocity, size, self.mu[i]);
            if residuals.max().is_nan() {
                return (INFINITE_RESIDUALS, i);
            }
            if residuals.max() > most {
                (worst, most) = (i, residuals.max());
            }
            out.approach = out.approach.max(residuals.approach);
            out.cone = out.cone.max(residuals.cone);
            out.law = out.law.max(residuals.law);
        }
        (out, worst)
    }

    /// The state of a contact from ζ = r − ρ u, with its force r, its velocity u and a factor ρ > 0 that converts velocities to forces. The contact
    /// is open if ζ_N ≤ 0, sticks if ζ is inside the friction cone, and slides elsewhere.
    pub(super) fn state(
        force: &SVector<f64, C>,
        velocity: &SVector<f64, C>,
        mu: f64,
        rho: f64,
    ) -> ContactMode {
        let trial = force - velocity * rho;
        if trial[0] <= 0.0 {
            ContactMode::Open
        } else if tangent(&trial).norm() <= mu * trial[0] && mu > 0.0 {
            ContactMode::Sticking
        } else {
            ContactMode::Sliding
        }
    }
}
