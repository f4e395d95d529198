//! The step along a straight line of contact forces at which a contact leaves its state: sticking, sliding or open. While a load grows and all
//! contacts keep their states, the contact forces follow such a line. The step is the parameter of the line.
//!
//! A polygonal friction cone has facets `h·F_t <= μ F_n` with outward normals h, tangential force F_t and normal force F_n. The apex of a cone is
//! zero force. The margin of a force is `μ F_n - h·F_t` at a facet, and `μ F_n - |F_t|` on the round cone: zero on the boundary, positive inside. In
//! code names an edge is the boundary. A rounding scale is the magnitude of the terms of a sum, to which its rounding error is proportional.

use crate::numerics::{Each, IntoList, keep};
use nalgebra::SVector;

use super::law::LocalLaw;
use super::state::{Mode, State};
use super::tangential::tangential;
use super::tolerances::ZERO_SLACK;
use crate::prelude::*;

/// An exit: the point at which a contact force on a straight line leaves the friction cone, or at which the gap closes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Exit {
    /// The parameter `step` of the line `force + step rate` at the exit.
    pub(crate) step: f64,
    /// Estimated rounding error of `step`, the parameter at the exit.
    pub(crate) uncertainty: f64,
    /// Outward normal h of the facet `h·F_t <= μ F_n` that is reached; zero if the normal force or the gap vanishes.
    pub(crate) facet: SVector<f64, 3>,
}

/// A straight line of contact forces, `force + step rate`, N, with the parameter `step`. The fields `force_size` and `rate_size` are the rounding
/// scales of `force` and `rate`, N.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Line {
    pub(crate) force: SVector<f64, 3>,
    pub(crate) rate: SVector<f64, 3>,
    pub(crate) force_size: f64,
    pub(crate) rate_size: f64,
}

impl Line {
    fn linear(&self, value: f64, rate: f64, weight: f64, facet: SVector<f64, 3>) -> Option<Exit> {
        if rate >= -ZERO_SLACK * self.rate_size * weight {
            return None;
        }
        let step = (value / -rate).max(0.0);
        let uncertainty = ZERO_SLACK * weight * (self.force_size + step * self.rate_size) / -rate;
        Some(Exit { step, uncertainty, facet })
    }
}

/// The gap of a contact, m, and its rate per unit of the parameter `step` of a line of forces, m. Both are differences of displacements, whose
/// magnitudes `size` and `rate_size`, m, are their rounding scales.
#[derive(Debug, Clone, Copy)]
pub(crate) struct GapLine {
    pub(crate) gap: f64,
    pub(crate) rate: f64,
    pub(crate) size: f64,
    pub(crate) rate_size: f64,
}

impl GapLine {
    /// The step at which the gap closes; `None` if the gap does not decrease.
    pub(crate) fn closing(&self) -> Option<Exit> {
        (self.rate < -ZERO_SLACK * self.rate_size).then(|| {
            let step = (self.gap / -self.rate).max(0.0);
            let uncertainty = ZERO_SLACK * (self.size + step * self.rate_size) / -self.rate;
            Exit { step, uncertainty, facet: SVector::zeros() }
        })
    }
}

