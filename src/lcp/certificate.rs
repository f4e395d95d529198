//! The secondary ray on which a path ends, and the infeasibility proof that it may contain.
//!
//! If M is copositive-plus, the direction ẑ of a secondary ray has ẑᵀMẑ = 0, hence (M + Mᵀ)ẑ = 0.
//! Then Mᵀẑ = −Mẑ ≤ 0 and qᵀẑ < 0 (Cottle, Pang & Stone, proof of theorem 4.4.12), so ẑ is itself a
//! Farkas vector. Whether ẑ is one can be checked without knowing the class of M.

use super::dictionary::{LemkeVariable, largest};
use super::outcome::{Outcome, Ray, Unsolved};
use super::path::LemkePath;
use super::problem::Lcp;
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::vector_of;
use nalgebra::DVector;

/// The outcome of a path on which the entering variable grows without bound at the end. It is a Farkas proof if the ray is one, otherwise the ray,
/// in the caller's units and with largest entry 1. `None` if the ray leaves the range of double precision in these units.
pub(super) fn ray(lcp: &Lcp, path: &LemkePath, entering: LemkeVariable) -> Option<Unsolved> {
    let mut rates = DVector::zeros(lcp.len());
    let mut covering_rate = 0.0;
    if let LemkeVariable::Z(e) = entering {
        rates[e] = 1.0;
    }
    // A negative rate of this size would spoil a proof, a positive one adds noise to it.
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
    // A Farkas vector weighs rows, so it is read in the units of rows.
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
