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
//!
//! A round cone has infinitely many generators: a motion that separates the load from the inscribed polygons proves nothing yet. It
//! does if no generator of the round cones works against it, and so does one that separates the load from
//! polygons around the round cones; their corners are cut off where they carry the load, until one is found.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector, SVector};

use crate::contact::{Law, LocalLaw, Polygon};
use crate::lcp::{self, Lcp, Outcome};
use crate::numerics::unit;
use crate::object::Problem;

/// Above this the dense least-squares problem costs more than the proof is worth, and generators are taken in a few at a time.
const MOST_GENERATORS: usize = 400;
/// A residual below this part of the load is no proof: the load lies on the boundary as far as rounding can tell.
const CLEAR: f64 = 1e-9;
/// Generators may work against the motion by this much (relative): rounding of the residual.
const ROUNDING: f64 = 1e-13;

/// Work of a unit wrench on a unit motion (no unit) that counts as none: rounding of motions that come from a solved
/// piece. A smaller part would refuse proofs at limit loads.
const NO_WORK: f64 = 1e-12;

/// Part of the work of the load that a force of a round cone may do against a motion.
const NEGLIGIBLE: f64 = 1e-3;
/// How often corners of the polygons around the round cones are cut off: each time a corner comes four times nearer.
const MOST_CUTS: usize = 10;

/// The unit separating motion in inside coordinates, if there is a clear one.
pub(crate) fn separating_motion<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
) -> Option<SVector<f64, D>> {
    let load = problem.wrench.norm();
    if load == 0.0 {
        return None;
    }
    let w = problem.wrench / load;
    let list = generators(problem)?;
    let (v, _) = separate(&list, &w, f64::INFINITY);
    let v = v?;
    // Forces that balance the load may be much larger than the load: their work must not make up for that of the load.
    if !works_against_round_cones(problem, &v, NEGLIGIBLE * v.dot(&w)) {
        return Some(v);
    }
    let directions =
        |local: LocalLaw<'_, C>| if local.is_round() { directions(local.polygon) } else { Vec::new() };
    let mut tangents: Vec<Vec<f64>> = problem.locals().map(directions).collect();
    for _ in 0..MOST_CUTS {
        let (mut around, corners) = corners_around(problem, &tangents);
        around.extend(straight_generators(problem)?);
        let (v, shares) = separate(&around, &w, NEGLIGIBLE);
        if v.is_some() {
            return v;
        }
        let carries = corners.iter().zip(shares.iter()).filter(|(_, share)| **share > 0.0);
        for ((contact, angle), _) in carries {
            tangents[*contact].push(*angle);
        }
        for list in &mut tangents {
            list.sort_by(f64::total_cmp);
        }
    }
    None
}

/// The unit residual of the nearest β >= 0 if it separates the load from these generators clearly; and β.
fn separate<const D: usize>(
    generators: &[SVector<f64, D>],
    w: &SVector<f64, D>,
    negligible: f64,
) -> (Option<SVector<f64, D>>, DVector<f64>) {
    let nearest = |chosen: &[usize]| {
        let gamma = DMatrix::from_fn(D, chosen.len(), |d, k| generators[chosen[k]][d]);
        let w = DVector::from_column_slice(w.as_slice());
        let lcp = Lcp::new(gamma.tr_mul(&gamma), gamma.tr_mul(&w)).ok()?;
        let Outcome::Solved(solution) = lcp.solve_with(&lcp::Settings::one_path()) else { return None };
        Some(solution.z)
    };
    let residual = |chosen: &[usize], z: &DVector<f64>| {
        chosen.iter().zip(z.iter()).fold(*w, |sum, (&k, beta)| sum + generators[k] * *beta)
    };
    let mut chosen: Vec<usize> = Vec::new();
    let (mut r, mut z) = (*w, DVector::zeros(0));
    if generators.len() <= MOST_GENERATORS {
        chosen.extend(0..generators.len());
        let Some(shares) = nearest(&chosen) else { return (None, DVector::zeros(0)) };
        (r, z) = (residual(&chosen, &shares), shares);
    } else {
        // Of many generators a few are enough: the one that works most against the residual joins those that have a share.
        for _ in 0..MOST_GENERATORS {
            let works = |k: &usize| generators[*k].dot(&r);
            let next = (0..generators.len()).min_by(|i, j| works(i).total_cmp(&works(j)));
            let Some(next) = next.filter(|k| works(k) < -ROUNDING && r.norm() > CLEAR) else { break };
            chosen.push(next);
            let Some(shares) = nearest(&chosen) else { break };
            r = residual(&chosen, &shares);
            chosen = (0..chosen.len()).filter(|&k| shares[k] > 0.0).map(|k| chosen[k]).collect();
            z = DVector::from_iterator(chosen.len(), shares.iter().copied().filter(|share| *share > 0.0));
        }
    }
    let mut shares = DVector::zeros(generators.len());
    for (&k, share) in chosen.iter().zip(z.iter()) {
        shares[k] = *share;
    }
    let size = r.norm();
    let (v, slack) = (r / size, (ROUNDING / size).min(negligible * size));
    let proved = size > CLEAR && v.dot(w) > CLEAR && generators.iter().all(|g| g.dot(&v) >= -slack);
    (proved.then_some(v), shares)
}

