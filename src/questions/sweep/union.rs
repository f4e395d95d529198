//! An upper bound of the probability that any of several failures happens, if their margins are correlated. A failure is a negative margin of a facet
//! (a plane that bounds a friction cone, or touches a round one). The point of failure is the shortest vector of errors of the data, in standard
//! deviations, at which the margin vanishes. Its length is the reliability β.
//!
//! For failures E_i and a tree that connects pairs (i, j) of them (Hunter, An upper bound for the probability of a union, 1976)
//!
//! ```text
//! P(∪ E_i) <= Σ P(E_i) - Σ P(E_i ∩ E_j),      second sum over the pairs of the tree
//! ```
//!
//! The bound is least for the tree with the greatest second sum. To first order margins are normal, with the correlation of their gradients at their
//! points of failure.

use super::margin::FacetMargin;
use crate::numerics::{Each, IntoList, dot, normal_tail, tail_of_both};
use crate::prelude::*;

/// Possible failures of contacts, under one load or under several; a failure is a negative margin.
#[derive(Debug, Clone, Default)]
pub(super) struct Failures {
    frequent: Vec<Failure>,
    /// Sum of the probabilities of failures whose correlation with other failures is neglected: failures that are rare, or that happen more often
    /// than not.
    rare: f64,
}

/// One possible failure: the margin of one facet (or of one round cone) is negative because of errors of the data.
#[derive(Debug, Clone)]
struct Failure {
    probability: f64,
    reliability: f64,
    /// The failure probability to first order, `Φ(-β)`, with the reliability β and the normal distribution Φ.
    first_order: f64,
    /// The contact, given by the index of its first point. The last entry of `gradient` is the derivative with respect to the coefficient of friction
    /// of this contact.
    contact: usize,
    /// Gradient of the margin with respect to the errors of the data in standard deviations, the error of friction last; scaled to length one.
    gradient: Vec<f64>,
}

impl Failures {
    /// Adds a possible failure of this contact, with its probability. For a round cone `margin` is the margin of the facet that most probably fails.
    /// If the failure is rarer than `rare`, its correlation with others is neglected.
    pub(super) fn add(&mut self, probability: f64, margin: &FacetMargin, contact: usize, rare: f64) {
        let reliability = margin.reliability();
        // Correlation matters little for rare failures. A negative reliability means that the contact fails more often than not. The probability of
        // failure is then far above the allowed one, whatever the correlation. At a reliability from 1e3 on the probability of failure is zero in
        // double precision.
        if probability < rare || !(0.0..1e3).contains(&reliability) {
            self.rare += probability;
            return;
        }
        let gradient = margin.gradient.iter().map(|g| g / margin.steepness).list();
        let first_order = normal_tail(reliability);
        self.frequent.push(Failure { probability, reliability, first_order, contact, gradient });
    }

    /// Adds the probability of a failure whose correlation with others is neglected.
    pub(super) fn add_alone(&mut self, probability: f64) {
        self.rare += probability;
    }

    /// An upper bound of the probability that any of these failures, or of `others`, happens.
    pub(super) fn any(&self, others: &Self) -> f64 {
        let mut left: Vec<(f64, &Failure)> =
            self.frequent.iter().chain(&others.frequent).map(|of| (0.0, of)).list();
        let mut sum = self.rare + others.rare;
        // Prim's method grows the tree: the next failure to join is the one with the greatest joint probability with some failure already in the
        // tree.
        while let Some(next) = (0..left.len()).max_by(|a, b| left[*a].0.total_cmp(&left[*b].0)) {
            let (both, joins) = left.swap_remove(next);
            sum += joins.probability - both;
            for (most, other) in &mut left {
                *most = most.max(joins.with(other));
            }
        }
        sum.min(1.0)
    }
}

