//! Proofs that a problem has no solution, and those that a ray contains.
//!
//! If M is copositive-plus, the direction ẑ of a secondary ray has ẑᵀMẑ = 0, hence (M + Mᵀ)ẑ = 0.
//! Then Mᵀẑ = −Mẑ ≤ 0 and qᵀẑ < 0 (Cottle, Pang & Stone, proof of theorem 4.4.12), so ẑ is itself a
//! Farkas vector. Whether ẑ is one can be checked without knowing the class of M.

use super::dictionary::{Unknown, largest};
use super::outcome::{Proof, Ray};
use super::path::Path;
use super::problem::Lcp;
use super::tolerances::{RAY_NOISE, sum_rounding};
use nalgebra::DVector;

impl Lcp {
    /// Whether y proves that no z ≥ 0 has M z + q ≥ 0: y ≥ 0, Mᵀy ≤ 0 and qᵀy < 0 (Farkas' lemma).
    ///
    /// Each sum is compared with the rounding error it may carry, 8 (n + 2) ε Σ|terms| with
    /// ε = 2⁻⁵². No (Mᵀy)_j may exceed that error, and qᵀy must be below minus that. Where the
    /// products and sums are exact, so is the proof.
    ///
    /// A y of another length than n proves nothing, nor does one with a negative entry or one that
    /// is not finite.
    #[must_use]
    pub fn proves_infeasible(&self, y: &DVector<f64>) -> bool {
        let n = self.len();
        if y.len() != n || !y.iter().all(|y| y.is_finite() && *y >= 0.0) {
            return false;
        }
        let rounding = sum_rounding(n);
        let sums = |column: &[f64]| {
            column.iter().zip(y).fold((0.0, 0.0), |(sum, terms), (m, y)| (sum + m * y, terms + (m * y).abs()))
        };
        let (sum, terms) = sums(self.q.as_slice());
        let descends = terms.is_finite() && sum < -rounding * terms;
        descends
            && self.m.as_slice().chunks_exact(n.max(1)).all(|column| {
                let (sum, terms) = sums(column);
                terms.is_finite() && sum <= rounding * terms
            })
    }
}

/// The ray along which the entering variable grows for ever, in the caller's units and with largest
/// entry 1. `None` if the ray leaves the range of double precision there.
pub(super) fn ray(lcp: &Lcp, path: &Path, entering: Unknown) -> Option<Ray> {
    let mut rates = DVector::zeros(lcp.len());
    let mut covering_rate = 0.0;
    if let Unknown::Z(e) = entering {
        rates[e] = 1.0;
    }
    let noise = RAY_NOISE * largest(&path.dictionary.u).max(1.0);
    for (basic, u) in path.dictionary.basic.iter().zip(&path.dictionary.u) {
        match *basic {
            Unknown::Z(j) if *u > noise => rates[j] = *u,
            Unknown::Covering if *u > noise => covering_rate = *u,
            _ => {}
        }
    }
    let in_units_of = |factors: &[f64]| DVector::from_fn(lcp.len(), |i, _| rates[i] * factors[i]);
    let mut direction = in_units_of(&path.scaling.column);
    // A Farkas vector weighs rows, so it is read in the units of rows.
    let y = in_units_of(&path.scaling.row);
    let proof = if lcp.proves_infeasible(&y) { Proof::Infeasible(y) } else { Proof::None };
    let size = direction.amax();
    if direction.iter().any(|x| !x.is_finite()) {
        return None;
    }
    if size > 0.0 {
        direction /= size;
        covering_rate /= size;
    }
    covering_rate.is_finite().then_some(Ray { direction, covering_rate, proof, pivots: path.pivots })
}
