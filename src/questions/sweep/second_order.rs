//! The failure probability of a facet of a friction cone to second order in the errors of the data.
//!
//! The point of failure z is the smallest vector of errors of the data, in standard deviations, at which the margin m of the facet vanishes; the
//! reliability β is its length. The normal distribution has the density φ and the distribution function Φ. Near z the margin is expanded to second
//! order. Let g be its gradient, H its second derivative with respect to the data, and n = g / |g|. The complement of n is the space of all vectors
//! perpendicular to n. The failure probability is `Φ(-β)` times a factor, which is below 1 if the margin curves upwards across n (Hohenbichler and
//! Rackwitz, Improvement of second-order reliability estimates by importance sampling, 1988)
//!
//! ```text
//! det(A on the complement of n)^(-1/2),      A = 1 + ψ H / |g|,      ψ = φ(β) / Φ(-β)
//! ```
//!
//! H consists of a diagonal D, the row and column of friction, and the interactions C (mixed second derivatives) of each pair of other data. Without
//! C, `det(A on the complement of n) = det(A) nᵀA⁻¹n` is a sum over the data. The matrix C itself is not computed. To first order in C, nᵀCn is
//! enough. Since C has no diagonal, its trace on the complement of n is `-nᵀCn`, and the determinant is multiplied by `1 - ψ nᵀCn / |g|`. To second
//! order it is multiplied by `exp(-ψ² |C|² / 2|g|²)`, where |C|² is the sum of the squares of all entries. This sum includes entries along n, which
//! errs on the safe side.

use super::margin::{ContinuedEffect, FacetMargin};
use super::tolerances::LEAST_CURVED;
use crate::numerics::{Each, normal_density, normal_tail};
#[cfg(not(feature = "std"))]
use crate::prelude::*;

impl FacetMargin {
    /// The failure probability divided by `Φ(-β)`, for a margin that is positive for the data as given. The gradient of the margin at the point of
    /// failure is stored in `self`. `joint` returns nᵀCn and |C|² for the matrix C of mixed second derivatives with respect to pairs of data. The
    /// argument of `joint` is the factor on the coefficient of friction at the point of failure.
    pub(super) fn curved(
        &self,
        involves_friction: bool,
        sigmas: f64,
        friction: f64,
        joint: &dyn Fn(f64) -> [f64; 2],
    ) -> f64 {
        let reliability = self.reliability();
        let by_bend = normal_density(reliability) / (normal_tail(reliability) * self.steepness);
        let (friction, factor) = match self.linearised_at.last() {
            Some(z) if involves_friction => (friction, (friction * z).exp()),
            _ => (0.0, 1.0),
        };
        let mut product = 1.0;
        // Sums over the data of nᵢ²/Aᵢᵢ, nᵢ bᵢ/Aᵢᵢ and bᵢ²/Aᵢᵢ. Here n and A are as at the top of this file, and b is the row of A that belongs to
        // friction.
        let (mut squares, mut mixed, mut of_friction) = (0.0, 0.0, 0.0);
        for ((coefficients, z), g) in self.parts.iter().zip(&self.linearised_at).zip(&self.gradient) {
            let [normal, other] =
                [0, 1].each(|k| ContinuedEffect::of(coefficients.each(|c| c[k]), z / sigmas));
            let bend = (factor * normal.bend + other.bend) / (sigmas * sigmas);
            let diagonal = (1.0 + by_bend * bend).max(LEAST_CURVED);
            let row = by_bend * friction * factor * normal.slope / sigmas;
            let n = g / self.steepness;
            product *= diagonal;
            squares += n * n / diagonal;
            mixed += n * row / diagonal;
            of_friction += row * row / diagonal;
        }
        let g = self.gradient.last().copied().unwrap_or(0.0);
        let along = g / self.steepness - mixed;
        let alone = product * ((1.0 + by_bend * friction * g - of_friction) * squares + along * along);
        let [along_n, squares] = joint(factor);
        let together = (1.0 - by_bend * along_n) * (-0.5 * by_bend * by_bend * squares).exp();
        (alone.max(LEAST_CURVED) * together.max(LEAST_CURVED)).sqrt().recip()
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use super::super::margin::{Effect, FacetMargin, UncertainForce};
    use crate::numerics::{normal_density, normal_tail};

    /// The failure probability of a facet whose margin is F_n/2 - F_t, then the failure probability to first order. For each datum, `changes` has the
    /// change of the contact force as a polynomial in the error of this datum. The unit of the error is three standard deviations. `friction` is the
    /// standard deviation of the logarithm of the coefficient of friction.
    fn fails(force: [f64; 3], changes: &[Effect], friction: f64) -> (f64, f64) {
        let here = UncertainForce { force: SVector::from(force), changes, joint: &[], sigmas: 3.0, friction };
        let mut margin = FacetMargin::default();
        here.find(0, &SVector::from([0.5, -1.0, 0.0]), &mut margin);
        (margin.fails(), normal_tail(margin.reliability()))
    }

    /// The total probability of failure if the error of one datum is random, normally distributed. `given` returns the probability P(z) of failure
    /// with an error of z standard deviations. The total is `∫ φ(z) P(z) dz` with the normal density φ, by the midpoint rule.
    fn averaged(given: &dyn Fn(f64) -> f64) -> f64 {
        let (steps, width) = (4000, 4e-3);
        let at = |k: i32| f64::from(2 * k + 1 - steps) * 0.5 * width;
        (0..steps).map(|k| width * normal_density(at(k)) * given(at(k))).sum()
    }

    /// Let z be the error of a datum and z_f that of friction, in standard deviations. The normal force is 10 + 1.5 z, the coefficient of friction
    /// exp(0.2 z_f) / 2, and the friction force 2. The margin is zero where `exp(0.2 z_f) (10 + 1.5 z) / 2 = 2`.
    #[test]
    fn friction_curves_a_margin() {
        let mut change = Effect::default();
        change[0][0] = 1.5 * 3.0;
        let (fails, first_order) = fails([10.0, 2.0, 0.0], &[change], 0.2);
        let slides = |z: f64| normal_tail((2.5 + 0.375 * z).max(1e-300).ln() / 0.2);
        let exact = averaged(&slides);
        assert!((fails / exact - 1.0).abs() < 0.01, "{fails} {exact}");
        assert!(first_order < 0.9 * exact, "{first_order}");
    }

    /// The friction force is 2 + z₁ + c z₂², with the errors z₁ and z₂ of two data in standard deviations. The limit of the friction force is 5. The
    /// margin is zero where `z₁ + c z₂² = 3`.
    #[test]
    fn a_datum_curves_a_margin() {
        for curved in [-0.1, 0.05, 0.1] {
            let mut changes = [Effect::default(); 2];
            changes[0][0][1] = 3.0;
            changes[1][1][1] = curved * 9.0;
            let (fails, first_order) = fails([10.0, 2.0, 0.0], &changes, 0.0);
            let exact = averaged(&|z| normal_tail(3.0 - curved * z * z));
            let [left, before] = [fails, first_order].map(|of| (of / exact - 1.0).abs());
            assert!(left < 0.1 && left < 0.25 * before, "{curved}: {fails} {first_order} {exact}");
        }
    }
}
