//! Newton's method for balance, whatever the contacts answer to a motion of the object.
//!
//! Given the twist q each contact's force is explicit, its state with it, so equilibrium is d equations, piecewise smooth:
//!
//! ```text
//! R(q) = Σ G_i F_i(a_i - G_iᵀq) + W = 0,      dR = -T dq,   T = Σ G_i C_i G_iᵀ
//! ```
//!
//! with the tangent stiffness C_i of each contact. A few steps do at any number of contacts, but the method may go round in circles, most often
//! with few contacts, where Lemke's method does not.

use nalgebra::SVector;

use super::tangent::TangentFactors;
use crate::grasp::Site;
use crate::numerics::{Size, Vector};

/// Newton's steps: it converges in a few of them.
const STEPS: usize = 20;
/// A step must take away this part of the share of the imbalance that its length promises.
const GAIN: f64 = 0.1;
/// Shorter parts of a step than this are not tried.
const SHORTEST: f64 = 1e-3;

/// R and the sizes of its terms.
#[derive(Debug, Clone, Default)]
pub(crate) struct Imbalance<D: Size> {
    pub(crate) left: Vector<D>,
    pub(crate) size: f64,
}

impl<D: Size> Imbalance<D> {
    /// That of forces and a load, with this beside the sizes of the forces.
    pub(crate) fn of<const C: usize>(
        sites: &[Site<D, C>],
        forces: &[SVector<f64, C>],
        load: &Vector<D>,
        beside: f64,
    ) -> Self {
        let mut sum = Self { left: load.clone(), size: beside };
        sites.iter().zip(forces).for_each(|(site, force)| sum.add(site, force));
        sum
    }

    /// Adds the terms of a contact.
    pub(crate) fn add<const C: usize>(&mut self, site: &Site<D, C>, force: &SVector<f64, C>) {
        site.map.push(force, &mut self.left);
        self.size += force.norm();
    }

    /// That of both together.
    pub(crate) fn plus(self, other: Self) -> Self {
        Self { left: self.left + other.left, size: self.size + other.size }
    }
}

/// Contacts that answer a motion of the object with forces.
pub(crate) trait StretchAnswers<D: Size> {
    /// Their answers to a twist.
    fn answer(&mut self, twist: &Vector<D>) -> Imbalance<D>;

    /// T where they were last asked; `None` where Newton's method should not go on with it.
    fn tangent(&mut self) -> Option<TangentFactors<D>>;
}

/// Newton's method from a twist until forces are out of balance by a part `settled` of their sizes: the twist, how many steps it took, and what is
/// left. The answers there are those that the contacts gave last.
///
/// A step that leaves more out of balance than before is halved: without that the method jumps
/// to and fro between two states of a contact. Where no shorter one does better the whole one is made.
pub(crate) fn newton<D: Size>(
    contacts: &mut impl StretchAnswers<D>,
    mut twist: Vector<D>,
    settled: f64,
) -> Option<(Vector<D>, usize, Imbalance<D>)> {
    let mut here = contacts.answer(&twist);
    for steps in 0..STEPS {
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
        while next.left.norm() > (1.0 - GAIN * part) * norm && part > SHORTEST {
            part *= 0.5;
            next = contacts.answer(&(&twist + &step * part));
        }
        if part <= SHORTEST {
            part = 1.0;
            next = contacts.answer(&(&twist + &step));
        }
        twist += step * part;
        here = next;
    }
    None
}
