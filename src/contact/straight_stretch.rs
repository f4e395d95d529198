//! From a stretch that goes straight from where it was to the force at its end, exactly: the slip that turns on the way included.
//!
//! On the round cone a sliding contact with one tangential stiffness has its friction force at an angle ψ from the traction rate `d = k_t v_t'`. With
//! that and the radius `r = μ F_n` straight in the way τ from 0 to 1,
//!
//! ```text
//! r ψ' = -|d| sin ψ        tan(ψ/2) = tan(ψ₀/2) exp(-|d| ∫dτ/r),      ∫dτ/r = Δτ ln(r₁/r₀) / (r₁ - r₀)
//! ```
//!
//! and with two of them as [`RelaxingSlide`] has it. It slides on to the end once it slides, since |d| cos ψ grows and r' stays. The return map of [`LocalLaw::answer`] takes the whole way at
//! its end instead: it is right from the apex on, where the traction grows in one direction, else to first order only. See for the same closed
//! form with a constant radius R. D. Krieg and D. B. Krieg, Accuracies of numerical solution methods for the elastic-perfectly plastic model, J.
//! Pressure Vessel Technology 99 (1977) 510.

use nalgebra::SVector;

use super::answer::ContactResponse;
use super::law::LocalLaw;
use super::relaxing_slide::RelaxingSlide;
use super::slide::Slide;
use super::state::Mode;
use super::tangential::{tangential, tangential_norm};
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// A traction this near to its limit, as a part of it, is on the cone: what a step leaves is rounding of it.
const ON_THE_CONE: f64 = 1e-12;
/// Logarithms of radii that differ by less than this part are their first terms.
const ALIKE: f64 = 1e-7;

impl<const C: usize> LocalLaw<'_, C> {
    /// State and force where the stretch has gone straight from `before`, at rest and on its law there, to `stretch`. The slip until then
    /// is what the springs do not explain, [`Compliance::slip`](super::Compliance::slip). In the plane and where nothing can slide as [`Self::answer`] has it.
    pub(crate) fn answer_after(
        &self,
        before: &SVector<f64, C>,
        stretch: &SVector<f64, C>,
    ) -> ContactResponse<C> {
        if C == 2 || !self.is_round() || self.friction.is_frictionless() {
            return self.answer(stretch, 0.0);
        }
        let [from, to] = [before, stretch].map(|v| self.springs.force(v));
        if to[0] <= 0.0 && self.may_open() {
            return ContactResponse::open();
        }
        let rate = to - from;
        if from[0] <= 0.0 {
            // It closes on the way.
            let mut since = (stretch - before) * (to[0] / rate[0]).clamp(0.0, 1.0);
            since[0] = stretch[0];
            return self.answer(&since, 0.0);
        }
        match self.stops_sticking(&from, &rate) {
            None => ContactResponse { state: Mode::Sticking, force: to },
            Some(tau) => self.slid_on(&(from + rate * tau), &rate, 1.0 - tau),
        }
    }

    /// Where on the way a traction reaches its limit, or stands there and is drawn across.
    fn stops_sticking(&self, from: &SVector<f64, C>, rate: &SVector<f64, C>) -> Option<f64> {
        let (t, d) = (tangential(from), tangential(rate));
        let (r, growth) = (self.friction.limit(from[0]), self.friction.limit(rate[0]));
        let size = t.norm();
        if size >= r * (1.0 - ON_THE_CONE) && t.dot(&d) > growth * size {
            return Some(0.0);
        }
        // |t + τ d|² = (r + τ r')², with what is inside negative now.
        let (a, b) = (d.norm_squared() - growth * growth, t.dot(&d) - r * growth);
        let c = ((size - r) * (size + r)).min(0.0);
        let root = b * b - a * c;
        if root < 0.0 {
            return None;
        }
        let under = b + root.sqrt();
        let tau = if c == 0.0 && b <= 0.0 { -2.0 * b / a } else { -c / under };
        (tau > 0.0 && tau < 1.0).then_some(tau)
    }

    /// A contact that slides from a force on its cone for a part of the way.
    fn slid_on(&self, from: &SVector<f64, C>, rate: &SVector<f64, C>, rest: f64) -> ContactResponse<C> {
        let normal = from[0] + rate[0] * rest;
        let [r0, r1] = [from[0], normal].map(|f| self.friction.limit(f.max(0.0)));
        // ∫dτ/r over what is left of the way.
        let x = (r1 - r0) / r0;
        let per_radius = rest / r0 * if x.abs() < ALIKE { 1.0 - 0.5 * x } else { x.ln_1p() / x };
        let friction = tangential(from);
        let size = friction.norm();
        let mut direction = tangential(rate);
        if size > 0.0 {
            let across = |v: SVector<f64, C>| [v[1], v[C - 1]];
            let slide = RelaxingSlide {
                tangential: across(self.springs.diagonal()),
                stretched: across(self.springs.give(rate)),
                growth: self.friction.limit(rate[0]),
            };
            [direction[1], direction[C - 1]] = slide.direction_after(across(friction / size), per_radius);
        }
        self.sliding_at(normal, &direction, r1, r1 * per_radius)
    }

    /// A contact that slides along a direction in the end. Its springs across hold by this part: softened by the slip.
    fn sliding_at(&self, normal: f64, direction: &SVector<f64, C>, r: f64, holds: f64) -> ContactResponse<C> {
        if tangential_norm(direction) == 0.0 {
            let mut force = SVector::zeros();
            force[0] = normal;
            return ContactResponse { state: Mode::Sticking, force };
        }
        let lambda = self.springs.give_along(1, 1.0 / holds.clamp(ON_THE_CONE, 1.0) - 1.0);
        let slide = Slide::new(direction, lambda);
        let mut force = slide.direction * r;
        force[0] = normal;
        ContactResponse { state: Mode::Round(slide), force }
    }
}
