//! Errors of contact forces that a step made at once (in a single step of the same length) has in common with the same step made in two halves. The
//! difference between the two results does not reveal these errors. The step made at once assumes that the twist and the stretches change along one
//! straight line. The step in two halves assumes one straight line in each half.
//!
//! Along a step of length h the true twist deviates from a straight line, in the middle by the twist `off`. Let a contact have the grasp map G,
//! springs of stiffness K (k_n along the normal), the stretch v with the normal part v_n and the tangential part v_t, and the coefficient of friction
//! μ. A prime is the derivative along the step. Over the step the rate of its spring force, times h, changes by `K v'' h² = 8 K Gᵀ off`. Let the
//! contact slide along the unit vector p. A point P is the beginning, middle or end of the step. At P the motion drives the force out of the cone at
//! the rate `a = (p·K v_t' - μ k_n v_n') h` per step. At the fraction s of the step beyond P this rate is a + c s, with `c = a' h` < 0. The contact
//! stops where the rate is zero. In the computed step the rate is constant within each half, so that the contact stops at P or slides on through the
//! whole half. This causes an error of the contact force:
//!
//! ```text
//! stop at s = a / |c|,     error of the force a² / 2|c|,
//! if |s| < 1/4, i.e. the stop is nearer than half the length of a straight line
//! ```
//!
//! A straight line is here half a step long. The error is at most |c| / 32, a quarter of the force by which the displacement `off` stretches the
//! springs. The same bound holds for the distance by which a sticking contact's force may have been outside its cone within the step. It also holds
//! for the error of the force of an opening or closing contact.
//!
//! If a contact begins to slide, the derivative of the twist with respect to the fraction of the leg that is done jumps. The twist then deviates by
//! up to `2 off`. The component of this deviation along the slip of a sliding contact changes no force. The component across the slip changes the
//! friction force as if the contact stuck. Thus only the rotation of friction forces on the cones makes an error.

use nalgebra::SVector;

use super::one_step::{StepProblem, SteppedState};
use crate::contact::{Mode, Slide, tangential, tangential_norm};
use crate::numerics::{Each, Reals, Vector};

impl StepProblem<'_> {
    /// Estimate of the largest error of a contact force, N, at the end of a step in two halves. It covers the errors that the same step made at once
    /// has, too. `at` are the path points (forces, twist, slips and contact states) at the beginning, middle and end of the step.
    pub(super) fn shared_error(&self, at: [&SteppedState; 3]) -> f64 {
        (0..self.problem.len()).map(|i| self.shared_error_of(i, at)).most()
    }

    fn shared_error_of(&self, i: usize, at: [&SteppedState; 3]) -> f64 {
        let [from, middle, to] = at;
        let (site, local) = (&self.problem.sites[i], self.problem.local(i));
        if !local.may_open() && !local.may_slide() {
            return 0.0;
        }
        let made_of = |motion: Vector| site.springs.force(&site.map.tr_mul(&motion));
        let bend = made_of(&middle.twist - (&from.twist + &to.twist) * 0.5);
        // The path point in the middle shows how far the twist deviates from a straight line over the whole step. The deviation is quadratic in the
        // length, so in the middle of half a step it is a quarter of that in the middle of the whole step.
        let off = 0.25 * bend.norm();
        let drawn = |a: &SteppedState, b: &SteppedState| {
            site.springs.force(&(self.change(i) * (b.fraction - a.fraction))) - made_of(&b.twist - &a.twist)
        };
        let bend_at = |began: &SVector<f64, 3>, slide: &Slide| {
            let began = tangential(began);
            let turned = (began / tangential_norm(&began) - slide.direction).norm();
            // If a contact begins to slide within a half of the step, the derivative of the twist with respect to the fraction of the leg jumps
            // there. The twist then deviates from a straight line by up to twice its deviation in the middle. The error of the friction force is at
            // most this deviation, as a force in the springs, times the angle by which the direction of slip turns. The deviation, as a force, is
            // capped at the magnitude of the friction force: a turn by an angle changes the friction force by at most this magnitude times the angle.
            let most = (2.0 * bend.norm()).min(tangential_norm(&began));
            if turned > 0.0 { most * turned } else { 0.0 }
        };
        let half = |a: &SteppedState, b: &SteppedState| match (&a.states[i], &b.states[i]) {
            (Mode::Sticking, Mode::Sticking) if local.may_slide() => {
                let margin = local.margin(&a.forces[i]).min(local.margin(&b.forces[i]));
                (off - margin / local.cone().round_weight()).max(0.0)
            }
            (Mode::Sticking, Mode::Round(slide)) => {
                // The contact stuck during the fraction `stuck` of the half step, and slid during the rest. The state of the contact stores this rest
                // as the factor by which slip softens the springs. This is exact if the normal force is constant.
                let stuck = 1.0 - site.springs.softening(1, slide.lambda);
                bend_at(&(a.forces[i] + drawn(a, b) * stuck), slide)
            }
            (Mode::Round(_), Mode::Round(slide)) => bend_at(&a.forces[i], slide),
            (a, b) if a.is_open() != b.is_open() => off,
            _ => 0.0,
        };
        let worst = half(from, middle).max(half(middle, to));
        if !at.iter().any(|at| at.states[i].slides()) {
            return worst;
        }
        let chord = drawn(from, to);
        let stops = |(at, part): (&SteppedState, f64)| {
            let Some(slide) = at.states[i].slide() else { return 0.0 };
            let across = |rate: &SVector<f64, 3>| -local.cone().facet_margin(rate, &slide.direction);
            let (a, c) = (across(&(chord + bend * part)), 8.0 * across(&bend));
            if c < 0.0 && a.abs() < 0.25 * -c { 0.5 * a * a / -c } else { 0.0 }
        };
        [(from, -4.0), (middle, 0.0), (to, 4.0)].each(stops).into_iter().fold(worst, f64::max)
    }
}
