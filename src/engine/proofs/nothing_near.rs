//! A proof that no equilibrium exists near the point where one was lost, whatever the contacts have slipped.
//!
//! For any virtual motion v with `u_i = G_iᵀv`, equilibrium gives `W·v = -Σ F_i·u_i`. No contact works against v by more than its [`Resistance`],
//! which depends only on normal stretches, and so only on the motion q of the object:
//!
//! ```text
//! W·v  <=  h(q) = Σ c_i (a_n,i - n·G_iᵀq)₊  +  Σ r_i·(a_i - G_iᵀq)
//! ```
//!
//! With `x₊ = x + (-x)₊` and the stretch `x_i` at q*, the bound on h at `q* + δ` is
//!
//! ```text
//! h  <=  Σ c_i x_i + Σ r_i·v_i  +  |(Σ c_i G_i n + Σ G_i r_i)·δ|  +  Σ c_i (|G_i n·δ| - x_i)₊
//! ```
//!
//! If this bound is below `W·v`, no equilibrium exists. The terms of opposed contacts cancel in the sum; h then grows only once one of them opens.

use crate::contact::Resistance;
use crate::grasp::Space;
use crate::numerics::{Vector, increasing, mapped, unit};
use crate::object::Problem;
use crate::prelude::*;

/// The largest ρ for which it is proved that no equilibrium exists at any `q* + δ`, for δ up to ρ. Such a δ moves the centroid by at most ρ, and
/// turns the object by at most ρ over the engine's unit of length. It moves each further coordinate by at most ρ. Infinite if no equilibrium exists
/// at all; `None` if nothing is proved even at q*.
pub(crate) fn nothing_near(problem: &Problem, at: &Vector, motion: &Vector) -> Option<f64> {
    let work = motion.dot(&problem.wrench);
    let mut size = motion.norm() * problem.wrench.norm();
    let mut resisted = 0.0;
    let mut slope = Vector::zeros();
    // For each contact that may open: the ρ at which it may do so, and the increase of the bound's slope beyond this ρ.
    let mut openings = Vec::new();
    for (i, (site, local)) in problem.sites.iter().zip(problem.locals()).enumerate() {
        let stretch = problem.stretch(i, at);
        let (terms, row) = match local.resistance(&site.map.tr_mul(motion)) {
            Resistance::Unlimited => return None,
            Resistance::ByFriction(0.0) => continue,
            Resistance::ByFriction(c) => {
                let reach = reach(site.space, &site.map.column(0));
                if reach > 0.0 {
                    openings.push((stretch[0].max(0.0) / reach, c * reach));
                }
                // The formula adds a negative term for a contact that is open at q*. It is cancelled here: an open contact resists nothing at q*, and
                // away from q* at most c times the distance by which it closes.
                resisted += c * (-stretch[0]).max(0.0);
                (c * stretch[0], unit::<3>(0) * c)
            }
            Resistance::BySprings(row) => (row.dot(&stretch), row),
        };
        resisted += terms;
        site.map.push(&row, &mut slope);
        size += row.norm() * site.span(&problem.offsets[i], at);
    }
    // Bound of the rounding of a sum, relative to the sum of the sizes of its terms. It includes the rounding of products and maps.
    let rounding = 64.0 * f64::EPSILON * (problem.len() as f64).max(8.0);
    let mut left = work - resisted - rounding * size;
    if left <= 0.0 {
        return None;
    }
    let (mut rho, mut growth) = (0.0, reach(problem.space(), &slope));
    for next in increasing(&mapped(&openings, &|(from, _)| *from)) {
        let (from, faster) = openings[next];
        if growth * (from - rho) >= left {
            break;
        }
        left -= growth * (from - rho);
        (rho, growth) = (from, growth + faster);
    }
    // Rounding of the sums above reduces the radius, too.
    Some((rho + left / growth) * (1.0 - rounding))
}

/// The largest product of a row with a displacement δ of size 1: the sum of the norms of its translation and rotation parts and the sizes of all
/// other entries.
fn reach(space: Space, row: &Vector) -> f64 {
    let (axes, object) = (space.axes(), space.of_the_object());
    let part = |from: usize, to: usize| (from..to).map(|k| row[k] * row[k]).sum::<f64>().sqrt();
    let joints = row.as_slice().iter().skip(object).map(|x| x.abs()).sum::<f64>();
    part(0, axes) + part(axes, object) + joints
}