impl LocalLaw<'_> {
    /// All exits of a contact from its state along a line of forces. A closed contact may reach a facet on which it does not slide; an open contact
    /// may close its gap.
    pub(crate) fn ways_out(&self, state: &State, line: &Line, gap: &GapLine) -> Vec<Exit> {
        match state {
            Mode::Open => gap.closing().into_iter().list(),
            Mode::Sticking => self.exits(line),
            // A sliding contact stays on the facets on which it slides, so these facets are no exits.
            Mode::Facet(_) | Mode::Corner(_) | Mode::Round(_) => {
                let facets = self.facets();
                let own = state.own_facets(facets.len());
                let mut exits = self.exits(line);
                keep(&mut exits, &|exit| own.iter().all(|own| own.is_none_or(|j| exit.facet != facets[j])));
                exits
            }
        }
    }

    /// The first exit of a sticking contact's force from its cone, and the step of the next exit. That step is infinite if there is no next exit.
    /// `None` if the force never leaves the cone.
    pub(crate) fn first_exit(&self, line: &Line) -> Option<(Exit, f64)> {
        let mut first: Option<Exit> = None;
        let mut next = f64::INFINITY;
        self.for_each_exit(line, |exit| match first {
            Some(nearest) if exit.step >= nearest.step => next = next.min(exit.step),
            _ => next = first.replace(exit).map_or(next, |nearest| next.min(nearest.step)),
        });
        first.map(|first| (first, next))
    }

    /// Whether a round friction cone limits the contact force.
    pub(super) fn has_a_round_edge(&self) -> bool {
        self.on_round_cone && self.cone().has_edges() && !self.is_bonded() && !self.is_absent()
    }

    /// All exits of the line of forces from the cone, in any order.
    fn exits(&self, line: &Line) -> Vec<Exit> {
        let mut exits = Vec::new();
        self.for_each_exit(line, |exit| exits.push(exit));
        exits
    }

    /// Calls `visit` with each exit of the line of forces from the cone.
    fn for_each_exit(&self, line: &Line, visit: impl FnMut(Exit)) {
        if self.has_a_round_edge() {
            self.round_exit(line).into_iter().for_each(visit);
        } else if !self.is_bonded() {
            self.for_each_polygon_exit(line, visit);
        }
    }

    /// Calls `visit` for every facet of the polygonal cone that the line reaches, with the exit at this facet. If the contact has no facets but may
    /// open, the only exit is the point at which the normal force vanishes.
    fn for_each_polygon_exit(&self, line: &Line, mut visit: impl FnMut(Exit)) {
        let (cone, facets) = (self.cone(), self.facets());
        if facets.is_empty() && self.may_open() {
            line.linear(line.force[0], line.rate[0], 1.0, SVector::zeros()).into_iter().for_each(&mut visit);
        }
        for h in facets {
            let [margin, rate] = [&line.force, &line.rate].each(|f| cone.facet_margin(f, h));
            line.linear(margin, rate, cone.facet_weight(h), *h).into_iter().for_each(&mut visit);
        }
    }

    /// The step along a straight line of forces at which the line reaches the facet, or the apex, of an exit.
    pub(crate) fn step_to_exit(&self, exit: &Exit, force: &SVector<f64, 3>, rate: &SVector<f64, 3>) -> f64 {
        let slack = |f: &SVector<f64, 3>| {
            if exit.facet.norm() == 0.0 { f[0] } else { self.cone().facet_margin(f, &exit.facet) }
        };
        slack(force) / -slack(rate)
    }

    /// The exit of the line from the round cone, `μ² F_n² = |F_t|²`. Its step s is the first root of the following quadratic. F_n and F_t are the
    /// components of the force at s = 0, and F_n' and F_t' are their rates per unit of s:
    ///
    /// ```text
    /// c₀ + 2 c₁ s + c₂ s² = 0,   c₀ = (μF_n - |F_t|)(μF_n + |F_t|),   c₁ = μ²F_n F_n' - F_t·F_t',   c₂ = μ²F_n'² - |F_t'|²
    /// ```
    ///
    /// The root is computed as `s = c₀ / (√(c₁² - c₀c₂) - c₁)`, which avoids cancellation. A line that starts on the boundary (c₀ = 0) and points
    /// inwards can only return at `s = -2c₁/c₂`. `None` if the line does not leave the cone.
    fn round_exit(&self, line: &Line) -> Option<Exit> {
        let cone = self.cone();
        let (t0, t1) = (tangential(&line.force), tangential(&line.rate));
        let (n0, n1) = (cone.limit(line.force[0]), cone.limit(line.rate[0]));
        let friction = t0.norm();
        let weight = cone.round_weight();
        let on_edge = n0 - friction <= ZERO_SLACK * line.force_size * weight;
        let leaves = |at: &SVector<f64, 3>| at / at.norm().max(f64::MIN_POSITIVE);
        if on_edge {
            // At the apex the friction force is zero and has no direction. The direction of its rate takes its place.
            let outward =
                if friction > ZERO_SLACK * line.force_size * weight { leaves(&t0) } else { leaves(&t1) };
            if let Some(exit) = line.linear(n0 - friction, n1 - outward.dot(&t1), weight, outward) {
                return Some(exit);
            }
        }
        let c0 = if on_edge { 0.0 } else { (n0 - friction) * (n0 + friction) };
        let c1 = n0 * n1 - t0.dot(&t1);
        let c2 = n1 * n1 - t1.norm_squared();
        let discriminant = c1 * c1 - c0 * c2;
        // If the line never leaves the cone, the quadratic has no root and the step is NaN.
        let mut step = if on_edge { -2.0 * c1 / c2 } else { c0 / (discriminant.sqrt() - c1) };
        // Near a double root the discriminant loses digits by cancellation. The margin μF_n - |F_t| itself is concave and does not cancel, so Newton
        // steps on the margin restore the digits.
        let mut moved = 0.0;
        // Three Newton steps on the margin follow; each doubles the number of correct digits of the root.
        for _ in 0..3 {
            let at = t0 + t1 * step;
            let slope = n1 - leaves(&at).dot(&t1);
            let better = step - (n0 + n1 * step - at.norm()) / slope;
            if slope < 0.0 && better > 0.0 && better.is_finite() {
                moved = (better - step).abs();
                step = better;
            }
        }
        // A line through the apex continues beyond the apex in the opposite nappe of the cone, where F_n < 0. For such a line the quadratic has a
        // double root at the apex, which costs half the digits. The exit is instead computed as the root of F_n, which is linear in the step.
        if let Some(apex) = line.linear(line.force[0], line.rate[0], 1.0, SVector::zeros()) {
            let missed = (t0 + t1 * apex.step).norm();
            let through = missed <= ZERO_SLACK * (line.force_size + apex.step * line.rate_size);
            if through {
                return Some(apex);
            }
            // Newton's method has not converged if its last step moves the root by more than 1e-8 of the root's distance from the apex.
            if step.is_nan() || step <= 0.0 || step > apex.step || moved > 1e-8 * (apex.step - step) {
                // If the line passes close to the apex, rounding of the discriminant hides the difference between the two roots of the quadratic. The
                // margin is negative at the step where F_n vanishes, so Newton's method starts there and goes back to the root before it.
                let root = newton_from_above(apex.step, |step| {
                    let at = t0 + t1 * step;
                    (n0 + n1 * step - at.norm(), n1 - leaves(&at).dot(&t1))
                });
                let Some(root) = root else { return Some(apex) };
                step = root;
            }
        }
        if !(step > 0.0 && step.is_finite()) {
            return None;
        }
        let facet = leaves(&(t0 + t1 * step));
        let closing = facet.dot(&t1) - n1;
        if closing <= ZERO_SLACK * line.rate_size * weight {
            // The margin does not decrease at this step: the line only touches the cone from inside, or the force does not change.
            return None;
        }
        let uncertainty = ZERO_SLACK * weight * (line.force_size + step * line.rate_size) / closing;
        Some(Exit { step, uncertainty, facet })
    }
}

