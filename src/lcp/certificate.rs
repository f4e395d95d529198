//! The secondary ray at the end of a Lemke path, and the infeasibility proof that the ray may contain.
//!
//! If M is copositive-plus, the direction ẑ of a secondary ray has ẑᵀMẑ = 0, hence (M + Mᵀ)ẑ = 0. Then Mᵀẑ = −Mẑ ≤ 0 and qᵀẑ < 0 (Cottle, Pang &
//! Stone, proof of theorem 4.4.12), so ẑ itself is a Farkas vector, which proves that no z ≥ 0 satisfies M z + q ≥ 0. Whether ẑ is a Farkas vector
//! can be checked without knowing the class of M.

use super::dictionary::{LemkeVariable, largest};
use super::outcome::{Outcome, Ray, Unsolved};
use super::path::LemkePath;
use super::problem::Lcp;
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::vector_of;
use nalgebra::DVector;

/// The outcome of a Lemke path at whose end the variable `entering` grows without bound. If the direction of this ray is a Farkas vector, the outcome
/// is a proof. Otherwise the outcome is the ray, in the caller's units and with largest entry 1. `None` if an entry of the ray overflows in the
/// caller's units.
pub(super) fn ray(lcp: &Lcp, path: &LemkePath, entering: LemkeVariable) -> Option<Unsolved> {
    let mut rates = DVector::zeros(lcp.len());
    let mut covering_rate = 0.0;
    if let LemkeVariable::Z(e) = entering {
        rates[e] = 1.0;
    }
    // Entries of the ray up to this magnitude, and negative entries, result from rounding and count as zero. A vector with a negative entry is no
    // proof by Farkas' lemma.
    let noise = SOLVED_ROUNDING * largest(&path.dictionary.u).max(1.0);
    for (basic, u) in path.dictionary.basic.iter().zip(&path.dictionary.u) {
        match *basic {
            LemkeVariable::Z(j) if *u > noise => rates[j] = *u,
            LemkeVariable::Covering if *u > noise => covering_rate = *u,
            _ => {}
        }
    }
    let in_units_of = |factors: &[f64]| vector_of(lcp.len(), &|i| rates[i] * factors[i]);
    let mut direction = in_units_of(&path.scaling.column);
    // A Farkas vector has an entry for each row, so it is converted to the caller's units with the scale factors of the rows.
    let y = in_units_of(&path.scaling.row);
    if let Some(infeasible) = lcp.farkas_proof(&y) {
        return Some(infeasible.after(path.pivots));
    }
    let size = direction.amax();
    if direction.iter().any(|x| !x.is_finite()) {
        return None;
    }
    if size > 0.0 {
        direction /= size;
        covering_rate /= size;
    }
    let ray = Ray { direction, covering_rate, pivots: path.pivots };
    covering_rate.is_finite().then_some(Outcome::Ray(ray))
}
