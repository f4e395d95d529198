//! The contact forces of several grasps while every contact sticks, one grasp in each lane of a vector.

use super::block::{Layout, MOST_SCREENED};
use super::finger::Force;
use super::lanes::Packed;

/// The forces of all contacts, or their derivatives with respect to the load factor. The array has room for five contacts by default, or for as many
/// as the array type `A` holds.
#[derive(Debug, Clone, Copy)]
pub(super) struct Forces<const C: usize, X: Packed, A: ?Sized = [Force<C, X>; MOST_SCREENED]> {
    /// The load that the contact forces leave unbalanced, relative to the forces and moments that act; NaN if no forces were found.
    pub(super) unbalanced: X,
    /// Positive if the load does positive work along a motion that no contact resists; else zero.
    pub(super) free: X,
    /// The motion of the object about the centroid of its contacts from which these forces follow. Zero unless the forces were computed from
    /// stiffnesses, with the motion as the unknown ([`Method::Motions`](super::method::Method::Motions)).
    pub(super) motion: [X; 6],
    pub(super) of: A,
}

/// The forces of any number of contacts. Functions that compute forces take this type, so that they are compiled once for all numbers of contacts.
pub(super) type AnyForces<const C: usize, X> = Forces<C, X, [Force<C, X>]>;

impl<const C: usize, X: Packed, const M: usize> Forces<C, X, [Force<C, X>; M]> {
    /// Zero forces, without rounding error.
    pub(super) fn none() -> Self {
        let zero = X::all(0.0);
        Self { unbalanced: zero, free: zero, motion: [zero; 6], of: [Force::none(); M] }
    }
}

impl<const C: usize, X: Packed> AnyForces<C, X> {
    /// Copies `others`, forces of as many contacts, into these forces.
    #[inline(always)]
    pub(super) fn copy_from(&mut self, others: &Self) {
        (self.unbalanced, self.free, self.motion) = (others.unbalanced, others.free, others.motion);
        self.of.copy_from_slice(&others.of);
    }

    /// Sets all forces, their rounding bounds and the motion to zero.
    #[inline(always)]
    pub(super) fn clear(&mut self) {
        let zero = X::all(0.0);
        (self.unbalanced, self.free, self.motion) = (zero, zero, [zero; 6]);
        self.of.fill(Force::none());
    }

    /// Adds the forces `others` of the first `contacts` contacts to these forces. The bounds of rounding errors are added, too; those of these forces
    /// (not of `others`) are first multiplied by `rounding`.
    #[inline(always)]
    pub(super) fn add_to(&mut self, contacts: usize, others: &Self, rounding: f64) {
        for (sum, other) in self.of.iter_mut().zip(&others.of).take(contacts) {
            sum.normal = other.normal + sum.normal;
            for axis in 0..C {
                sum.tangential[axis] = other.tangential[axis] + sum.tangential[axis];
            }
            sum.rounding = other.rounding + X::all(rounding) * sum.rounding;
        }
        for k in 0..Layout::<C>::COORDINATES {
            self.motion[k] += others.motion[k];
        }
        self.unbalanced = others.unbalanced + self.unbalanced;
        self.free = others.free + self.free;
    }

    /// Multiplies the rounding bounds of all forces by a factor.
    #[inline(always)]
    pub(super) fn scale_rounding(&mut self, factor: f64) {
        for force in &mut self.of {
            force.rounding = X::all(factor) * force.rounding;
        }
    }
}
