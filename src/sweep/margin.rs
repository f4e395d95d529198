//! The margin of one facet under one load, and how far from data as known it fails.
//!
//! ```text
//! m(z) = μ exp(σ z_f) F_n(z) - h·F_t(z),      F(z) = F + Σ_i Δ_i(z_i)
//! ```
//!
//! Data are off by z, in standard deviations. What each changes of the force is a polynomial through values that were looked at; what two change together beyond that is left out, but for
//! friction, which multiplies the normal force as it does. The reliability β is the distance of the nearest z at which the margin vanishes (Hasofer and
//! Lind, Exact and invariant second-moment code format, 1974).

use nalgebra::SVector;

use crate::numerics::{normal_density, normal_tail};

/// At these parts of the standard deviations in reserve it is looked at what a datum does.
pub(super) const LOOKED_AT: [f64; 4] = [-1.0, -0.5, 0.5, 1.0];

/// What a datum changes of a force: coefficients of `Σ c_k x^k`, k from 1, x being that part of the standard deviations in reserve.
pub(super) type Effect<const C: usize> = [SVector<f64, C>; LOOKED_AT.len()];

/// The polynomial through what is seen where it is looked at.
pub(super) fn effect<const C: usize>([low, half_low, half_high, high]: [SVector<f64, C>; 4]) -> Effect<C> {
    let (even, half_even) = (0.5 * (high + low), 0.5 * (half_high + half_low));
    let (odd, half_odd) = (0.5 * (high - low), 0.5 * (half_high - half_low));
    let fourth = (even - 4.0 * half_even) * (4.0 / 3.0);
    let third = (odd - 2.0 * half_odd) * (4.0 / 3.0);
    [odd - third, even - fourth, third, fourth]
}

/// The force of a contact under one load: as known, and what each datum changes.
pub(super) struct UncertainForce<'a, const C: usize> {
    pub(super) force: SVector<f64, C>,
    pub(super) changes: &'a [Effect<C>],
    /// The standard deviations in reserve.
    pub(super) sigmas: f64,
    /// σ of friction.
    pub(super) friction: f64,
}

/// A row that a margin is made of, `row·F`, and whether friction multiplies its first component.
#[derive(Clone, Copy)]
pub(super) struct MarginRow<const C: usize> {
    pub(super) row: SVector<f64, C>,
    pub(super) rubs: bool,
}

/// One margin; a place for one after another, each of which is looked for from where the one before failed.
#[derive(Debug)]
pub(super) struct FacetMargin<const C: usize> {
    /// Where it fails: data in the order of the changes, friction last.
    fails_at: Vec<f64>,
    gradient: Vec<f64>,
    /// What one σ of each datum changes of the force there.
    by_datum: Vec<SVector<f64, C>>,
    steepness: f64,
    /// The force there.
    force: SVector<f64, C>,
    reliability: f64,
}

/// Steps towards where a margin fails.
const STEPS: usize = 30;
/// Of a standard deviation.
const NEAR: f64 = 1e-3;

