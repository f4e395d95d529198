//! The forces of all contacts, one scene in each lane.

use super::block::{MOST_SCREENED, count};
use super::finger::Force;
use super::lanes::Packed;

/// The forces of all contacts, or their rates, with room for five of them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Forces<const C: usize, X: Packed> {
    pub(super) of: [Force<C, X>; MOST_SCREENED],
    /// Bound of the rounding of each force, N.
    pub(super) rounding: [X; MOST_SCREENED],
    /// The part of the load that the forces leave unbalanced; NaN if there are no such forces.
    pub(super) unbalanced: X,
    /// Positive if the load works on a motion that no contact resists.
    pub(super) free: X,
}

impl<const C: usize, X: Packed> Forces<C, X> {
    /// Zero forces without rounding.
    pub(super) fn none() -> Self {
        let zero = X::all(0.0);
        Self {
            of: [Force { normal: zero, tangential: [zero; C] }; MOST_SCREENED],
            rounding: [zero; MOST_SCREENED],
            unbalanced: zero,
            free: zero,
        }
    }

    /// Adds the forces `others` of `contacts` contacts to these; the rounding of these is multiplied by `rounding` first.
    #[inline(always)]
    pub(super) fn add_to(&mut self, contacts: usize, others: &Self, rounding: f64) {
        for i in 0..count(contacts) {
            let (sum, other) = (&mut self.of[i], &others.of[i]);
            sum.normal = other.normal + sum.normal;
            for axis in 0..C {
                sum.tangential[axis] = other.tangential[axis] + sum.tangential[axis];
            }
            self.rounding[i] = others.rounding[i] + X::all(rounding) * self.rounding[i];
        }
        self.unbalanced = others.unbalanced + self.unbalanced;
        self.free = others.free + self.free;
    }
}
