//! The direction in which a contact with unequal tangential springs slides during a straight stretch. The direction turns gradually towards the
//! direction of the stretch rate.
//!
//! The friction force is r p, with the cone's radius r = μ F_n and the unit vector p at an angle φ from the first tangent. The contact slips along
//! p. A prime is a derivative with respect to the time τ, from 0 to 1; v is the stretch, and p⊥ is p turned by a right angle. With K = diag(k₁, k₂)
//! the spring law gives
//!
//! ```text
//! r p·K p φ' = k₁k₂ p⊥·v_t' + r' p⊥·K p
//! dφ/ds = A sin(θ - φ) + B sin 2φ,      ds = dτ / (r p·K p),   A = k₁k₂ |v_t'|,   B = r' (k₂ - k₁)/2
//! ```
//!
//! where v_t' has the angle θ from the first tangent. s is called the path parameter; it is 0 where sliding begins. With only one of the two terms,
//! the equation for φ has a closed solution: `under_stretch` with the term in A, `squeezed` with the term in B. The solution `under_stretch` also
//! gives `∫ p·K p ds = ∫ dτ/r`, which determines s. With the initial angles ψ₀ and φ₀
//!
//! ```text
//! under_stretch    tan(ψ/2) = tan(ψ₀/2) e^{-A s}, ψ = φ - θ
//! squeezed         tan φ = tan φ₀ e^{2B s}
//! ```
//!
//! Half a step `under_stretch`, a whole step `squeezed` and half a step `under_stretch` (Strang splitting) are correct to second order. They are
//! exact for a constant normal force or equal springs. Sliding never stops: the slip rate γ obeys γ p·K p = p·K v_t' - r'. Whenever γ vanishes, the
//! right-hand side has the derivative `(p⊥·K v_t')²/r` with respect to τ. This is not negative, so γ does not become negative.

use crate::numerics::Each;
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// A contact with two tangential springs that slides under a constant rate of stretch; the time τ from 0 to 1 has no unit.
#[derive(Debug, Clone, Copy)]
pub(super) struct RelaxingSlide {
    /// Tangential stiffnesses k₁ and k₂, N/m.
    pub(super) tangential: [f64; 2],
    /// Rate of the tangential stretch, v_t', in m per unit of the time τ.
    pub(super) stretched: [f64; 2],
    /// Rate r' of the friction limit r = μ F_n, in N per unit of the time τ.
    pub(super) growth: f64,
}

impl RelaxingSlide {
    /// The unit direction of the friction force at a time τ. This time is given by `per_radius`, the integral `∫ dτ/r` since sliding began, in 1/N.
    /// Sliding begins with the direction `start`.
    pub(super) fn direction_after(&self, start: [f64; 2], per_radius: f64) -> [f64; 2] {
        let [k1, k2] = self.tangential;
        // With equal springs `under_stretch` alone determines the direction, and s is per_radius / k₁.
        if k1 == k2 {
            return self.under_stretch(start, per_radius / k1).0;
        }
        let (mut low, mut high) = (per_radius / k1.max(k2), per_radius / k1.min(k2));
        let mut s = per_radius / self.stiffness(start);
        // If a Newton step for s leaves the interval from `low` to `high`, the interval is halved instead. Sixty halvings reduce it to rounding.
        for _ in 0..60 {
            let (p, integral) = self.split_step(start, s);
            let off = integral - per_radius;
            *(if off > 0.0 { &mut high } else { &mut low }) = s;
            let newton = s - off / self.stiffness(p);
            let next = if low <= newton && newton <= high { newton } else { 0.5 * (low + high) };
            // The iteration ends when s changes by at most the fraction 1e-15, the level of rounding. If the limit were coarser, the force would be a
            // discontinuous function of the stretch, which Newton's method for the motion of the object cannot use.
            let last = (next - s).abs() <= 1e-15 * s;
            s = next;
            if last {
                break;
            }
        }
        self.split_step(start, s).0
    }

    /// Stiffness along the direction p, `p·K p`, N/m.
    fn stiffness(&self, p: [f64; 2]) -> f64 {
        self.tangential[0] * p[0] * p[0] + self.tangential[1] * p[1] * p[1]
    }

    /// The unit direction p of the friction force after the path parameter has grown by s, computed by one Strang step. Also returns the integral
    /// `∫ p·K p ds` over this increment.
    fn split_step(&self, start: [f64; 2], s: f64) -> ([f64; 2], f64) {
        let (p, first) = self.under_stretch(start, 0.5 * s);
        let (p, second) = self.under_stretch(self.squeezed(p, s), 0.5 * s);
        (p, first + second)
    }

