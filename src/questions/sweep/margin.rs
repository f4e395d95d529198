//! The margin of one facet of a friction cone under one load, and the smallest errors of the data with which this margin vanishes. A positive margin
//! means that the contact force is on the inner side of the facet.
//!
//! ```text
//! m(z) = μ exp(σ z_f) F_n(z) - h·F_t(z),      F(z) = F + Σ_i Δ_i(z_i)
//! ```
//!
//! Here μ is the coefficient of friction, σ the standard deviation of its logarithm, and h the unit normal of the facet in the tangent plane. The
//! vector z has the errors of the data, in standard deviations; its last entry z_f is the error of friction. The change Δ_i of the contact force due
//! to the error of datum i is a polynomial through exact forces at four errors. The [interaction](super::interaction) of several data is the change
//! of the force due to all errors together, less the sum of the Δ_i. It is computed at the point of failure and added as a constant force.
//!
//! The point of failure is the shortest z at which the margin vanishes. Its length is the reliability β (Hasofer and Lind, Exact and invariant
//! second-moment code format, 1974). Steps towards it are shortened until a merit function of distance and margin falls (Zhang and Der Kiureghian,
//! Two improved algorithms for reliability analysis, 1995). No step goes beyond the distance at which the failure probability is negligible.

use nalgebra::{SMatrix, SVector};

use crate::contact::involves_friction;
use crate::numerics::tolerances::SUFFICIENT_DECREASE;
use crate::numerics::{Each, IntoList, by_axis, dot, normal_density, normal_tail};
use crate::prelude::*;

/// Errors of a datum at which exact forces are computed, as multiples of `sigmas`. The number `sigmas` is the required reliability: the number of
/// standard deviations between the given data and failure.
pub(super) const LOOKED_AT: [f64; 4] = [-1.0, -0.5, 0.5, 1.0];

/// The change of a contact force due to the error of one datum, N: coefficients c_k of the polynomial `Σ c_k x^k`, k from 1. Here x is the error in
/// standard deviations, divided by `sigmas`.
pub(super) type Effect = [SVector<f64, 3>; LOOKED_AT.len()];

/// The polynomial in the error of one datum through the four changes of a contact force at the errors [`LOOKED_AT`] times `sigmas`, in this order.
pub(super) fn effect([low, half_low, half_high, high]: [SVector<f64, 3>; 4]) -> Effect {
    let (even, half_even) = (0.5 * (high + low), 0.5 * (half_high + half_low));
    let (odd, half_odd) = (0.5 * (high - low), 0.5 * (half_high - half_low));
    let fourth = (even - 4.0 * half_even) * (4.0 / 3.0);
    let third = (odd - 2.0 * half_odd) * (4.0 / 3.0);
    [odd - third, even - fourth, third, fourth]
}

/// The interaction of the errors of all data in their effect on a contact force, at a facet's point of failure z.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Interaction {
    /// The exact change of the contact force at the errors z, less the sum of the changes due to each datum alone, N.
    pub(super) force: SVector<f64, 3>,
    /// Second derivative of the interaction along the direction of the errors z, N: twice `force` divided by |z|², or by 1 if |z|² is smaller.
    pub(super) bend: SVector<f64, 3>,
    /// For each two components of the force, the product of their mixed second derivatives with respect to a pair of data, summed over all pairs. The
    /// sum is estimated from random errors.
    pub(super) squares: SMatrix<f64, 3, 3>,
}

/// The force on a contact under one load, N: for the data as given, and its change due to each uncertain datum.
pub(super) struct UncertainForce<'a> {
    pub(super) force: SVector<f64, 3>,
    pub(super) changes: &'a [Effect],
    /// The interaction of the errors of all data: one entry for each facet of a polygonal cone, a single entry for a round cone. An empty list means
    /// that interactions are neglected.
    pub(super) joint: &'a [Interaction],
    /// The required reliability: the number of standard deviations between the given data and failure.
    pub(super) sigmas: f64,
    /// Standard deviation σ of the logarithm of the coefficient of friction.
    pub(super) friction: f64,
}

