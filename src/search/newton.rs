//! Newton's method on the return map, every contact free to change its state.
//!
//! Given the twist q each contact's force is explicit (`contact/answer`), so equilibrium is d equations
//!
//! ```text
//! R(q) = Σ G_i F_i(a_i - G_iᵀq) + W = 0,      dR = -(Σ G_i C_i G_iᵀ) dq
//! ```
//!
//! piecewise smooth, with the tangent stiffness C_i of each contact.

use nalgebra::SVector;

use crate::contact::Answer;
use crate::numerics::Factors;
use crate::object::{Problem, tangent_stiffness};

/// Newton's steps: it converges in a few of them or goes round in circles.
const STEPS: usize = 20;
/// A step must take away this part of the share of the imbalance that its length promises.
const GAIN: f64 = 0.1;
/// Shorter parts of a step than this are not tried.
const SHORTEST: f64 = 1e-3;
/// What is left out of balance where Newton's method ends, as a part of the forces: steps on the pieces do the rest.
const SETTLED: f64 = 1e-9;
/// Nearer than this the tangent stiffness of the step before serves again, as long as each step leaves at most a part `FASTER`.
const NEAR: f64 = 1e-7;
const FASTER: f64 = 1e-2;

/// Where Newton's method has arrived.
#[derive(Debug, Clone)]
pub(super) struct Arrived<const D: usize, const C: usize> {
    pub(super) twist: SVector<f64, D>,
    /// What each contact answers there.
    pub(super) contacts: Vec<Answer<C>>,
}

/// Newton's method until forces settle. A step that leaves more out of balance than before is halved: without that it jumps
/// to and fro between two states of a contact. Where no shorter one does better the whole one is made.
pub(super) fn newton<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    mut twist: SVector<f64, D>,
) -> Option<Arrived<D, C>> {
    let mut contacts = vec![Answer::open(); problem.len()];
    let mut tangents = Vec::with_capacity(problem.len());
    let mut here = imbalance(problem, &twist, &mut contacts);
    let mut tangent: Option<Factors<D>> = None;
    let mut before = f64::INFINITY;
    for _ in 0..STEPS {
        if here.norm <= SETTLED * here.size {
            return Some(Arrived { twist, contacts });
        }
        let serves_again = here.norm <= NEAR * here.size && here.norm <= FASTER * before;
        let again = tangent.filter(|_| serves_again);
        let current = again.unwrap_or_else(|| {
            tangents.clear();
            tangents.extend(
                contacts.iter().zip(problem.locals()).map(|(at, local)| local.tangent(&at.state).matrix()),
            );
            Factors::new(&tangent_stiffness(problem.sites, &tangents))
        });
        let step = current.solve(&here.left);
        tangent = Some(current);
        before = here.norm;
        let mut next = imbalance(problem, &(twist + step), &mut contacts);
        let mut part = 1.0;
        while next.norm > (1.0 - GAIN * part) * here.norm && part > SHORTEST {
            part *= 0.5;
            next = imbalance(problem, &(twist + step * part), &mut contacts);
        }
        if part <= SHORTEST {
            part = 1.0;
            next = imbalance(problem, &(twist + step), &mut contacts);
        }
        twist += step * part;
        here = next;
        if !here.norm.is_finite() {
            return None;
        }
    }
    None
}

/// R(q) and the sizes of its terms.
struct Imbalance<const D: usize> {
    left: SVector<f64, D>,
    norm: f64,
    size: f64,
}

fn imbalance<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    twist: &SVector<f64, D>,
    contacts: &mut [Answer<C>],
) -> Imbalance<D> {
    let (mut left, mut size) = (problem.wrench, problem.wrench.norm());
    for (i, contact) in contacts.iter_mut().enumerate() {
        let near = contact.state.slide().map_or(0.0, |slide| slide.lambda);
        *contact = problem.local(i).answer(&problem.stretch(i, twist), near);
        if !contact.state.is_open() {
            left += problem.sites[i].map * contact.force;
            size += contact.force.norm();
        }
    }
    Imbalance { left, norm: left.norm(), size }
}
