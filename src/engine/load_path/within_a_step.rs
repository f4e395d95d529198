//! Detects contacts that violate the condition of their state within a step, although the condition holds again at the end of the step. The condition
//! is a force inside the friction cone for a sticking contact, or a gap that is not negative for an open contact.
//!
//! Forces of sticking contacts, and gaps, are linear in the twist and in the fraction of the leg that is done. At the fraction s of a step they
//! follow the cubic polynomial through the values and rates at both ends. The error is at most `s²(1 - s)² g`, with a number g (N or m) that is
//! estimated. A margin `μ F_n - |F_t|` is concave in the force. Hence on a piece of the cubic it is at least its minimum over the four Bézier points
//! P_i of the piece. As pieces are halved, these points converge to the curve.
//!
//! ```text
//! F(s) = Σ_i B_i(s) P_i,   B_i >= 0,  Σ B_i = 1:      margin(F(s)) >= min_i margin(P_i)
//! ```

use nalgebra::SVector;

use super::segment::{PathPoint, Segment};
use crate::contact::{Coulomb, Mode, State};
use crate::numerics::{Each, least};

/// The four Bézier points of a piece of a cubic polynomial.
type BezierPoints = [SVector<f64, 3>; 4];

/// A contact force or a gap as a cubic polynomial along a step, with a margin that must stay positive. The margin is the gap itself, the normal
/// force, or `μ F_n - |F_t|`.
pub(super) struct BoundedCubic {
    points: BezierPoints,
    /// The friction cone, if the margin is the distance `μ F_n - |F_t|` of a force from its boundary. `None` if the margin is the first component, a
    /// normal force or a gap.
    cone: Option<Coulomb>,
    /// The factor g, N or m, in a bound on the interpolation error. At the fraction s of the step, the margin from the cubic and the true margin
    /// differ by at most `s²(1 - s)² g`.
    error_factor: f64,
    /// The condition counts as satisfied if its margin, the value that must not be negative, is at least minus this number, in N or m.
    allowed_violation: f64,
}

/// The least fraction of a step at which a sticking or open contact violates the condition of its state by more than the allowed error; the condition
/// may hold again at the end. If the step is too long to decide this for a contact, one half is taken as its fraction. `None` if all conditions hold
/// within the step. Rates at both ends are per unit of arclength, and `length` is the arclength of the step.
pub(super) fn first_dip(
    segment: &Segment<'_>,
    states: &[State],
    [from, to]: [&PathPoint; 2],
    (length, step_error): (f64, f64),
) -> Option<f64> {
    let mut first: Option<f64> = None;
    for (i, state) in states.iter().enumerate() {
        let local = segment.problem.local(i);
        let (values, rates, size, cone) = match state {
            Mode::Open if !local.is_absent() => {
                let [a, b] = [&from.gaps[i], &to.gaps[i]];
                ([a.gap, b.gap].each(along), [a.rate, b.rate].each(along), a.size.max(b.size), None)
            }
            Mode::Sticking if local.may_slide() || local.may_open() => {
                let [a, b] = [&from.lines[i], &to.lines[i]];
                let cone = local.may_slide().then(|| local.cone());
                ([a.force, b.force], [a.rate, b.rate], a.force_size.max(b.force_size), cone)
            }
            _ => continue,
        };
        let bounded = BoundedCubic::new((values, rates.each(|rate| rate * length)), cone, (size, step_error));
        if let Some(part) = bounded.violated_at() {
            first = Some(first.map_or(part, |first| first.min(part)));
        }
    }
    first
}

fn along(value: f64) -> SVector<f64, 3> {
    let mut vector = SVector::zeros();
    vector[0] = value;
    vector
}

impl BoundedCubic {
    /// The cubic with the values a, b and the changes per step da, db at both ends of a step. `size` is the magnitude of the terms whose difference
    /// the margin is, N or m, and `step_error` the allowed relative error of a step.
    pub(super) fn new(
        ([a, b], [da, db]): ([SVector<f64, 3>; 2], [SVector<f64, 3>; 2]),
        cone: Option<Coulomb>,
        (size, step_error): (f64, f64),
    ) -> Self {
        let weight = cone.map_or(1.0, Coulomb::round_weight);
        // The condition counts as violated if its margin is negative by more than this fraction of the allowed error of a step.
        let within_the_error = 0.02;
        // The rounding error of a margin, relative to the terms whose difference the margin is. A smaller violation is ignored.
        let rounded = 2e-13;
        let allowed_violation = (within_the_error * step_error).max(rounded) * size * weight;
        let third = (a - b) * 2.0 + da + db;
        let second = b - a - da - third;
        // The cubic neglects the terms of fourth order and higher in the true motion. In accepted steps each term is expected to be at most 0.05
        // times the term of the order before. The term of third order is therefore taken as a bound on the neglected terms, with room to spare. As it
        // may vanish by chance, 0.05 times the term of second order is taken if that is larger.
        let error_factor = third.norm().max(0.05 * second.norm()) * weight;
        Self { points: [a, a + da / 3.0, b - db / 3.0, b], cone, error_factor, allowed_violation }
    }

    fn margin(&self, point: &SVector<f64, 3>) -> f64 {
        self.cone.map_or(point[0], |cone| cone.round_margin(point))
    }

    /// A fraction of the step at which the margin is certainly negative by more than `allowed_violation`. `None` if the margin is nowhere so
    /// negative. One half if neither can be decided, because the step is too long.
    pub(super) fn violated_at(&self) -> Option<f64> {
        let mut pieces = vec![(0.0_f64, 1.0_f64, self.points)];
        // At most two hundred pieces of the cubic are examined; if that decides nothing, the step is taken as too long.
        for _ in 0..200 {
            let (from, to, points) = pieces.pop()?;
            let least = least(&points, &|point| self.margin(point));
            let farthest = if to <= 0.5 { to } else { from.max(0.5) };
            if least - self.margin_error(farthest) >= -self.allowed_violation {
                continue;
            }
            let middle = 0.5 * (from + to);
            let [before, after] = halves(&points);
            if self.margin(&after[0]) + self.margin_error(middle) < -self.allowed_violation {
                return Some(middle);
            }
            pieces.push((middle, to, after));
            pieces.push((from, middle, before));
        }
        // The step is too long to decide whether the condition holds, and the caller repeats it with half its length.
        Some(0.5)
    }

    /// Bound, N or m, on the interpolation error at the fraction `part` of the step: the difference between the margin from the cubic and the
    /// true margin.
    fn margin_error(&self, part: f64) -> f64 {
        let square = part * (1.0 - part);
        self.error_factor * square * square
    }
}

/// The Bézier points of both halves of a piece of the cubic, by De Casteljau's algorithm.
fn halves(points: &BezierPoints) -> [BezierPoints; 2] {
    let mean = |a: &SVector<f64, 3>, b: &SVector<f64, 3>| (a + b) * 0.5;
    let [p, q, r, s] = points;
    let [pq, qr, rs] = [mean(p, q), mean(q, r), mean(r, s)];
    let [pqr, qrs] = [mean(&pq, &qr), mean(&qr, &rs)];
    let middle = mean(&pqr, &qrs);
    [[*p, pq, pqr, middle], [middle, qrs, rs, *s]]
}
