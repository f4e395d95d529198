//! A proof that nothing holds near where an equilibrium was lost, whatever has slipped before.
//!
//! For any virtual motion v with `u_i = G_iᵀv` balance gives `W·v = -Σ F_i·u_i`, and no contact does more against v than its
//! [`Resistance`]. Only the normal stretches enter, which the motion q of the object alone decides:
//!
//! ```text
//! W·v  <=  h(q) = Σ c_i (a_n,i - n·G_iᵀq)₊  +  Σ r_i·(a_i - G_iᵀq)
//! ```
//!
//! With `x₊ = x + (-x)₊` and `x_i` the stretch at q*, h grows from q* to `q* + δ` no further than to
//!
//! ```text
//! h  <=  Σ c_i x_i + Σ r_i·v_i  +  |(Σ c_i G_i n + Σ G_i r_i)·δ|  +  Σ c_i (|G_i n·δ| - x_i)₊
//! ```
//!
//! Where that stays below `W·v`, no equilibrium exists. Opposed contacts cancel in the sum: then nothing holds until one of them opens.

use crate::contact::Resistance;
use crate::grasp::of_the_object;
use crate::numerics::{Size, Vector, unit};
use crate::object::Problem;
use crate::prelude::*;

/// Sums of so many terms are off by this part of the sum of their sizes at most, products and maps that were rounded before included.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The largest ρ such that no equilibrium exists at any `q* + δ`, for δ up to ρ. Such a δ moves the centroid by at most ρ, turns the object by at most ρ over
/// the inside unit of length, and moves each further coordinate by at most ρ. Infinite where no equilibrium exists at all; `None` where nothing is proved even at q*.
pub(crate) fn nothing_near<D: Size, const C: usize>(
    problem: &Problem<D, C>,
    at: &Vector<D>,
    motion: &Vector<D>,
) -> Option<f64> {
    let work = motion.dot(&problem.wrench);
    let mut size = motion.norm() * problem.wrench.norm();
    let mut resisted = 0.0;
    let mut slope = Vector::<D>::zeros();
    // What opens on the way: from where on, and how much faster the bound grows from there.
    let mut openings = Vec::new();
    for (i, (site, local)) in problem.sites.iter().zip(problem.locals()).enumerate() {
        let stretch = problem.stretch(i, at);
        let (terms, row) = match local.resistance(&site.map.tr_mul(motion)) {
            Resistance::Unlimited => return None,
            Resistance::ByFriction(0.0) => continue,
            Resistance::ByFriction(c) => {
                let reach = reach::<D, C>(&site.map.column(0));
                if reach > 0.0 {
                    openings.push((stretch[0].max(0.0) / reach, c * reach));
                }
                // Open already, it adds nothing at q* and all that it closes by beyond.
                resisted += c * (-stretch[0]).max(0.0);
                (c * stretch[0], unit::<C>(0) * c)
            }
            Resistance::BySprings(row) => (row.dot(&stretch), row),
        };
        resisted += terms;
        site.map.push(&row, &mut slope);
        size += row.norm() * site.span(&problem.drives[i], at);
    }
    let rounding = ROUNDING * (problem.len() as f64).max(8.0);
    let mut left = work - resisted - rounding * size;
    if left <= 0.0 {
        return None;
    }
    openings.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut rho, mut growth) = (0.0, reach::<D, C>(&slope));
    for (from, faster) in openings {
        if growth * (from - rho) >= left {
            break;
        }
        left -= growth * (from - rho);
        (rho, growth) = (from, growth + faster);
    }
    // Rounding of the sums above takes its part of the radius, too.
    Some((rho + left / growth) * (1.0 - rounding))
}

/// The most that a row does along a δ of ρ = 1: the norms of what it has for translation and for rotation, and the sizes of all else.
fn reach<D: Size, const C: usize>(row: &Vector<D>) -> f64 {
    let object = of_the_object::<C>();
    let part = |from: usize, to: usize| (from..to).map(|k| row[k] * row[k]).sum::<f64>().sqrt();
    let joints = row.as_slice().iter().skip(object).map(|x| x.abs()).sum::<f64>();
    part(0, C) + part(C, object) + joints
}
