//! The margin of sticking at the contact that leaves its friction cone first, and the derivatives of this margin. In the code the point at which its
//! force leaves the cone is an edge. The load factor is the multiple of the growing load; at first slip the first contact ceases to stick. A command
//! is the displacement that a finger would make if there were no object.

use super::block::{Commanded, MOST_SCREENED, count};
use super::cone::StickingCone;
use super::forces::AnyForces;
use super::lanes::{Packed, dot};
use super::screened::Screened;
use crate::numerics::tolerances::NEGLIGIBLE;

/// The margin `m = α F_n - β |F_t|` of the contact that leaves its cone first, and its derivatives, at the load factor at which m vanishes. F_n is
/// the normal force and F_t the friction force. With friction, α is the coefficient and β is 1; [`StickingCone`] has the values for other contacts.
/// In arrays with one entry per contact, the entries of all other contacts are zero.
#[derive(Debug, Clone, Copy)]
pub(super) struct LeavingEdge<const C: usize, X: Packed> {
    /// The load factor at which the margin m of the first contact to leave its cone vanishes. NaN if no contact leaves its cone, which makes all
    /// derivatives of this factor NaN.
    pub(super) factor: X,
    /// The index, from 0, of the contact that leaves its cone; -1 if no contact leaves its cone.
    pub(super) contact: X,
    /// The derivative of the margin m with respect to the normal force of each contact. With this array and `tangential` as commands of the fingers,
    /// the springs are solved a second time ([`Self::probe`]). All derivatives of m follow from the resulting contact forces.
    normal: [X; MOST_SCREENED],
    /// The derivative of the margin m with respect to the tangential force of each contact, one array for each axis.
    tangential: [[X; MOST_SCREENED]; C],
    /// The derivative of the margin m with respect to each contact's coefficient of friction, N.
    pub(super) by_friction: [X; MOST_SCREENED],
    /// The derivative of the margin m with respect to the load factor, N.
    pub(super) rate: X,
    /// Positive if the load factor of first slip, the least over the contacts, has a kink at these data, so that derivatives are one-sided; else
    /// zero. There is a kink if several contacts leave their cones together, or if the friction force is zero.
    pub(super) kink: X,
}

impl<const C: usize, X: Packed> LeavingEdge<C, X> {
    /// All numbers zero, before [`Self::reach`] computes them.
    pub(super) fn none() -> Self {
        let zero = X::all(0.0);
        Self {
            factor: zero,
            contact: zero,
            normal: [zero; MOST_SCREENED],
            tangential: [[zero; MOST_SCREENED]; C],
            by_friction: [zero; MOST_SCREENED],
            rate: zero,
            kink: zero,
        }
    }

    /// Advances `forces` from load factor zero to the load factor at which the first contact leaves its cone, and computes the derivatives of a
    /// margin at this factor. The margin is that of contact `which`, or for `None` that of the first contact that leaves its cone. If contact `which`
    /// does not leave its cone at this factor, `self.factor` is NaN.
    #[inline(always)]
    pub(super) fn reach(
        &mut self,
        friction: &[X],
        (first, which): (X::Each<Screened>, Option<usize>),
        rates: &AnyForces<C, X>,
        forces: &mut AnyForces<C, X>,
    ) {
        let (zero, one) = (X::all(0.0), X::all(1.0));
        let first = first.as_ref();
        let chosen = |lane: usize| {
            let contact = first[lane].leaving().find(|i| which.is_none_or(|which| which == *i));
            contact.and_then(|i| u8::try_from(i).ok()).map_or(-1.0, f64::from)
        };
        let contact = X::of(X::each(chosen));
        self.contact = contact;
        self.factor =
            contact.above(X::all(-0.5), X::of(X::each(|lane| first[lane].0.code)), X::all(f64::NAN));
        self.rate = zero;
        self.kink = X::of(X::each(|lane| f64::from(u8::from(first[lane].leaving().count() > 1))));
        for i in 0..count(friction.len()) {
            let cone = StickingCone::of(friction[i]);
            let number = X::all(i as f64);
            let here = X::all(0.5).above((contact - number).abs(), one, zero);
            let (force, rate) = (&mut forces.of[i], &rates.of[i]);
            let mut size = force.normal.abs() + self.factor * rate.normal.abs();
            force.normal += self.factor * rate.normal;
            // In the plane only the first tangential entry is used.
            for axis in 0..if const { C == 2 } { 1 } else { C } {
                let changed = self.factor * rate.tangential[axis];
                size += force.tangential[axis].abs() + changed.abs();
                force.tangential[axis] += changed;
            }
            let t = cone.friction(force);
            let slides = dot(&t, &t).sqrt();
            let apart = slides.above(X::all(NEGLIGIBLE) * size, one, zero);
            let inverse = apart.above(zero, here / slides, zero);
            self.kink += here * (cone.beta - cone.beta * apart);
            self.normal[i] = here * cone.alpha;
            self.rate += self.normal[i] * rate.normal;
            for axis in 0..C {
                let along = -(inverse * t[axis]);
                self.tangential[axis][i] = along;
                self.rate += along * (cone.beta * rate.tangential[axis]);
            }
            self.by_friction[i] = here * cone.beta * force.normal;
        }
    }

    /// The derivatives of the margin with respect to the contact force, in the form of commands of the fingers. The caller solves the springs a
    /// second time, with these commands and no load. By reciprocity, the resulting contact forces are the derivatives of the margin with respect to
    /// the commands of the grasp.
    #[inline(always)]
    pub(super) fn probe(&self, contacts: usize) -> Commanded<'_, C, X> {
        let contacts = count(contacts);
        let mut sheared = [&self.normal[..contacts]; C];
        for axis in 0..C {
            sheared[axis] = &self.tangential[axis][..contacts];
        }
        Commanded { pressed: &self.normal[..contacts], sheared }
    }
}
