//! Proofs that no solution exists. Under any forces in the friction cones, the normal velocity of some contact is negative, so that its two bodies
//! penetrate each other.
//!
//! Velocities are u = W r + q for contact forces r; W_N and q_N are the normal rows of W and q. A vector y ≥ 0 with one weight per contact is such a
//! proof if a = W_Nᵀ y and q_N satisfy
//!
//! ```text
//! a_N + μ ‖a_T‖ ≤ 0 at each contact,     q_Nᵀ y < 0:
//! ```
//!
//! For forces in the cones aᵀr ≤ 0, so yᵀu_N = aᵀr + q_Nᵀy < 0, and some u_N is negative.

use super::facets::Facets;
use super::problem::{FrictionProblem, part};
use super::tolerances::PROOF_ROUNDING;
use crate::lcp::{self, Lcp};
use crate::numerics::{ExactSum, IntoList, Reals, mapped, rounding_of, times_power_of_two, vector_of};
use crate::prelude::*;
use core::cmp::Ordering;
use core::f64::consts::PI;
use nalgebra::{DMatrix, DVector, SVector};

impl<const C: usize> FrictionProblem<C> {
    /// Whether y, with a weight for each of the n contacts, proves that no solution exists. Let W_N and q_N be the normal rows of the matrix W and of
    /// the vector q, and a = W_Nᵀ y. The proof needs y ≥ 0, q_Nᵀ y < 0, and a_N + μ ‖a_T‖ ≤ 0 at each contact. Then yᵀu_N < 0 for the normal
    /// velocities u_N under all forces in the cones.
    ///
    /// In the plane the check is exact. In space sums are exact, but ‖a_T‖ is rounded, and its rounding counts against the proof. A y that
    /// narrowly fails in space may thus be a proof in exact arithmetic.
    #[must_use]
    pub fn proves_infeasible(&self, y: &DVector<f64>) -> bool {
        let n = self.len();
        if y.len() != n || !y.iter().all(|y| y.is_finite() && *y >= 0.0) {
            return false;
        }
        let weighed = |column: &[f64]| ExactSum::of_products((0..n).map(|i| (column[C * i], y[i])));
        if weighed(self.q.as_slice()).sign() != Ordering::Less {
            return false;
        }
        let columns: Vec<&[f64]> = self.w.as_slice().chunks_exact(C * n).list();
        columns.chunks_exact(C).zip(&self.mu).all(|(columns, mu)| {
            if C == 2 {
                return [1.0, -1.0].into_iter().all(|side| {
                    edge(y, columns, C, side * mu).is_some_and(|sum| sum.sign() != Ordering::Greater)
                });
            }
            let sums: Vec<(f64, i32)> = mapped(columns, &|column| weighed(column).leading());
            let (normal, slips) = (sums[0], &sums[1..]);
            if *mu == 0.0 || slips.iter().all(|slip| slip.0 == 0.0) {
                return normal.0 <= 0.0;
            }
            // The ratio of a tangential component of a = W_Nᵀ y to its normal component. Both components are pairs of mantissa and binary exponent,
            // since the exponents may be outside the range of doubles.
            let beside = |slip: &(f64, i32)| times_power_of_two(slip.0 / normal.0, slip.1 - normal.1);
            let slip = slips.iter().map(beside).fold(0.0, f64::hypot);
            normal.0 < 0.0 && mu * slip * (1.0 + PROOF_ROUNDING) <= 1.0
        })
    }

    /// A vector that passes [`Self::proves_infeasible`]: the unit vector of one contact, or a result of linear programming with polygons around
    /// the cones.
    pub(super) fn certificate(&self, settings: &lcp::Settings) -> Option<DVector<f64>> {
        let n = self.len();
        // For many contacts each polygon has fewer facets: at most 512 for all contacts together, but at least four for each contact.
        let count = if C == 2 { 2 } else { (512 / n.max(1)).clamp(4, 32) };
        let facets = Facets::<C>::regular(count, &vec![0.0; n]);
        // The corners of a regular polygon around the unit circle have this distance from its centre; it is rounded up.
        let around = if C == 2 { 1.0 } else { (PI / count as f64).cos().recip() * (1.0 + PROOF_ROUNDING) };
        let mut normals = DMatrix::zeros(n, count * n);
        for (i, directions) in facets.0.iter().enumerate() {
            for (j, d) in directions.iter().enumerate() {
                let mut generator: SVector<f64, C> = d * (self.mu[i] * around);
                generator[0] = 1.0;
                for row in 0..n {
                    let moved = (0..C).map(|a| self.w[(C * row, C * i + a)] * generator[a]);
                    normals[(row, count * i + j)] = moved.added();
                }
            }
        }
        let q = vector_of(n, &|i| part::<C>(&self.q, i)[0]);
        for i in 0..n {
            let single = vector_of(n, &|k| if k == i { 1.0 } else { 0.0 });
            if self.proves_infeasible(&single) {
                return Some(single);
            }
        }
        Lcp::contradictions(&normals, &q, settings).find(|y| self.proves_infeasible(y))
    }
}

/// In the plane two rays bound a contact's friction cone. For one of these rays, the exact sum Σ y_i (W_iN + μ W_iT). It is the weighted normal
/// velocity of all contacts i per unit of normal force, if the force of the contact lies on the ray. In a proof y it is at most zero. W_iN and W_iT
/// are entries of `columns`, the contact's normal and tangential columns of W. They are in row `step · i`, the normal row of contact i. The products
/// of y_i and μ are split into two doubles without error; `None` if one of them underflows or overflows.
fn edge(y: &DVector<f64>, columns: &[&[f64]], step: usize, mu: f64) -> Option<ExactSum> {
    let mut sum = ExactSum::new();
    for (i, y) in y.iter().enumerate() {
        let product = mu * y;
        // Products of numbers in this range, and their rounding errors, neither underflow nor overflow, so no digit is lost.
        let kept = 1e-280..1e280;
        if product != 0.0 && [product, mu, *y].iter().any(|x| !kept.contains(&x.abs())) {
            return None;
        }
        sum.add_product(columns[0][step * i], *y);
        sum.add_product(columns[1][step * i], product);
        sum.add_product(columns[1][step * i], rounding_of(product, mu, *y));
    }
    Some(sum)
}