    /// The unit direction of the friction force after the path parameter has grown by s from the direction p. The tangential stretch changes and the
    /// normal force is constant. Also returns the integral `∫ p·K p ds` over this increment.
    fn under_stretch(&self, p: [f64; 2], s: f64) -> ([f64; 2], f64) {
        let [k1, k2] = self.tangential;
        let size = (self.stretched[0] * self.stretched[0] + self.stretched[1] * self.stretched[1]).sqrt();
        let rate = k1 * k2 * size;
        let e = self.stretched.each(|v| v / size);
        // Here ψ is the angle from the stretch rate to the friction force.
        let (cos0, sin0) = (e[0] * p[0] + e[1] * p[1], e[0] * p[1] - e[1] * p[0]);
        let half = sin0 / (1.0 + cos0) * (-rate * s).exp();
        let square = half * half;
        if rate == 0.0 || !square.is_finite() {
            return (p, self.stiffness(p) * s);
        }
        let (cos, sin) = ((1.0 - square) / (1.0 + square), 2.0 * half / (1.0 + square));
        let (mean, uneven) = (0.5 * (k1 + k2), 0.5 * (k1 - k2));
        let twice = [e[0] * e[0] - e[1] * e[1], 2.0 * e[0] * e[1]];
        let turned = twice[0] * (cos - cos0) + twice[1] * (sin0 - sin);
        let integral = (mean + uneven * twice[0]) * s - 2.0 * uneven / rate * turned;
        ([cos * e[0] - sin * e[1], sin * e[0] + cos * e[1]], integral)
    }

    /// The unit direction of the friction force after the path parameter has grown by s from the direction p. The tangential stretch is constant and
    /// the normal force changes.
    fn squeezed(&self, p: [f64; 2], s: f64) -> [f64; 2] {
        // The exponent is clamped to this magnitude, up to which squares do not overflow. A larger exponent leaves no digit of the previous direction
        // anyway.
        let far = 300.0;
        let y = (0.5 * self.growth * (self.tangential[1] - self.tangential[0]) * s).clamp(-far, far);
        let q = [p[0] * (-y).exp(), p[1] * y.exp()];
        let size = q[0].hypot(q[1]);
        q.each(|x| x / size)
    }
}

#[cfg(test)]
mod tests {
    use super::RelaxingSlide;

    /// Reference value of the friction direction at τ = 1, if it is `start` at τ = 0. A million steps of the midpoint rule integrate the first
    /// equation of the file header. The radius r of the cone is 1 at τ = 0.
    fn in_tiny_steps(slide: &RelaxingSlide, start: [f64; 2]) -> [f64; 2] {
        let [k1, k2] = slide.tangential;
        let (drawn, steps) = ([k1 * slide.stretched[0], k2 * slide.stretched[1]], 1_000_000);
        let rate = |tau: f64, phi: f64| {
            let (sin, cos) = phi.sin_cos();
            let slips = (cos * drawn[0] + sin * drawn[1] - slide.growth) / slide.stiffness([cos, sin]);
            (cos * drawn[1] - sin * drawn[0] - slips * (k2 - k1) * sin * cos) / (1.0 + slide.growth * tau)
        };
        let (mut phi, h) = (start[1].atan2(start[0]), 1.0 / f64::from(steps));
        for i in 0..steps {
            let tau = f64::from(i) * h;
            let middle = phi + 0.5 * h * rate(tau, phi);
            phi += h * rate(tau + 0.5 * h, middle);
        }
        [phi.cos(), phi.sin()]
    }

    /// The direction of friction if the stretch is divided into `steps` steps, each solved by the closed forms.
    fn in_steps(slide: &RelaxingSlide, mut p: [f64; 2], steps: u32) -> [f64; 2] {
        let h = 1.0 / f64::from(steps);
        for i in 0..steps {
            let [r0, r1] = [i, i + 1].map(|i| 1.0 + slide.growth * f64::from(i) * h);
            let per_radius = if slide.growth == 0.0 { h } else { (r1 / r0).ln() / slide.growth };
            p = slide.direction_after(p, per_radius);
        }
        p
    }

    fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
        (a[0] - b[0]).hypot(a[1] - b[1])
    }

    #[test]
    fn at_a_normal_force_that_stays_it_is_exact() {
        for (k, stretched, angle) in [
            ([1.0, 3.0], [0.4, 0.9], -0.7_f64),
            ([2.0, 0.5], [-1.0, 0.3], 2.0),
            ([1.0, 1.2], [8.0, -5.0], 0.5),
        ] {
            let slide = RelaxingSlide { tangential: k, stretched, growth: 0.0 };
            let start = [angle.cos(), angle.sin()];
            let exact = in_tiny_steps(&slide, start);
            for steps in [1, 7] {
                let off = distance(in_steps(&slide, start, steps), exact);
                assert!(off < 3e-11, "{k:?}: {off:e} in {steps} steps");
            }
        }
    }

    #[test]
    fn elsewhere_errors_fall_fourfold_with_half_the_step() {
        for growth in [-0.6, 0.8] {
            let slide = RelaxingSlide { tangential: [1.0, 3.0], stretched: [0.4, 0.9], growth };
            let start = [0.9_f64.cos(), -0.9_f64.sin()];
            let exact = in_tiny_steps(&slide, start);
            let off = [4, 8, 16].map(|steps| distance(in_steps(&slide, start, steps), exact));
            println!("{off:?}");
            assert!(
                off[0] < 1e-2 && off.windows(2).all(|off| (3.5..4.5).contains(&(off[0] / off[1]))),
                "{off:?}"
            );
        }
    }

    #[test]
    fn a_long_way_leads_along_the_stretch() {
        let slide = RelaxingSlide { tangential: [1.0, 3.0], stretched: [4e5, 9e5], growth: 0.0 };
        let p = slide.direction_after([-0.6, 0.8], 1.0);
        assert!(distance(p, [4.0 / 97.0_f64.sqrt(), 9.0 / 97.0_f64.sqrt()]) < 1e-15);
    }
}