/// The search for the point of failure of one facet, and its result. It is a scratch buffer for one facet after the other.
#[derive(Debug)]
pub(super) struct FacetMargin {
    /// The present point z of the search, at its end the point of failure. Its entries are errors in standard deviations, first of the data in the
    /// order of `changes`, then of friction.
    pub(super) fails_at: Vec<f64>,
    /// The point z before the last step of the search.
    from: Vec<f64>,
    /// For each datum, the polynomial that gives the change of the margin as a function of the error of this datum. Each coefficient has two parts:
    /// the change due to the normal force, which the factor `exp(σ z_f)` on friction multiplies, and the change due to the tangential force.
    pub(super) parts: Vec<[[f64; 2]; LOOKED_AT.len()]>,
    /// The point z at which `gradient`, and `steepness` (the norm of the gradient), were computed.
    pub(super) linearised_at: Vec<f64>,
    pub(super) gradient: Vec<f64>,
    pub(super) steepness: f64,
    reliability: f64,
    /// The failure probability divided by its first-order estimate `Φ(-β)`, with the normal distribution function Φ. It is the correction by
    /// [`second_order`](super::second_order), or 1 if this correction is not computed.
    curved: f64,
}

impl UncertainForce<'_> {
    /// The force for the data as given, and its covariance to first order about these data. Both are the same for all facets.
    pub(super) fn first_order(&self) -> FirstOrder {
        let mut spread = SMatrix::zeros();
        for [slope, ..] in self.changes {
            let by_sigma = slope / self.sigmas;
            spread += by_sigma * by_sigma.transpose();
        }
        FirstOrder { force: self.force, spread, friction: self.friction }
    }

    /// The force for the data as given, plus the force due to the interaction of errors at the facet with the index `row`, from 0; N.
    fn known(&self, row: usize) -> SVector<f64, 3> {
        self.joint.get(row).map_or(self.force, |joint| self.force + joint.force)
    }

    /// The force if the data have the errors z (in standard deviations), without the interaction of errors.
    pub(super) fn at(&self, z: &[f64]) -> SVector<f64, 3> {
        let mut force = self.force;
        for (change, z) in self.changes.iter().zip(z) {
            let along =
                |axis: usize| ContinuedEffect::of(change.each_ref().each(|c| c[axis]), z / self.sigmas).value;
            force += by_axis(along);
        }
        force
    }

    /// Finds the smallest errors z of the data at which the margin of the facet with the index `row` vanishes. These errors and the reliability are
    /// stored in `margin`. If the margin vanishes nowhere within the distance beyond which failures are negligible, the reliability is about this
    /// distance.
    pub(super) fn find(&self, row: usize, facet: &SVector<f64, 3>, margin: &mut FacetMargin) {
        if margin.fails_at.len() != self.changes.len() + 1 {
            margin.start_over(self.changes.len());
        }
        margin.parts.clear();
        self.changes
            .iter()
            .map(|change| change.each_ref().each(|c| parts(facet, c)))
            .append_to(&mut margin.parts);
        let known = parts(facet, &self.known(row));
        margin.curved = 1.0;
        // If the reliability exceeds the required reliability `sigmas` by five standard deviations, failures are so rare that they are negligible.
        let farthest = self.sigmas + 5.0;
        let mut value = self.linearise(known, involves_friction(facet), margin);
        let mut arrived = false;
        for _ in 0..30 {
            if margin.steepness == 0.0 {
                margin.reliability = ratio(known[0] + known[1], 0.0);
                return;
            }
            // A step to the nearest zero of the linearised margin, shortened so that z is no longer than `farthest`.
            let along = dot(&margin.gradient, &margin.fails_at);
            let step = (along - value) / (margin.steepness * margin.steepness);
            let reach = (step * margin.steepness).abs();
            let step = if reach > farthest { step * (farthest / reach) } else { step };
            let mut moved = 0.0;
            margin.from.clone_from(&margin.fails_at);
            for (z, g) in margin.fails_at.iter_mut().zip(&margin.gradient) {
                moved = f64::max(moved, (step * g - *z).abs());
                *z = step * g;
            }
            // The search has converged once a step changes no datum by a thousandth of its standard deviation.
            arrived = moved < 1e-3;
            if arrived {
                break;
            }
            value = self.shortened(known, involves_friction(facet), margin, (value, along));
        }
        let mut nearest = dot(&margin.fails_at, &margin.fails_at).sqrt();
        if !arrived {
            // The search has not converged. The smaller of the present distance and the first-order reliability is taken, which errs on the safe
            // side.
            margin.start_over(self.changes.len());
            let value = self.linearise(known, involves_friction(facet), margin);
            nearest = nearest.min(ratio(value, margin.steepness).abs());
        }
        margin.reliability = nearest.copysign(known[0] + known[1]);
        if arrived && margin.reliability > 0.0 {
            margin.curved = margin.curved(involves_friction(facet), self.sigmas, self.friction, &|factor| {
                let row_there = SVector::from([factor * facet[0], facet[1], facet[2]]);
                let of = |joint: &Interaction| {
                    [row_there.dot(&joint.bend), row_there.dot(&(joint.squares * row_there))]
                };
                self.joint.get(row).map_or([0.0; 2], of)
            });
        }
    }

    /// Halves the last step of the search for the point of failure until the merit function `½|z|² + c |m|` decreases enough. Here z are the errors
    /// of the data, m is the margin, and c a weight. Returns the margin at the new point, and stores its gradient.
    fn shortened(
        &self,
        known: [f64; 2],
        involves_friction: bool,
        margin: &mut FacetMargin,
        (value, along): (f64, f64),
    ) -> f64 {
        let [from, to] = [&margin.from, &margin.fails_at].each(|z| dot(z, z));
        // The weight c is so large that the merit function falls along a step to the zero of the linearised margin.
        let dear = 2.0 * from.max(to).sqrt() / margin.steepness;
        let here = 0.5 * from + dear * value.abs();
        let [towards, rises] =
            [dot(&margin.from, &margin.fails_at) - from, dot(&margin.gradient, &margin.fails_at) - along];
        let promised = -towards - dear * rises * 1.0_f64.copysign(value);
        let mut part = 1.0;
        loop {
            let there = self.linearise(known, involves_friction, margin);
            let left = 0.5 * dot(&margin.fails_at, &margin.fails_at) + dear * there.abs();
            // A step that has been shortened to a hundredth is accepted even if the merit function does not fall.
            if left <= here - SUFFICIENT_DECREASE * part * promised || part <= 1e-2 {
                return there;
            }
            part *= 0.5;
            for (z, from) in margin.fails_at.iter_mut().zip(&margin.from) {
                *z = 0.5 * (*z + from);
            }
        }
    }

    /// Returns the margin of the facet at the present errors z of the data, N. Stores the gradient of this margin and the norm of the gradient.
    fn linearise(&self, known: [f64; 2], involves_friction: bool, margin: &mut FacetMargin) -> f64 {
        let FacetMargin { fails_at, parts, linearised_at, gradient, .. } = margin;
        let friction_ratio =
            if involves_friction { fails_at.last().map(|z| (self.friction * z).exp()) } else { None };
        let factor = friction_ratio.unwrap_or(1.0);
        linearised_at.clone_from(fails_at);
        gradient.clear();
        let [mut normal, mut other] = known;
        let mut steepness = 0.0;
        for (coefficients, z) in parts.iter().zip(fails_at.iter()) {
            let x = z / self.sigmas;
            let [of_normal, of_other] =
                [0, 1].each(|part| ContinuedEffect::of(coefficients.each(|c| c[part]), x));
            normal += of_normal.value;
            other += of_other.value;
            let by_sigma = (factor * of_normal.slope + of_other.slope) / self.sigmas;
            steepness += by_sigma * by_sigma;
            gradient.push(by_sigma);
        }
        let by_friction = if friction_ratio.is_some() { self.friction * factor * normal } else { 0.0 };
        gradient.push(by_friction);
        margin.steepness = (steepness + by_friction * by_friction).sqrt();
        factor * normal + other
    }

    /// The mean number, per radian, of changes of the margin from positive to negative as the angle θ of the facet's direction grows. It is a mean
    /// over the random errors of the data, multiplied by the field `curved`, the second-order correction of the failure probability. The head of
    /// [`super::failure`] has the formula without this correction. The margin is the product of a facet vector (μ along the normal, -h in the tangent
    /// plane) and the contact force; `turned` is the derivative of this vector with respect to θ.
    pub(super) fn crossings(&self, margin: &FacetMargin, turned: &SVector<f64, 3>) -> f64 {
        if margin.steepness == 0.0 {
            return 0.0;
        }
        let (mut mixed, mut rates, mut rate) = (0.0, 0.0, turned.dot(&self.known(0)));
        for ((change, z), g) in self.changes.iter().zip(&margin.linearised_at).zip(&margin.gradient) {
            let there = ContinuedEffect::of(change.each_ref().each(|c| turned.dot(c)), z / self.sigmas);
            let by_sigma = there.slope / self.sigmas;
            rate += there.value;
            mixed += g * by_sigma;
            rates += by_sigma * by_sigma;
        }
        let along = mixed / margin.steepness;
        let turning = (rates - along * along).max(0.0).sqrt() / margin.steepness;
        let rate = rate / margin.steepness;
        let mean = if turning == 0.0 {
            (-rate).max(0.0)
        } else {
            let x = rate / turning;
            turning * normal_density(x) - rate * normal_tail(x)
        };
        normal_density(margin.reliability) * margin.curved * mean
    }
}

