//! The motion with which bodies start to move if their load is not in equilibrium and no contact carries a force yet. It is the motion of rigid
//! bodies under the load, with Coulomb friction at contacts that touch.
//!
//! Springs do not determine the motion as long as they carry no force. If all contacts stuck, as in the elastic trial, the object would turn about an
//! arbitrary point. A rigid body that the load W drives away starts with the velocity v under contact forces r_i
//!
//! ```text
//! v = W + Σ G_i r_i,     0 <= r_n ⟂ n·G_iᵀv >= 0,     |r_t| <= μ r_n against G_iᵀv
//! ```
//!
//! as if its mass matrix were the identity. G_iᵀv is the velocity of the contact point. The identity means unit mass, and a radius of gyration equal
//! to the root mean square distance of the contacts from their centroid. Each r_i has a normal part r_n and a tangential part r_t, limited by the
//! friction coefficient μ. n are normals and G_i grasp maps. Bonded contacts and links, which neither open nor slide, allow no displacement at their
//! points.

use super::tolerances::NO_RIGID_MOTION;
use crate::contact::Law;
use crate::friction::FrictionProblem;
use crate::numerics::tolerances::LINEARLY_DEPENDENT;
use crate::numerics::{Reals, Vector, chosen, matrix_of, orthogonal_part, vector_of};
use crate::object::Problem;
use crate::prelude::*;

/// Upper limit of the number of coordinates of the bodies, and of the number of touching contacts. With more of them the motion of rigid bodies is
/// not computed, since the computation takes too long.
const MOST_RIGID: usize = 64;

/// The unit motion with which the object starts to move if no contact force counters the rate of the load. `rates` is the problem for the rates of
/// forces and motion. Contacts that stick with a force inside their cones are bonded in it.
///
/// `None` if no contact touches without force, or if one touches without force but cannot open. `None` also if a contact is on the boundary of its
/// cone with a force, or if a contact that touches without force has infinite friction. `None` also if a command changes, if the motion is zero, or
/// with more than [`MOST_RIGID`] coordinates or touching contacts.
pub(super) fn rigid_motion(rates: &Problem) -> Option<Vector> {
    if rates.wrench.as_slice().len() > MOST_RIGID || rates.offsets.iter().any(|offset| offset.norm() > 0.0) {
        return None;
    }
    // An orthonormal basis of the motions that bonded contacts and links resist.
    let mut resisted: Vec<Vector> = Vec::new();
    for (law, site) in rates.laws.iter().zip(rates.sites) {
        match law {
            Law::Bonded => {
                for axis in 0..site.springs.axes() {
                    resist(&mut resisted, &site.map.column(axis));
                }
            }
            Law::Absent | Law::Cone { gap: true } => {}
            Law::Cone { gap: false } | Law::Edge(_) => return None,
        }
    }
    let touches = |i: &usize| matches!(rates.laws[*i], Law::Cone { .. });
    let touching: Vec<usize> = chosen(rates.len(), &touches);
    let never_slides = |i: &usize| rates.local(*i).never_slides();
    if touching.is_empty() || touching.len() > MOST_RIGID || touching.iter().any(never_slides) {
        return None;
    }
    let load = orthogonal_part(rates.wrench.clone(), &resisted);
    let mut columns = Vec::new();
    let mut friction = Vec::new();
    for &i in &touching {
        let site = &rates.sites[i];
        (0..3).for_each(|axis| columns.push(orthogonal_part(site.map.column(axis), &resisted)));
        let slides_freely = rates.local(i).is_frictionless() || !site.springs.resists_tangentially();
        friction.push(if slides_freely { 0.0 } else { rates.local(i).cone().limit(1.0) });
    }
    // In the plane nothing moves along the second tangent, so that its row and column of `products` are zero. An entry of one on their diagonal keeps
    // the matrix regular, and makes friction along this tangent zero.
    let is_absent = |a: usize| a % 3 >= rates.space().axes();
    let products = matrix_of(columns.len(), columns.len(), &|a, b| {
        if a == b && is_absent(a) { 1.0 } else { columns[a].dot(&columns[b]) }
    });
    let driven = vector_of(columns.len(), &|a| columns[a].dot(&load));
    // Problems in the plane use the solver for space, too, because with a second instance of the solver, compiling it takes twice as long.
    let pushes = FrictionProblem::<3>::new(products, driven, friction).ok()?.solve();
    let pushes = pushes.solution()?;
    let motion = columns.iter().zip(pushes.r.iter()).fold(load.clone(), |v, (column, r)| v + column * *r);
    if motion.norm() > NO_RIGID_MOTION * load.norm() {
        return Some(motion.normalize());
    }
    // Near a limit load, contact forces almost balance the load, and the motion computed above is only rounding. The motion is then the
    // component of the load along the motions that the pressing contacts allow. In such a motion, contacts at their friction limit slide without
    // a normal velocity, and other pressing contacts stick.
    let largest = pushes.r.amax();
    for (k, &i) in touching.iter().enumerate() {
        let push = pushes.r.rows(3 * k, 3);
        // Contacts with less than this fraction of the largest force do not press. A pressing contact slides if its friction is within the same
        // fraction of its limit, the friction coefficient times the normal force.
        let near = 1e-6;
        if push[0] <= near * largest {
            continue;
        }
        let sideways = push.iter().skip(1).map(|x| x * x).added().sqrt();
        let slides = sideways >= rates.local(i).cone().limit(push[0]) * (1.0 - near);
        for column in &columns[3 * k..3 * k + if slides { 1 } else { 3 }] {
            resist(&mut resisted, column);
        }
    }
    let free = orthogonal_part(load.clone(), &resisted);
    (free.norm() > LINEARLY_DEPENDENT * load.norm()).then(|| free.normalize())
}

/// Adds the direction of `motion` to `basis`, an orthonormal basis of the motions that contacts resist, unless it depends linearly on the basis.
fn resist(basis: &mut Vec<Vector>, motion: &Vector) {
    let rest = orthogonal_part(motion.clone(), basis);
    // A motion counts as linearly dependent on the basis if removing its components along the basis leaves less than this fraction of its norm.
    if rest.norm() > 1e-9 * motion.norm() {
        basis.push(rest.normalize());
    }
}
