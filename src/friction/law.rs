//! Coulomb's law between the force and the velocity of a contact, and the residuals of a pair.

use super::problem::{FrictionProblem, part};
use nalgebra::{DVector, SVector};

/// The state of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum ContactMode {
    /// It carries no force.
    Open,
    /// It does not move.
    Sticking,
    /// Its friction is μ r_N, against its slip.
    Sliding,
}

/// The violations of Coulomb's law by forces r and velocities u = W r + q, as pure numbers.
///
/// Each contact is measured by itself: forces relative to its own force, velocities relative to the largest terms of its rows of W r + q. So a
/// contact that carries little must obey the law as strictly as the others. Neither measure changes with the units of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Residuals {
    /// The largest approach speed −u_N of a contact.
    pub approach: f64,
    /// The largest distance of a force from its cone ‖r_T‖ ≤ μ r_N.
    pub cone: f64,
    /// The largest distance of r from the projection of r − ρ û onto the cone, û = u + μ ‖u_T‖ n, with ρ = ‖r‖ over the size of the terms: zero
    /// where the law holds.
    pub law: f64,
}

/// Residuals that no tolerance accepts.
const INFINITE_RESIDUALS: Residuals =
    Residuals { approach: f64::INFINITY, cone: f64::INFINITY, law: f64::INFINITY };

impl Residuals {
    /// Whether all of them are numbers of at most this size.
    #[must_use]
    pub fn within(&self, tolerance: f64) -> bool {
        [self.approach, self.cone, self.law].iter().all(|r| *r <= tolerance)
    }

    /// The largest of the three; NaN if any of them is NaN.
    #[must_use]
    pub fn max(&self) -> f64 {
        let all = [self.approach, self.cone, self.law];
        if all.iter().any(|r| r.is_nan()) { f64::NAN } else { all.into_iter().fold(0.0, f64::max) }
    }
}

/// The tangential components.
pub(super) fn tangent<const C: usize>(v: &SVector<f64, C>) -> SVector<f64, C> {
    let mut tangent = *v;
    tangent[0] = 0.0;
    tangent
}

/// The nearest point of the cone ‖x_T‖ ≤ μ x_N.
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

/// The residuals of a contact whose velocity has terms of this size. Force and velocity are scaled first, so that no square
/// leaves the range of doubles.
fn missed<const C: usize>(
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
    /// The residuals of the forces r (C n entries). They are infinite for a vector of another length or with entries
    /// that are not finite.
    #[must_use]
    pub fn residuals(&self, r: &DVector<f64>) -> Residuals {
        self.missed_by(r).0
    }

    /// The residuals, and the contact with the largest.
    pub(super) fn missed_by(&self, r: &DVector<f64>) -> (Residuals, usize) {
        if r.len() != self.q.len() || r.iter().any(|r| !r.is_finite()) {
            return (INFINITE_RESIDUALS, 0);
        }
        let u = self.velocities(r);
        let terms = self.w.abs() * r.abs() + self.q.abs();
        if u.iter().chain(&terms).any(|x| !x.is_finite()) {
            return (INFINITE_RESIDUALS, 0);
        }
        self.judged(r, &u, &terms)
    }

    /// The residuals of forces, velocities and the sizes of their terms, and the contact with the largest.
    pub(super) fn judged(
        &self,
        r: &DVector<f64>,
        u: &DVector<f64>,
        terms: &DVector<f64>,
    ) -> (Residuals, usize) {
        let mut out = Residuals { approach: 0.0, cone: 0.0, law: 0.0 };
        let (mut worst, mut most) = (0, 0.0);
        for i in 0..self.len() {
            let (force, velocity, size) = (part(r, i), part(u, i), part::<C>(terms, i).amax());
            let missed = missed::<C>(&force, &velocity, size, self.mu[i]);
            if missed.max().is_nan() {
                return (INFINITE_RESIDUALS, i);
            }
            if missed.max() > most {
                (worst, most) = (i, missed.max());
            }
            out.approach = out.approach.max(missed.approach);
            out.cone = out.cone.max(missed.cone);
            out.law = out.law.max(missed.law);
        }
        (out, worst)
    }

    /// The state of a contact, by the region of r − ρ u: open below zero, sticking inside the cone, sliding elsewhere.
    pub(super) fn state(
        force: &SVector<f64, C>,
        velocity: &SVector<f64, C>,
        mu: f64,
        rho: f64,
    ) -> ContactMode {
        let tried = force - velocity * rho;
        if tried[0] <= 0.0 {
            ContactMode::Open
        } else if tangent(&tried).norm() <= mu * tried[0] && mu > 0.0 {
            ContactMode::Sticking
        } else {
            ContactMode::Sliding
        }
    }
}
