//! Newton's method for balance, with any response of the contacts to a motion of the object.
//!
//! Given the twist q each contact's force is explicit, its state with it, so equilibrium is d equations, piecewise smooth:
//!
//! ```text
//! R(q) = Σ G_i F_i(a_i - G_iᵀq) + W = 0,      dR = -T dq,   T = Σ G_i C_i G_iᵀ
//! ```
//!
//! with the tangent stiffness C_i of each contact. A few steps suffice for any number of contacts. But the method may cycle, most often
//! with few contacts, where Lemke's method does not.

use nalgebra::SVector;

use super::tangent::TangentFactors;
use crate::grasp::Site;
use crate::numerics::Vector;
use crate::numerics::tolerances::SUFFICIENT_DECREASE;

/// R and the sizes of its terms.
#[derive(Debug, Clone, Default)]
pub(crate) struct Imbalance {
    pub(crate) left: Vector,
    pub(crate) size: f64,
}

impl Imbalance {
    /// The imbalance of forces and a load; `beside` adds to the sizes of the forces.
    pub(crate) fn of(sites: &[Site], forces: &[SVector<f64, 3>], load: &Vector, beside: f64) -> Self {
        let mut sum = Self { left: load.clone(), size: beside };
        sites.iter().zip(forces).for_each(|(site, force)| sum.add(site, force));
        sum
    }

    /// Adds the terms of a contact.
    pub(crate) fn add(&mut self, site: &Site, force: &SVector<f64, 3>) {
        site.map.push(force, &mut self.left);
        self.size += force.norm();
    }

    /// The sum of both.
    pub(crate) fn plus(self, other: Self) -> Self {
        Self { left: self.left + other.left, size: self.size + other.size }
    }
}

/// Contacts that respond to a motion of the object with forces.
pub(crate) trait StretchAnswers {
    /// The imbalance of their forces at a twist.
    fn answer(&mut self, twist: &Vector) -> Imbalance;

    /// T at the last twist; `None` where Newton's method should stop.
    fn tangent(&mut self) -> Option<TangentFactors>;
}

/// Newton's method from a twist until forces are out of balance by a part `settled` of their sizes. Returns the twist, the number of steps, and the
/// remaining imbalance. The contacts then hold their responses at that twist.
///
/// A step that does not reduce the imbalance enough is halved: otherwise the method jumps
/// to and fro between two states of a contact. Where no shorter step is better, the whole step is taken.
pub(crate) fn newton(
    contacts: &mut impl StretchAnswers,
    mut twist: Vector,
    settled: f64,
) -> Option<(Vector, usize, Imbalance)> {
    let mut here = contacts.answer(&twist);
    // Most Newton steps: the method converges in a few.
    for steps in 0..20 {
        let norm = here.left.norm();
        if norm <= settled * here.size {
            return Some((twist, steps, here));
        }
        if !norm.is_finite() {
            break;
        }
        let step = contacts.tangent()?.solve(&here.left);
        let mut next = contacts.answer(&(&twist + &step));
        let mut part = 1.0;
        // Sufficient decrease: a part of a step must reduce the imbalance by at least that part times this.
        // Least part of a step that is tried.
        let shortest = 1e-3;
        while next.left.norm() > (1.0 - SUFFICIENT_DECREASE * part) * norm && part > shortest {
            part *= 0.5;
            next = contacts.answer(&(&twist + &step * part));
        }
        if part <= shortest {
            part = 1.0;
            next = contacts.answer(&(&twist + &step));
        }
        twist += step * part;
        here = next;
    }
    None
}