/// Newton's method for a root of a concave function. It starts at `at`, where the function is negative, and goes towards smaller arguments. `value`
/// returns the function and its derivative. `None` if not even the first step leads to a smaller argument.
fn newton_from_above(mut at: f64, value: impl Fn(f64) -> (f64, f64)) -> Option<f64> {
    let start = at;
    // At most sixty Newton steps are made. Near the apex the margin μF_n - |F_t| is curved over distances of the order of rounding; farther away each
    // step doubles the correct digits.
    for _ in 0..60 {
        let (height, slope) = value(at);
        let better = at - height / slope;
        if !(slope < 0.0 && better > 0.0 && better < at) {
            break;
        }
        at = better;
    }
    (at < start).then_some(at)
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::Line;
    use crate::contact::{Compliance, Coulomb, Law, LocalLaw, Polygon, PolygonCone, PolygonFit};

    /// The forces on the line are F_n = 1 - s and F_t = (a (1 - s), ε), with the step s and a < μ. At s = 1 the line misses the apex of the cone by
    /// ε. It leaves the cone earlier, where |F_t| = μ F_n: at the step with `√(μ² - a²) (1 - s) = ε`.
    #[test]
    fn a_line_beside_the_apex_leaves_before_it() {
        let springs = Compliance::new(&Vector3::new(1.0, 1.0, 1.0), 3);
        let polygon = Polygon::shared(
            crate::numerics::Space::Spatial,
            &PolygonCone::new(8, PolygonFit::Circumscribed).expect("a cone"),
        );
        for (mu, a) in [(0.5, 0.0), (0.5, 0.3), (0.7, 0.69)] {
            let local =
                LocalLaw::new(&springs, Coulomb::new(mu), &Law::Cone { gap: true }, &polygon, [true, false]);
            // Tolerance of the step: the rounding error of a friction margin of about 1 N, divided by the rate of the margin at the exit.
            let rounding = 1e-15 * mu * mu / (mu * mu - a * a);
            for missed in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
                let (force, rate) = (Vector3::new(1.0, a, missed), Vector3::new(-1.0, -a, 0.0));
                let line = Line { force, rate, force_size: 1.0, rate_size: 1.0 };
                let (exit, _) = local.first_exit(&line).expect("leaves");
                let left = missed / f64::sqrt(mu * mu - a * a);
                assert!((1.0 - exit.step - left).abs() <= rounding, "{mu} {a} {missed}: {}", exit.step);
                // The line leaves the cone next to the apex, where some friction remains. The facet of the exit is then the unit vector of the
                // friction force. If the exit were at the apex, the facet would be zero.
                assert!(exit.facet.norm() > 0.9, "{mu} {a} {missed}: {}", exit.facet);
            }
        }
    }
}
