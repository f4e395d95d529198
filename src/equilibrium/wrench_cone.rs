//! A proof that no contact forces whatsoever balance the load: it lies outside the friction wrench cone.
//!
//! With the generators γ_k of all friction cones (wrenches), the load is balanced by admissible forces iff
//! `Σ γ_k β_k + W = 0` for some β >= 0. Otherwise the residual r of the nearest β,
//!
//! ```text
//! min ½|Γβ + W|², β >= 0      ⟺      0 <= β ⟂ ΓᵀΓ β + ΓᵀW >= 0,     r = Γβ + W,
//! ```
//!
//! is a **separating motion**: γ_k·r >= 0 for all k (no admissible contact force works against it) and W·r = |r|² > 0
//! (the load drives it). Stiffness, commands and history play no part in this.

use nalgebra::{DMatrix, DVector, SVector};

use super::only_lemke;
use crate::formulation::{Law, Problem};
use crate::lcp::{Lcp, Outcome};

/// Above this the dense least-squares problem costs more than the proof is worth.
const MOST_GENERATORS: usize = 400;
/// A residual below this part of the load is no proof: the load lies on the boundary as far as rounding can tell.
const CLEAR: f64 = 1e-9;
/// Generators may work against the motion by this much (relative): rounding of the residual.
const ROUNDING: f64 = 1e-13;

/// The unit separating motion in inside coordinates, if there is a clear one.
pub(crate) fn separating_motion<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
) -> Option<SVector<f64, D>> {
    let generators = generators(problem)?;
    let load = problem.wrench.norm();
    if load == 0.0 || generators.len() > MOST_GENERATORS {
        return None;
    }
    let gamma = DMatrix::from_fn(D, generators.len(), |d, k| generators[k][d]);
    let w = problem.wrench / load;
    let lcp = Lcp::new(gamma.tr_mul(&gamma), gamma.tr_mul(&DVector::from_column_slice(w.as_slice()))).ok()?;
    let Outcome::Solved(solution) = lcp.solve_with(&only_lemke()) else { return None };
    let r = generators.iter().zip(solution.z.iter()).fold(w, |sum, (g, beta)| sum + g * *beta);
    let size = r.norm();
    let v = r / size;
    let proved =
        size > CLEAR && v.dot(&w) > CLEAR && generators.iter().all(|g| g.dot(&v) >= -ROUNDING / size);
    proved.then_some(v)
}

/// Whether a unit motion proves that a load which grows at this rate cannot be balanced any more, by any forces in any state:
/// no admissible contact force works against the motion, the load does not work against it and its rate works along it.
pub(crate) fn separates_from_here_on<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    motion: &SVector<f64, D>,
    rate: &SVector<f64, D>,
) -> bool {
    let slack = 1e-12;
    generators(problem).is_some_and(|generators| {
        generators.iter().all(|g| g.dot(motion) >= -slack)
            && problem.wrench.dot(motion) >= -slack * problem.wrench.norm()
            && rate.dot(motion) > CLEAR * rate.norm()
    })
}

/// Unit wrenches that generate the friction wrench cone; `None` where the law is not a cone of forces at rest.
fn generators<const D: usize, const C: usize>(problem: &Problem<D, C>) -> Option<Vec<SVector<f64, D>>> {
    let mut list = Vec::new();
    for contact in 0..problem.len() {
        let site = &problem.sites[contact];
        let mut push = |force: SVector<f64, C>| list.push((site.map * force).normalize());
        let axis = |a: usize, size: f64| {
            let mut f = SVector::<f64, C>::zeros();
            f[a] = size;
            f
        };
        let bonded = match problem.laws[contact] {
            Law::Absent => continue,
            Law::Edge(_) => return None,
            Law::Bonded => true,
            Law::Cone { .. } => false,
        };
        let mu = site.mu;
        if bonded || mu == 0.0 || mu.is_infinite() {
            push(axis(0, 1.0));
            if bonded || (mu == 0.0 && !problem.may_open(contact)) {
                push(axis(0, -1.0));
            }
            for a in 1..site.axes {
                push(axis(a, 1.0));
                push(axis(a, -1.0));
            }
        } else {
            for corner in &problem.polygon.corners {
                push(axis(0, 1.0) + corner * mu);
            }
        }
    }
    Some(list)
}
