//! A proof that no equilibrium exists near the point where an equilibrium was lost, for any slip history of the contacts.
//!
//! A virtual motion v of the object moves contact i by `u_i = G_iᵀv`, with the grasp map G_i. Equilibrium of the contact forces F_i under the load W
//! gives `W·v = -Σ F_i·u_i`. The negative work of a contact along v is at most its [`Resistance`]. This is a coefficient c_i times the normal stretch
//! if friction resists, or a row r_i times the stretch if only springs resist. Therefore the negative work of all contacts has an upper bound h that
//! depends only on the motion q of the object:
//!
//! ```text
//! W·v  <=  h(q) = Σ c_i (a_n,i - n·G_iᵀq)₊  +  Σ r_i·(a_i - G_iᵀq)
//! ```
//!
//! Here a_i are the commanded offsets (commanded displacements minus clearances and slips), n is the contact normal, and x₊ stands for max(x, 0). At
//! the lost equilibrium, with motion q*, contact i has the stretch vector v_i and the normal stretch x_i. (The stretches v_i are no parts of the
//! virtual motion v.) Since `x₊ = x + (-x)₊`, the bound at the motion `q* + δ` satisfies
//!
//! ```text
//! h  <=  Σ c_i x_i + Σ r_i·v_i  +  |(Σ c_i G_i n + Σ G_i r_i)·δ|  +  Σ c_i (|G_i n·δ| - x_i)₊
//! ```
//!
//! If this bound is below `W·v`, no equilibrium exists. In the term with δ outside the last sum, the contributions of contacts that press against
//! each other cancel. The bound then grows with |δ| only once one of these contacts opens.

use crate::contact::Resistance;
use crate::grasp::Space;
use crate::numerics::{Vector, increasing, mapped, summed, total, unit};
use crate::object::Problem;
use crate::prelude::*;

/// Returns a radius ρ, m, such that no equilibrium exists at motions `q* + δ` of the object with |δ| <= ρ. Such a δ moves the centroid of the
/// contacts by at most ρ. It turns the object by at most ρ divided by the root mean square distance of the contacts from the centroid, and moves each
/// further coordinate by at most ρ. q* is the argument `at`, and `motion` is the virtual motion v. Infinite if it is proved that no equilibrium
/// exists at all; `None` if nothing is proved even at q*.
pub(crate) fn nothing_near(problem: &Problem, at: &Vector, motion: &Vector) -> Option<f64> {
    let work = motion.dot(&problem.wrench);
    let mut size = motion.norm() * problem.wrench.norm();
    let mut resisted = 0.0;
    let mut slope = Vector::zeros();
    // A pair of numbers for each contact that may open. The first is the radius ρ at which the contact may first open; from there on the bound h on
    // negative work grows faster with ρ. The second is the increase of dh/dρ at this radius.
    let mut openings = Vec::new();
    for (i, (site, local)) in problem.sites.iter().zip(problem.locals()).enumerate() {
        let stretch = problem.stretch(i, at);
        let (terms, row) = match local.resistance(&site.map.tr_mul(motion)) {
            Resistance::Unlimited => return None,
            Resistance::ByFriction(0.0) => continue,
            Resistance::ByFriction(c) => {
                let largest_product = largest_product(site.space, &site.map.column(0));
                if largest_product > 0.0 {
                    openings.push((stretch[0].max(0.0) / largest_product, c * largest_product));
                }
                // `terms` below is negative for a contact that is open at the motion `at`. It is cancelled here, since an open contact does no
                // negative work there. If another motion closes the contact, its negative work is at most c times the distance by which it closes.
                resisted += c * (-stretch[0]).max(0.0);
                (c * stretch[0], unit::<3>(0) * c)
            }
            Resistance::BySprings(row) => (row.dot(&stretch), row),
        };
        resisted += terms;
        site.map.push(&row, &mut slope);
        size += row.norm() * site.span(&problem.offsets[i], at);
    }
    // Bound of the rounding error of a sum, relative to the sum of the absolute values of its terms. It includes the rounding of products and grasp
    // maps.
    let rounding = 64.0 * f64::EPSILON * (problem.len() as f64).max(8.0);
    let mut left = work - resisted - rounding * size;
    if left <= 0.0 {
        return None;
    }
    let (mut rho, mut growth) = (0.0, largest_product(problem.space(), &slope));
    for next in increasing(&mapped(&openings, &|(from, _)| *from)) {
        let (from, faster) = openings[next];
        if growth * (from - rho) >= left {
            break;
        }
        left -= growth * (from - rho);
        (rho, growth) = (from, growth + faster);
    }
    // Rounding of the sums above reduces the radius ρ, too.
    Some((rho + left / growth) * (1.0 - rounding))
}

/// The largest scalar product `row·δ` of a wrench with the displacements |δ| <= 1. The norm |δ| is the largest of three numbers: the norms of its
/// translation and of its rotation, and the largest absolute value of the further entries. The maximum is therefore the sum of the norms of the force
/// and of the moment of `row` and of the absolute values of its further entries.
fn largest_product(space: Space, row: &Vector) -> f64 {
    let (axes, object) = (space.axes(), space.of_the_object());
    let part = |from: usize, to: usize| total(to - from, &|k| row[from + k] * row[from + k]).sqrt();
    let joints = summed(row.as_slice().get(object..).unwrap_or_default(), &|x| x.abs());
    part(0, axes) + part(axes, object) + joints
}