impl Failure {
    /// An approximate probability that both failures happen: their joint probability to first order, times the smaller of the two corrections
    /// `probability / first_order`.
    fn with(&self, other: &Self) -> f64 {
        // Only points of one contact share their friction coefficient; the friction coefficients of different contacts are independent.
        let data = self.gradient.len() - usize::from(self.contact != other.contact);
        let correlation = dot(&self.gradient[..data], &other.gradient[..data]);
        let [bounds, tails] = [[self.reliability, other.reliability], [self.first_order, other.first_order]];
        let first_order = tail_of_both(bounds, tails, correlation);
        let [more, more_of_other] = [self, other].each(|of| of.probability / of.first_order);
        more.min(more_of_other) * first_order
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::normal_density;

    /// A failure for each reliability βᵢ, with the margin `βᵢ - √ρ z₀ - √(1 - ρ) zᵢ`. All z are independent standard normal variables, so that every
    /// two margins have the correlation ρ (`rho`).
    fn alike(reliabilities: &[f64], rho: f64) -> Failures {
        let mut all = Failures::default();
        for (i, reliability) in reliabilities.iter().enumerate() {
            let mut gradient = vec![0.0; reliabilities.len() + 2];
            (gradient[0], gradient[i + 1]) = (rho.sqrt(), (1.0 - rho).sqrt());
            let first_order = normal_tail(*reliability);
            let probability = first_order;
            all.frequent.push(Failure {
                probability,
                reliability: *reliability,
                first_order,
                contact: i,
                gradient,
            });
        }
        all
    }

    /// The exact probability that any of the failures of [`alike`] happens. For a given value z of z₀ their margins are independent. The probability
    /// is therefore `1 - ∫ φ(z) Π Φ((βᵢ - √ρ z) / √(1 - ρ)) dz`, with the normal density φ and distribution function Φ.
    fn exact(reliabilities: &[f64], rho: f64) -> f64 {
        let (steps, width) = (8000, 2e-3);
        let none = |z: f64| -> f64 {
            reliabilities.iter().map(|b| normal_tail((rho.sqrt() * z - b) / (1.0 - rho).sqrt())).product()
        };
        let at = |k: i32| f64::from(2 * k + 1 - steps) * 0.5 * width;
        (0..steps).map(|k| width * normal_density(at(k)) * (1.0 - none(at(k)))).sum()
    }

    #[test]
    fn a_bound_lies_between_the_probability_and_the_sum() {
        for reliabilities in [&[2.0, 2.0][..], &[2.0, 2.5], &[3.0, 3.1, 3.3], &[2.5; 5], &[0.5, 1.0]] {
            let sum: f64 = reliabilities.iter().map(|b| normal_tail(*b)).sum();
            let mut last = f64::INFINITY;
            for rho in [0.0, 0.3, 0.6, 0.9, 0.99, 0.9999] {
                let all = alike(reliabilities, rho);
                let (bound, exact) = (all.any(&Failures::default()), exact(reliabilities, rho));
                // For two failures the upper bound of the probability of any failure is exact. If ρ is near 1, it has an error of a few 1e-3 of the
                // smaller probability.
                let most = if reliabilities.len() == 2 { exact } else { sum.min(1.0) };
                assert!(
                    bound > 0.999 * exact && bound < 1.001 * most,
                    "{reliabilities:?} {rho}: {bound} {exact}"
                );
                assert!(bound < 1.001 * last, "{reliabilities:?} {rho}");
                last = bound;
            }
            // If all margins depend on one datum alone, the most probable failure happens whenever any other happens.
            let most = reliabilities.iter().map(|b| normal_tail(*b)).fold(0.0, f64::max);
            assert!(last < 1.1 * most, "{reliabilities:?}: {last} {most}");
        }
    }

    /// The probability that two independent failures both happen is only the product of their probabilities.
    #[test]
    fn friction_is_shared_by_the_points_of_a_contact_alone() {
        let event = |contact| {
            let first_order = normal_tail(3.0);
            let gradient = vec![0.0, 1.0];
            Failure { probability: first_order, reliability: 3.0, first_order, contact, gradient }
        };
        let both = |contacts: [usize; 2]| {
            let [one, other] = contacts.map(|contact| Failures { frequent: vec![event(contact)], rare: 0.0 });
            one.any(&other) / normal_tail(3.0)
        };
        assert!((both([0, 1]) - 2.0 + normal_tail(3.0)).abs() < 1e-12 && (both([4, 4]) - 1.0).abs() < 1e-4);
    }
}