/// A contact force, N, and its covariance, to first order about the data as given.
pub(super) struct FirstOrder {
    force: SVector<f64, 3>,
    /// Covariance of the force due to all uncertain data except friction, N².
    spread: SMatrix<f64, 3, 3>,
    friction: f64,
}

impl FirstOrder {
    /// The reliability β of a facet to first order: its margin over the standard deviation of that margin, friction included. Infinite if nothing is
    /// uncertain.
    pub(super) fn reliability(&self, facet: &SVector<f64, 3>) -> f64 {
        let by_friction =
            if involves_friction(facet) { self.friction * facet[0] * self.force[0] } else { 0.0 };
        let variance = facet.dot(&(self.spread * facet)) + by_friction * by_friction;
        ratio(facet.dot(&self.force), variance.max(0.0).sqrt())
    }
}

/// The margin `row·F` of a facet, N, in two parts: the term of the normal force, which the factor `exp(σ z_f)` on friction multiplies, and the terms
/// of the tangential force.
fn parts(row: &SVector<f64, 3>, force: &SVector<f64, 3>) -> [f64; 2] {
    let normal = row[0] * force[0];
    [normal, row.dot(force) - normal]
}

/// Value and first two derivatives of one component of an [`Effect`] at the error x (in units of `sigmas`). For |x| > 1, where no exact forces are
/// known, the polynomial is continued linearly.
pub(super) struct ContinuedEffect {
    value: f64,
    pub(super) slope: f64,
    pub(super) bend: f64,
}

