//! The probability that one contact leaves its cone under one load, where data are uncertain.
//!
//! A facet with the reliability β, its margin in standard deviations, fails with probability `Φ(-β)`. On the round cone the facet turns by θ, and
//! so does the gradient u(θ) of its margin, of length one. The probability of a failure at any θ is at most
//!
//! ```text
//! Φ(-β(θ₀)) + ∫ φ(β) E[(X' - β')₊] dθ,      X' normal, mean 0, deviation |u'|
//! ```
//!
//! by the mean number of crossings (Rice, Mathematical analysis of random noise, 1944); the bound is nearly reached where failures are rare. θ₀ is a
//! direction that hardly ever fails.

use core::f64::consts::{PI, TAU};

use nalgebra::SVector;

use super::margin::{FacetMargin, MarginRow, UncertainForce};
use crate::contact::Coulomb;
use crate::numerics::normal_tail;
use crate::prelude::*;

/// Directions around the circle among which the worst is looked for, and those of the integral about it.
const AROUND: usize = 16;
/// The integral ends where the density is less by the exponential of this.
const LEFT_OUT: f64 = 9.0;
/// The integral is never narrower than the distance of two directions among which the worst was looked for: it must contain it.
const HALF_AT_LEAST: f64 = TAU / AROUND as f64;

/// What fails, to first order, with so many deviations more than are in reserve counts as little as it looks: in 16 million one.
const SELDOM: f64 = 5.0;

/// The conditions that keep a contact in its state.
#[derive(Debug, Clone)]
pub(super) enum LimitState<const C: usize> {
    /// No conditions.
    None,
    /// The normal force, or the gap of an open contact, must not become negative.
    Opens,
    /// Facets of a polygon; in the plane both edges.
    Facets(Coulomb, Vec<SVector<f64, C>>),
    /// The round cone.
    Round(Coulomb),
}

/// Memory for the margins of a facet under two loads.
pub(super) type MarginPair = [FacetMargin; 2];

impl<const C: usize> LimitState<C> {
    /// Upper bound of the probability that the contact leaves under one load, and does not under another one, if given.
    pub(super) fn failure(
        &self,
        here: &UncertainForce<'_, C>,
        also: Option<&UncertainForce<'_, C>>,
        margins: &mut MarginPair,
    ) -> f64 {
        let mut two = TwoLoads { here, also, margins };
        match self {
            Self::None => 0.0,
            Self::Opens => {
                let mut row = SVector::zeros();
                row[0] = 1.0;
                two.failure_of(row, false)
            }
            Self::Facets(cone, facets) => {
                facets.iter().map(|h| two.failure_of(cone.facet_row(h), true)).sum::<f64>().min(1.0)
            }
            Self::Round(cone) => two.failure_of_round(*cone),
        }
    }
}

/// The forces of a contact under a load, and under another one, if given.
struct TwoLoads<'a, const C: usize> {
    here: &'a UncertainForce<'a, C>,
    also: Option<&'a UncertainForce<'a, C>>,
    margins: &'a mut MarginPair,
}

impl<const C: usize> TwoLoads<'_, C> {
    /// The margin of a facet under the first load.
    fn find(&mut self, facet: &MarginRow<C>) -> &FacetMargin {
        self.here.find(facet, &mut self.margins[0]);
        &self.margins[0]
    }

    /// The probability that the last margin holds under the other load where it just fails under the first.
    fn holds_otherwise(&mut self, facet: &MarginRow<C>) -> f64 {
        let Some(also) = self.also else { return 1.0 };
        let [margin, other] = &mut *self.margins;
        also.find(facet, other);
        margin.while_holds(other)
    }

    fn failure_of(&mut self, row: SVector<f64, C>, rubs: bool) -> f64 {
        let facet = MarginRow { row, rubs };
        // Nothing of another facet is near this one.
        self.margins[0].start_over(self.here.changes.len());
        normal_tail(self.find(&facet).reliability()) * self.holds_otherwise(&facet)
    }

    fn failure_of_round(&mut self, cone: Coulomb) -> f64 {
        let along = |x: f64, y: f64| SVector::<f64, C>::from_fn(|a, _| [0.0, x, y][a]);
        let facet =
            |angle: f64| MarginRow { row: cone.facet_row(&along(angle.cos(), angle.sin())), rubs: true };
        let first_order = self.here.first_order();
        let roughly = |angle: f64| first_order.reliability(&facet(angle));
        let all_around =
            (0..AROUND).map(|k| TAU * k as f64 / AROUND as f64).map(|angle| (angle, roughly(angle)));
        let (worst, least) =
            all_around.fold((0.0, f64::INFINITY), |worst, new| if new.1 < worst.1 { new } else { worst });
        if least <= 0.0 {
            return 1.0;
        }
        if least > self.here.sigmas + SELDOM {
            return normal_tail(least);
        }
        // As much of the circle as matters; where reliability grows steeply that is little.
        let enough = (least * least + 2.0 * LEFT_OUT).sqrt();
        let mut half = PI;
        while half > HALF_AT_LEAST
            && roughly(worst - 0.5 * half) > enough
            && roughly(worst + 0.5 * half) > enough
        {
            half *= 0.5;
        }
        self.margins[0].start_over(self.here.changes.len());
        let mut sum = normal_tail(self.find(&facet(worst - half)).reliability());
        let width = 2.0 * half / AROUND as f64;
        for k in 0..AROUND {
            let angle = worst - half + width * (k as f64 + 0.5);
            let (facet, turned) = (facet(angle), -along(-angle.sin(), angle.cos()));
            self.find(&facet);
            let crossings = self.here.crossings(&self.margins[0], &turned);
            if crossings > 0.0 {
                sum += width * crossings * self.holds_otherwise(&facet);
            }
        }
        sum.min(1.0)
    }
}
