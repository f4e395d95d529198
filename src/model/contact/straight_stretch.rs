//! The exact force after a stretch that grew along a straight line, while the slip direction turned.
//!
//! While the stretch grows, the time τ runs from 0 to 1; a prime is a derivative with respect to τ. Let k_t be the tangential stiffness, equal in all
//! directions, and v_t the tangential stretch. A contact that slides on the round cone has its friction force at an angle ψ from the traction rate
//! `d = k_t v_t'`. Let d be constant and the radius `r = μ F_n` of the cone linear in τ. Let ψ₀ and r₀ be the values at the start of an interval Δτ,
//! and r₁ the radius at its end. Then
//!
//! ```text
//! r ψ' = -|d| sin ψ        tan(ψ/2) = tan(ψ₀/2) exp(-|d| ∫dτ/r),      ∫dτ/r = Δτ ln(r₁/r₀) / (r₁ - r₀)
//! ```
//!
//! With two different tangential stiffnesses [`RelaxingSlide`] gives the direction. Once sliding begins, it continues to the end, since |d| cos ψ
//! grows and r' is constant. The return map of [`LocalLaw::answer`] uses only the final stretch instead. It is exact if sliding starts at the apex,
//! where the traction keeps its direction; otherwise it is correct to first order. For the same closed form with a constant radius see R. D. Krieg
//! and D. B. Krieg, Accuracies of numerical solution methods for the elastic-perfectly plastic model, J. Pressure Vessel Technology 99 (1977) 510.

use crate::numerics::Each;
use nalgebra::SVector;

use super::answer::ContactResponse;
use super::law::LocalLaw;
use super::relaxing_slide::RelaxingSlide;
use super::slide::Slide;
use super::state::Mode;
use super::tangential::{tangential, tangential_norm};
use crate::numerics::tolerances::SOLVED_ROUNDING;
#[cfg(not(feature = "std"))]
use crate::prelude::*;

impl LocalLaw<'_> {
    /// State and force of a contact whose stretch has grown along a straight line from `before` to `stretch`, m. The caller subtracts any earlier
    /// slip from `before`, so that the force at `before` follows from the springs alone; [`Compliance::slip`](super::Compliance::slip) returns that
    /// slip. In the plane, or without sliding, the result equals [`Self::answer`] at `stretch`. The exception is a contact that closes between
    /// `before` and `stretch`: friction starts when the contact closes.
    pub(crate) fn answer_after(
        &self,
        before: &SVector<f64, 3>,
        stretch: &SVector<f64, 3>,
    ) -> ContactResponse {
        if self.friction.is_frictionless() {
            return self.answer(stretch, 0.0);
        }
        let [from, to] = [before, stretch].each(|v| self.springs.force(v));
        if to[0] <= 0.0 && self.may_open() {
            return ContactResponse::open();
        }
        let rate = to - from;
        if from[0] < 0.0 && self.may_open() {
            // The contact closes between `before` and `stretch`: only the tangential stretch after closing causes friction.
            let mut since = (stretch - before) * (to[0] / rate[0]).clamp(0.0, 1.0);
            since[0] = stretch[0];
            return self.answer(&since, 0.0);
        }
        if !self.is_round() || from[0] <= 0.0 {
            return self.answer(stretch, 0.0);
        }
        match self.stops_sticking(&from, &rate) {
            None => ContactResponse { state: Mode::Sticking, force: to },
            Some(tau) => self.slid_on(&(from + rate * tau), &rate, 1.0 - tau),
        }
    }

    /// The time τ from 0 to 1 at which the traction reaches the friction limit μ F_n. τ is zero if the traction is at the limit and grows faster than
    /// the limit. `None` if the limit is not reached.
    fn stops_sticking(&self, from: &SVector<f64, 3>, rate: &SVector<f64, 3>) -> Option<f64> {
        let (t, d) = (tangential(from), tangential(rate));
        let (r, growth) = (self.friction.limit(from[0]), self.friction.limit(rate[0]));
        let size = t.norm();
        // A traction that differs from the friction limit by at most the fraction `SOLVED_ROUNDING` is on the cone. The previous step along the load
        // path leaves such rounding errors.
        if size >= r * (1.0 - SOLVED_ROUNDING) && t.dot(&d) > growth * size {
            return Some(0.0);
        }
        // Solves |t + τ d|² = (r + τ r')² for τ. t is the traction at τ = 0 and d its rate; r is the friction limit at τ = 0 and r' (`growth`) its
        // rate. The left side less the right side is negative inside the cone.
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

    /// State and force after sliding for the remaining time `rest`, from a force on the boundary of the cone.
    fn slid_on(&self, from: &SVector<f64, 3>, rate: &SVector<f64, 3>, rest: f64) -> ContactResponse {
        let normal = from[0] + rate[0] * rest;
        let [r0, r1] = [from[0], normal].each(|f| self.friction.limit(f.max(0.0)));
        // The integral ∫dτ/r over the remaining time, with the friction limit r.
        let x = (r1 - r0) / r0;
        // For |x| < 1e-7 the first terms of the series replace the quotient ln(1 + x)/x, which is 0/0 for equal radii.
        let per_radius = rest / r0 * if x.abs() < 1e-7 { 1.0 - 0.5 * x } else { x.ln_1p() / x };
        let friction = tangential(from);
        let size = friction.norm();
        let mut direction = tangential(rate);
        if size > 0.0 {
            let across = |v: SVector<f64, 3>| [v[1], v[2]];
            let slide = RelaxingSlide {
                tangential: across(self.springs.diagonal()),
                stretched: across(self.springs.deflection(rate)),
                growth: self.friction.limit(rate[0]),
            };
            [direction[1], direction[2]] = slide.direction_after(across(friction / size), per_radius);
        }
        self.sliding_at(normal, &direction, r1, r1 * per_radius)
    }

    /// State and force of a contact that slides along `direction` with the normal force `normal` and the friction limit r, N. The slip reduces the
    /// stiffness of the spring across the slip to the fraction `stiffness_fraction`. The fraction is clamped to the range from [`SOLVED_ROUNDING`] to
    /// 1, since the compliance is infinite at zero.
    fn sliding_at(
        &self,
        normal: f64,
        direction: &SVector<f64, 3>,
        r: f64,
        stiffness_fraction: f64,
    ) -> ContactResponse {
        if tangential_norm(direction) == 0.0 {
            let mut force = SVector::zeros();
            force[0] = normal;
            return ContactResponse { state: Mode::Sticking, force };
        }
        let lambda =
            self.springs.deflection_along(1, 1.0 / stiffness_fraction.clamp(SOLVED_ROUNDING, 1.0) - 1.0);
        let slide = Slide::new(direction, lambda);
        let mut force = slide.direction * r;
        force[0] = normal;
        ContactResponse { state: Mode::Round(slide), force }
    }
}