impl ContinuedEffect {
    pub(super) fn of([c1, c2, c3, c4]: [f64; LOOKED_AT.len()], x: f64) -> Self {
        let inside = x.clamp(-1.0, 1.0);
        let slope = c1 + (c2 * 2.0 + (c3 * 3.0 + c4 * (4.0 * inside)) * inside) * inside;
        let value = (c1 + (c2 + (c3 + c4 * inside) * inside) * inside) * inside;
        let bend = if x == inside { c2 * 2.0 + (c3 * 6.0 + c4 * (12.0 * x)) * x } else { 0.0 };
        Self { value: value + slope * (x - inside), slope, bend }
    }
}

impl Default for FacetMargin {
    fn default() -> Self {
        let [fails_at, from, linearised_at, gradient] = [const { Vec::new() }; 4];
        let parts = Vec::new();
        Self { fails_at, from, parts, linearised_at, gradient, steepness: 0.0, reliability: 0.0, curved: 1.0 }
    }
}

impl FacetMargin {
    /// Lets the next search start from the data as given, z = 0; `data` is the number of uncertain data without friction.
    pub(super) fn start_over(&mut self, data: usize) {
        self.fails_at.clear();
        self.fails_at.resize(data + 1, 0.0);
    }

    /// The reliability β of the facet: its distance from failure in standard deviations, with the sign of its margin for the data as given. Infinite
    /// if no datum changes the margin.
    pub(super) fn reliability(&self) -> f64 {
        self.reliability
    }

    /// The failure probability of the facet, `Φ(-β)` corrected to second order, at most 1.
    pub(super) fn fails(&self) -> f64 {
        (normal_tail(self.reliability) * self.curved).min(1.0)
    }
}

/// A value divided by a standard deviation; infinite, with the sign of the value, if the deviation is zero.
fn ratio(value: f64, deviation: f64) -> f64 {
    if deviation == 0.0 { f64::INFINITY.copysign(value) } else { value / deviation }
}
