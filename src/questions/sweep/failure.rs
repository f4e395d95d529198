//! The probability that a contact ceases to stick under one load, if data of the grasp are uncertain.
//!
//! Each facet of the friction cone has a margin, a linear function of the contact force that is positive inside the cone. The facet fails if its
//! margin is negative. The distance of the given data from failure, in standard deviations, is the reliability β of the facet. To first order in the
//! errors of the data the failure probability is `Φ(-β)`; [`second_order`](super::second_order) corrects it for the curvature of the margin. On the
//! round cone the facet is chosen by the angle θ of its direction. The gradient u(θ) of its margin with respect to the data, scaled to length one,
//! turns with θ. The probability that the contact fails at any θ (its margin is negative at this θ) is at most
//!
//! ```text
//! Φ(-β(θ₀)) + ∫ φ(β) E[(X' - β')₊] dθ,      X' normal, mean 0, deviation |u'|
//! ```
//!
//! This follows from the mean number of zero crossings of the margin over θ (Rice, Mathematical analysis of random noise, 1944). X(θ) is the random
//! decrease of the margin due to the errors of the data, in standard deviations; the facet fails where X exceeds β. φ is the normal density and Φ its
//! distribution function. E is the expectation, x₊ the larger of x and 0, and a prime the derivative with respect to θ. The bound is nearly reached
//! if failures are rare. θ₀ is a direction in which a failure is very unlikely.

use core::f64::consts::{PI, TAU};

use nalgebra::SVector;

use super::margin::{FacetMargin, FirstOrder, UncertainForce};
use super::tolerances::AROUND_A_CONE;
use super::union::Failures;
use crate::contact::{Edges, round_rows};
use crate::numerics::{Harmonic, normal_tail, summed};
use crate::prelude::*;

/// Adds to `events` the possible failures of one contact under a load: a failure is that the contact force leaves the friction cone. The correlation
/// of failures whose probability is below `rare` with other failures is neglected. `margin` is a scratch buffer. In the code the facets of the cone
/// are edges.
pub(super) fn failures(
    (contact, edges): (usize, &Edges),
    here: &UncertainForce<'_>,
    rare: f64,
    margin: &mut FacetMargin,
    events: &mut Failures,
) {
    // Each facet has its own point of failure, the smallest errors with which its margin vanishes. Every search for such a point starts from the data
    // as given, because the point of another facet may be far away.
    match edges {
        Edges::Rows(rows) => {
            for (k, row) in rows.iter().enumerate() {
                margin.start_over(here.changes.len());
                here.find(k, row, margin);
                events.add(margin.fails(), margin, contact, rare);
            }
        }
        Edges::Round { limit } => {
            let around = round_rows(*limit);
            let (worst, least) = worst_around(&here.first_order(), &around);
            // If the reliability exceeds `sigmas`, the required reliability, by three, failures are at least 370 times rarer than allowed, and the
            // first-order probability is accurate enough. If the reliability is not positive, the contact is taken as sure to fail.
            if least <= 0.0 || least > here.sigmas + 3.0 {
                events.add_alone(if least <= 0.0 { 1.0 } else { normal_tail(least) });
                return;
            }
            let probability = failure_of_round(&around, here, (worst, least), margin);
            margin.start_over(here.changes.len());
            here.find(0, &around.at(worst), margin);
            events.add(probability, margin, contact, rare);
        }
    }
}

/// The facets of a contact for which the interaction of the errors of several data is computed, i.e. the change of the contact force due to all
/// errors together, less the sum of the changes due to single errors. A polygonal cone has all its facets in the list; a round cone has only the
/// facet that most probably fails, to first order.
pub(super) fn facets(edges: &Edges, here: &UncertainForce<'_>) -> Vec<SVector<f64, 3>> {
    match edges {
        Edges::Rows(rows) => rows.clone(),
        Edges::Round { limit } => {
            let around = round_rows(*limit);
            vec![around.at(worst_around(&here.first_order(), &around).0)]
        }
    }
}

/// The failure probability of a contact under one load, with its force linearised in the data. The search for the load factor with the allowed
/// failure probability uses it to find a starting value.
pub(super) fn roughly(edges: &Edges, here: &UncertainForce<'_>) -> f64 {
    let first_order = here.first_order();
    match edges {
        Edges::Rows(rows) => summed(rows, &|row| normal_tail(first_order.reliability(row))).min(1.0),
        Edges::Round { limit } => normal_tail(worst_around(&first_order, &round_rows(*limit)).1),
    }
}

/// The direction, rad, in which a contact with a round cone most probably fails to first order, and the first-order reliability β in this direction:
/// the margin over its standard deviation.
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

/// The failure probability of a contact with a round cone under one load: Rice's bound around the angle `worst`, where it most probably fails.
/// `least` is the first-order reliability at this angle.
fn failure_of_round(
    around: &Harmonic<SVector<f64, 3>>,
    here: &UncertainForce<'_>,
    (worst, least): (f64, f64),
    margin: &mut FacetMargin,
) -> f64 {
    let first_order = here.first_order();
    let roughly = |angle: f64| first_order.reliability(&around.at(angle));
    let narrower = 0.75;
    // The integral extends to where the normal density has decreased to exp(-9) of its maximum. That range of angles is narrow if β grows steeply
    // with the angle.
    let enough = (least * least + 2.0 * 9.0).sqrt();
    let mut half = PI;
    while half > TAU / AROUND_A_CONE as f64
        && roughly(worst - narrower * half) > enough
        && roughly(worst + narrower * half) > enough
    {
        half *= narrower;
    }
    margin.start_over(here.changes.len());
    here.find(0, &around.at(worst - half), margin);
    let mut sum = margin.fails();
    // The integrand falls at both ends like a normal density, so the midpoint rule with twelve points has a negligible error.
    let summed = 12_u32;
    let width = 2.0 * half / f64::from(summed);
    for k in 0..summed {
        let angle = worst - half + width * (f64::from(k) + 0.5);
        let (facet, turned) = (around.at(angle), around.rate_at(angle));
        here.find(0, &facet, margin);
        sum += width * here.crossings(margin, &turned);
    }
    sum.min(1.0)
}