/// Whether some force of a round cone works against a unit motion: with u = G_iᵀv the one along e_n - μ u_t/|u_t| does most.
fn works_against_round_cones<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    v: &SVector<f64, D>,
    slack: f64,
) -> bool {
    problem
        .locals()
        .zip(problem.sites)
        .filter(|(local, _)| local.is_round())
        .any(|(local, site)| local.cone().least_power(&site.map.tr_mul(v)) < -slack)
}

/// The angles of the corners of a polygon.
fn directions<const C: usize>(polygon: &Polygon<C>) -> Vec<f64> {
    let mut angles: Vec<f64> = polygon.corners.iter().map(|d| d[2].atan2(d[1])).collect();
    angles.sort_by(f64::total_cmp);
    angles
}

/// Unit wrenches along the corners of the polygons that touch the round cones at these angles, with contact and angle of each.
fn corners_around<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    tangents: &[Vec<f64>],
) -> (Vec<SVector<f64, D>>, Vec<(usize, f64)>) {
    let (mut list, mut corners) = (Vec::new(), Vec::new());
    for (contact, angles) in tangents.iter().enumerate() {
        let site = &problem.sites[contact];
        for (k, &from) in angles.iter().enumerate() {
            let to = angles.get(k + 1).copied().unwrap_or(angles[0] + TAU);
            let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
            let mut force = SVector::<f64, C>::zeros();
            (force[1], force[2]) = (middle.cos(), middle.sin());
            let force = site.friction.generator(&(force / half.cos()));
            list.push((site.map * force).normalize());
            corners.push((contact, middle));
        }
    }
    (list, corners)
}

/// Whether a unit motion proves that a load which grows at this rate cannot be balanced any more.
///
/// It does, for any forces in any state, if no admissible contact force works against the motion, the load does not work
/// against it, and the rate of the load works along it.
pub(crate) fn separates_from_here_on<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    motion: &SVector<f64, D>,
    rate: &SVector<f64, D>,
) -> bool {
    // Of a round cone no polygon inside, but the one generator that does most against the motion.
    !works_against_round_cones(problem, motion, NO_WORK)
        && straight_generators(problem).is_some_and(|generators| {
            generators.iter().all(|g| g.dot(motion) >= -NO_WORK)
                && problem.wrench.dot(motion) >= -NO_WORK * problem.wrench.norm()
                && rate.dot(motion) > CLEAR * rate.norm()
        })
}

/// Unit wrenches that generate the friction wrench cone, inscribed polygons for round cones; `None` where the law is
/// not a cone of forces at rest.
fn generators<const D: usize, const C: usize>(problem: &Problem<D, C>) -> Option<Vec<SVector<f64, D>>> {
    let mut list = straight_generators(problem)?;
    for (local, site) in problem.locals().zip(problem.sites).filter(|(local, _)| local.is_round()) {
        let forces = local.polygon.corners.iter().map(|corner| local.cone().generator(&corner.normalize()));
        list.extend(forces.map(|force| (site.map * force).normalize()));
    }
    Some(list)
}

/// The unit wrenches of [`generators`] without those of round cones.
fn straight_generators<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
) -> Option<Vec<SVector<f64, D>>> {
    let mut list = Vec::new();
    for (local, site) in problem.locals().zip(problem.sites).filter(|(local, _)| !local.is_round()) {
        let mut push = |force: SVector<f64, C>| list.push((site.map * force).normalize());
        match local.law {
            Law::Absent => continue,
            Law::Edge(_) => return None,
            Law::Bonded | Law::Cone { .. } => {}
        }
        let cone = site.friction;
        if !local.is_bonded() && cone.has_edges() {
            local.polygon.corners.iter().for_each(|corner| push(cone.generator(corner)));
            continue;
        }
        push(unit(0));
        if local.is_bonded() || (cone.is_frictionless() && !local.may_open()) {
            push(-unit::<C>(0));
        }
        for a in 1..local.springs.axes() {
            push(unit(a));
            push(-unit::<C>(a));
        }
    }
    Some(list)
}