impl<const C: usize> UncertainForce<'_, C> {
    /// β to first order about the data as known, in a place for the gradient: where to look.
    pub(super) fn roughly(&self, facet: &MarginRow<C>, margin: &mut FacetMargin<C>) -> f64 {
        margin.fails_at.clear();
        margin.fails_at.resize(self.changes.len() + 1, 0.0);
        self.linearise(facet, margin);
        ratio(facet.row.dot(&self.force), margin.steepness)
    }

    /// Looks for where the margin fails.
    pub(super) fn find(&self, facet: &MarginRow<C>, margin: &mut FacetMargin<C>) {
        if margin.fails_at.len() != self.changes.len() + 1 {
            margin.fails_at.clear();
            margin.fails_at.resize(self.changes.len() + 1, 0.0);
        }
        let known = facet.row.dot(&self.force);
        let mut arrived = false;
        for _ in 0..STEPS {
            let value = self.linearise(facet, margin);
            if margin.steepness == 0.0 {
                margin.reliability = ratio(known, 0.0);
                return;
            }
            let along: f64 = margin.gradient.iter().zip(&margin.fails_at).map(|(g, z)| g * z).sum();
            let step = (along - value) / (margin.steepness * margin.steepness);
            let mut moved = 0.0;
            for (z, g) in margin.fails_at.iter_mut().zip(&margin.gradient) {
                moved = f64::max(moved, (step * g - *z).abs());
                *z = step * g;
            }
            arrived = moved < NEAR;
            if arrived {
                break;
            }
        }
        let distance = margin.fails_at.iter().map(|z| z * z).sum::<f64>().sqrt();
        // A search that goes round in circles says less than the derivative: the nearer of both is safe.
        let nearest = if arrived { distance } else { distance.min(self.roughly(facet, margin).abs()) };
        margin.reliability = nearest.copysign(known);
    }

    /// The margin where the data are off as said, and its gradient there.
    fn linearise(&self, facet: &MarginRow<C>, margin: &mut FacetMargin<C>) -> f64 {
        let FacetMargin { fails_at, gradient, by_datum, .. } = margin;
        let mut force = self.force;
        by_datum.clear();
        for (change, z) in self.changes.iter().zip(fails_at.iter()) {
            // Beyond what was looked at it goes on straight.
            let x = z / self.sigmas;
            let inside = x.clamp(-1.0, 1.0);
            let [c1, c2, c3, c4] = change;
            let slope = c1 + (c2 * 2.0 + (c3 * 3.0 + c4 * (4.0 * inside)) * inside) * inside;
            force += (c1 + (c2 + (c3 + c4 * inside) * inside) * inside) * inside + slope * (x - inside);
            by_datum.push(slope / self.sigmas);
        }
        let off = fails_at.last().map_or(0.0, |z| self.friction * z);
        let rubs = if facet.rubs { off.exp() } else { 1.0 };
        let mut row = facet.row;
        row[0] *= rubs;
        gradient.clear();
        gradient.extend(by_datum.iter().map(|d| row.dot(d)));
        gradient.push(if facet.rubs { self.friction * row[0] * force[0] } else { 0.0 });
        margin.steepness = margin.gradient.iter().map(|g| g * g).sum::<f64>().sqrt();
        margin.force = force;
        row.dot(&force)
    }
}

impl<const C: usize> Default for FacetMargin<C> {
    fn default() -> Self {
        let (fails_at, gradient, by_datum) = (Vec::new(), Vec::new(), Vec::new());
        Self { fails_at, gradient, by_datum, steepness: 0.0, force: SVector::zeros(), reliability: 0.0 }
    }
}

impl<const C: usize> FacetMargin<C> {
    /// β, infinite where nothing spreads, of the sign of the margin as known.
    pub(super) fn reliability(&self) -> f64 {
        self.reliability
    }

    /// `φ(β) E[(X' - β')₊]` for one unit of the angle, while the row changes at this rate: X is the margin in deviations about its mean, X' independent of it.
    pub(super) fn crossings(&self, turned: &SVector<f64, C>) -> f64 {
        if self.steepness == 0.0 {
            return 0.0;
        }
        let (mut mixed, mut rates) = (0.0, 0.0);
        for (g, d) in self.gradient.iter().zip(&self.by_datum) {
            let rate = turned.dot(d);
            mixed += g * rate;
            rates += rate * rate;
        }
        let along = mixed / self.steepness;
        let turning = (rates - along * along).max(0.0).sqrt() / self.steepness;
        let rate = turned.dot(&self.force) / self.steepness;
        let mean = if turning == 0.0 {
            (-rate).max(0.0)
        } else {
            let x = rate / turning;
            turning * normal_density(x) - rate * normal_tail(x)
        };
        normal_density(self.reliability) * mean
    }

    /// How often another margin holds, at most, where this one just fails (Ditlevsen, Narrow reliability bounds for structural systems, 1979).
    pub(super) fn while_holds(&self, other: &Self) -> f64 {
        let mixed: f64 = self.gradient.iter().zip(&other.gradient).map(|(a, b)| a * b).sum();
        let correlation = mixed / (self.steepness * other.steepness);
        // Two that nothing moves together, or against each other, say nothing of one another; nor does what does not spread.
        if correlation <= 0.0 || correlation.is_nan() {
            return 1.0;
        }
        let left = other.reliability - correlation * self.reliability;
        let apart = (1.0 - correlation * correlation).max(0.0).sqrt();
        normal_tail(-ratio(left, apart))
    }
}

/// A value in deviations; infinite, of its sign, where nothing spreads.
fn ratio(value: f64, deviation: f64) -> f64 {
    if deviation == 0.0 { f64::INFINITY.copysign(value) } else { value / deviation }
}
