//! Newton's method for equilibrium. The force of each contact is a function of its own stretch alone, and the stretch follows from the twist of
//! the object.
//!
//! The twist q gives each contact its stretch `a_i - G_iᵀq`, from the offset a_i (commanded displacement minus clearance and slip) and the grasp map
//! G_i. The stretch gives the contact force F_i and the contact state. Equilibrium under the load W is therefore a system of d piecewise smooth
//! equations, one for each coordinate of the twist:
//!
//! ```text
//! R(q) = Σ G_i F_i(a_i - G_iᵀq) + W = 0,      dR = -T dq,   T = Σ G_i C_i G_iᵀ
//! ```
//!
//! with the tangent stiffness C_i of each contact. As a rule a few Newton steps are enough for any number of contacts. But the method may cycle, most
//! often with few contacts; Lemke's method does not.

use core::ops::Range;

use nalgebra::SVector;

use super::problem::Problem;
use crate::contact::ContactResponse;
use crate::grasp::Site;
use crate::numerics::tolerances::SUFFICIENT_DECREASE;
use crate::numerics::{Vector, in_halves};
use crate::prelude::*;

/// The imbalance of contact forces and load.
#[derive(Debug, Clone, Default)]
pub(crate) struct Imbalance {
    /// The residual wrench `R = Σ G_i F_i + W` of the contact forces F_i with grasp maps G_i and the load W.
    pub(crate) left: Vector,
    /// Sum of the norms of the contact forces, N, and of other forces that the caller adds, such as the load. The rounding error of `left` is
    /// proportional to it.
    pub(crate) size: f64,
}

impl Imbalance {
    /// The imbalance of contact forces and a load. Its `size` is the sum of the norms of the contact forces plus `beside`, N. The caller may
    /// pass the norm of the load as `beside`; it is not included otherwise.
    pub(crate) fn of(sites: &[Site], forces: &[SVector<f64, 3>], load: &Vector, beside: f64) -> Self {
        let mut sum = Self { left: load.clone(), size: beside };
        sites.iter().zip(forces).for_each(|(site, force)| sum.add(site, force));
        sum
    }

    fn add(&mut self, site: &Site, force: &SVector<f64, 3>) {
        site.map.push(force, &mut self.left);
        self.size += force.norm();
    }

    /// The imbalance of two groups of contacts together: this imbalance is that of one group, `other` that of the other group.
    fn plus(self, other: Self) -> Self {
        Self { left: self.left + other.left, size: self.size + other.size }
    }
}

/// The law by which a contact responds. It returns force and state from the contact's index, its stretch, and its last response, from which an
/// iteration may start.
pub(super) type Response<'r> =
    dyn Fn(usize, &SVector<f64, 3>, &ContactResponse) -> ContactResponse + Sync + 'r;

/// The response of a contact according to its law in `problem`. Its elastic force, which its springs would have if it stuck, is mapped back onto the
/// friction cone (return map).
pub(super) fn on_cones(
    problem: &Problem,
) -> impl Fn(usize, &SVector<f64, 3>, &ContactResponse) -> ContactResponse + Sync {
    |i, stretch, last| {
        let near = last.state.slide().map_or(0.0, |slide| slide.lambda);
        problem.local(i).response(stretch, near)
    }
}

/// Newton's method ([`newton`]) from the twist `twist` with the laws of `problem`. The force of each contact is its elastic force, which its springs
/// would have if it stuck, mapped back onto its friction cone. Contacts may take any state.
pub(crate) fn newton_on_cones(
    problem: &Problem,
    (twist, settled): (Vector, f64),
    contacts: &mut Vec<ContactResponse>,
) -> Option<(Vector, usize, Imbalance)> {
    newton(problem, (twist, settled, f64::MIN_POSITIVE), contacts, &on_cones(problem))
}

/// Newton's method from the twist `twist`. It ends when the norm of the imbalance is at most the fraction `settled` of a sum of forces, N. The sum
/// has the norms of all contact forces, the norm of the load, and `beside`. An imbalance up to `settled * beside` is thus accepted even if all forces
/// are zero, because it may be rounding. Returns the twist, the number of steps, and the remaining imbalance; `None` if the iteration does not
/// converge. The list `contacts` is overwritten, and finally holds the responses at the returned twist.
///
/// A step that does not reduce the norm of the imbalance enough is halved: otherwise the method may alternate between two states of a contact. If no
/// shorter step reduces the norm enough, the whole step is taken.
pub(crate) fn newton(
    problem: &Problem,
    (mut twist, settled, beside): (Vector, f64, f64),
    contacts: &mut Vec<ContactResponse>,
    response: &Response<'_>,
) -> Option<(Vector, usize, Imbalance)> {
    contacts.clear();
    contacts.resize(problem.len(), ContactResponse::open());
    let mut response_at = respond(problem, (&twist, beside), contacts, response);
    // Upper limit of the number of Newton steps. As a rule Newton's method converges in a few steps, or not at all.
    for steps in 0..20 {
        let norm = response_at.left.norm();
        if norm <= settled * response_at.size {
            return Some((twist, steps, response_at));
        }
        if !norm.is_finite() {
            break;
        }
        let step = problem.tangent_factors(&|i| contacts[i].state).solve(&response_at.left);
        let mut at = |part: f64| respond(problem, (&(&twist + &step * part), beside), contacts, response);
        let (mut part, mut next) = (1.0, at(1.0));
        // A Newton step is halved at most until the fraction `shortest` of it is left. The fraction p of a step is accepted if it reduces the norm of
        // the imbalance to at most `1 - p SUFFICIENT_DECREASE` times its present value.
        let shortest = 1e-3;
        while next.left.norm() > (1.0 - SUFFICIENT_DECREASE * part) * norm && part > shortest {
            part *= 0.5;
            next = at(part);
        }
        if part <= shortest {
            part = 1.0;
            next = at(part);
        }
        twist += step * part;
        response_at = next;
    }
    None
}

/// Writes the response of each contact to a twist into `contacts`. Returns the imbalance of contact forces and load. Its field `size` is the sum of
/// the norms of all contact forces, the norm of the load, and `beside`, N.
pub(super) fn respond(
    problem: &Problem,
    (twist, beside): (&Vector, f64),
    contacts: &mut [ContactResponse],
    response: &Response<'_>,
) -> Imbalance {
    let part = |(range, contacts): (Range<usize>, &mut [ContactResponse])| {
        let mut sum = Imbalance::default();
        for (i, contact) in range.zip(contacts) {
            *contact = response(i, &problem.stretch(i, twist), contact);
            if !contact.state.is_open() {
                sum.add(&problem.sites[i], &contact.force);
            }
        }
        sum
    };
    in_halves((0..contacts.len(), contacts), &part, &Imbalance::plus)
        .plus(Imbalance { left: problem.wrench.clone(), size: problem.wrench.norm() + beside })
}
