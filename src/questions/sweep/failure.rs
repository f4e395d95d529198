//! The probability that one contact leaves its cone under one load, where data are uncertain.
//!
//! A facet with the reliability β, its margin in standard deviations, fails with probability `Φ(-β)`. On the round cone the facet turns by θ, and
//! so does the gradient u(θ) of its margin, of length one. The probability of a failure at any θ is at most
//!
//! ```text
//! Φ(-β(θ₀)) + ∫ φ(β) E[(X' - β')₊] dθ,      X' normal, mean 0, deviation |u'|
//! ```
//!
//! by the mean number of crossings (Rice, Mathematical analysis of random noise, 1944); φ is the normal density, Φ its distribution, and a prime the
//! derivative by θ. The bound is nearly reached where failures are rare. θ₀ is a direction in which a failure is very unlikely.

use core::f64::consts::{PI, TAU};

use nalgebra::SVector;

use super::margin::{FacetMargin, FirstOrder, UncertainForce};
use super::tolerances::AROUND_A_CONE;
use crate::contact::{Edges, round_rows};
use crate::numerics::{Harmonic, normal_tail};
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// Memory for the margins of a facet under two loads.
pub(super) type MarginPair = [FacetMargin; 2];

/// Upper bound of the probability that a contact leaves its state under the load `here`, and, if `also` is given, keeps its state under that load.
pub(super) fn failure(
    edges: &Edges,
    here: &UncertainForce<'_>,
    also: Option<&UncertainForce<'_>>,
    margins: &mut MarginPair,
) -> f64 {
    let mut two = TwoLoads { here, also, margins };
    match edges {
        Edges::Rows(rows) => rows.iter().map(|row| two.failure_of(row)).sum::<f64>().min(1.0),
        Edges::Round { limit } => two.failure_of_round(&round_rows(*limit)),
    }
}

/// Failure probability of the contact under one load, with its force linearised in the data: a starting value for the search.
pub(super) fn roughly(edges: &Edges, here: &UncertainForce<'_>) -> f64 {
    let first_order = here.first_order();
    match edges {
        Edges::Rows(rows) => {
            rows.iter().map(|row| normal_tail(first_order.reliability(row))).sum::<f64>().min(1.0)
        }
        Edges::Round { limit } => normal_tail(worst_around(&first_order, &round_rows(*limit)).1),
    }
}

/// The direction in which a round cone most probably fails to first order, rad, and the reliability there.
fn worst_around(first_order: &FirstOrder, around: &Harmonic<SVector<f64, 3>>) -> (f64, f64) {
    let mut worst = (0.0, f64::INFINITY);
    for k in 0..AROUND_A_CONE {
        let angle = TAU * k as f64 / AROUND_A_CONE as f64;
        let reliability = first_order.reliability(&around.at(angle));
        if reliability < worst.1 {
            worst = (angle, reliability);
        }
    }
    worst
}

/// The forces of a contact under a load, and under another one, if given.
struct TwoLoads<'a> {
    here: &'a UncertainForce<'a>,
    also: Option<&'a UncertainForce<'a>>,
    margins: &'a mut MarginPair,
}

impl TwoLoads<'_> {
    /// The margin of a facet under the first load.
    fn find(&mut self, facet: &SVector<f64, 3>) -> &FacetMargin {
        self.here.find(facet, &mut self.margins[0]);
        &self.margins[0]
    }

    /// Upper bound of the probability that the last margin is positive under the other load where it just vanishes under the first.
    fn holds_otherwise(&mut self, facet: &SVector<f64, 3>) -> f64 {
        let Some(also) = self.also else { return 1.0 };
        let [margin, other] = &mut *self.margins;
        also.find(facet, other);
        margin.while_holds(other)
    }

    fn failure_of(&mut self, facet: &SVector<f64, 3>) -> f64 {
        // The point of failure of another facet is no good start for this one.
        self.margins[0].start_over(self.here.changes.len());
        normal_tail(self.find(facet).reliability()) * self.holds_otherwise(facet)
    }

    fn failure_of_round(&mut self, around: &Harmonic<SVector<f64, 3>>) -> f64 {
        let first_order = self.here.first_order();
        let roughly = |angle: f64| first_order.reliability(&around.at(angle));
        let (worst, least) = worst_around(&first_order, around);
        if least <= 0.0 {
            return 1.0;
        }
        // Three standard deviations beyond those in reserve, the first-order probability is at most a thousandth of the allowed one, and is kept.
        if least > self.here.sigmas + 3.0 {
            return normal_tail(least);
        }
        let narrower = 0.75;
        // The range of angles whose density counts; it is narrow where reliability grows steeply.
        // The integral ends where the density is its maximum times exp(-9).
        let enough = (least * least + 2.0 * 9.0).sqrt();
        let mut half = PI;
        while half > TAU / AROUND_A_CONE as f64
            && roughly(worst - narrower * half) > enough
            && roughly(worst + narrower * half) > enough
        {
            half *= narrower;
        }
        self.margins[0].start_over(self.here.changes.len());
        let mut sum = normal_tail(self.find(&around.at(worst - half)).reliability());
        // The density falls at both ends like a normal density, so that the error of twelve midpoints is
        // negligible.
        let summed = 12_u32;
        let width = 2.0 * half / f64::from(summed);
        for k in 0..summed {
            let angle = worst - half + width * (f64::from(k) + 0.5);
            let (facet, turned) = (around.at(angle), around.rate_at(angle));
            self.find(&facet);
            let crossings = self.here.crossings(&self.margins[0], &turned);
            if crossings > 0.0 {
                sum += width * crossings * self.holds_otherwise(&facet);
            }
        }
        sum.min(1.0)
    }
}
