//! The forces of all contacts of scenes side by side.

use super::lanes::Lanes;

/// A contact this close to the edge of its cone at factor zero, relative to the forces there, may
/// be on it. With a smaller part rounding would decide whether it sticks; with a larger one more
/// grasps would be unclear.
pub(super) const ON_THE_EDGE: f64 = 1e-12;

/// The forces of all contacts, or their rates; arrays run over the contacts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Forces<const C: usize, const N: usize, const L: usize> {
    pub(super) normal: [Lanes<L>; N],
    /// In space a vector across the normal, axis by axis; in the plane the first entry is that
    /// along (n_y, -n_x).
    pub(super) tangential: [[Lanes<L>; N]; C],
    /// What of them may be rounding.
    pub(super) rounding: [Lanes<L>; N],
    /// What part of the load they leave unbalanced; not a number if there are no such forces.
    pub(super) unbalanced: Lanes<L>,
    /// Positive if the load works on a motion that no contact resists.
    pub(super) free: Lanes<L>,
}

impl<const C: usize, const N: usize, const L: usize> Forces<C, N, L> {
    /// No forces.
    #[inline(always)]
    pub(super) fn none() -> Self {
        let zero = Lanes::ZERO;
        Self {
            normal: [zero; N],
            tangential: [[zero; N]; C],
            rounding: [zero; N],
            unbalanced: zero,
            free: zero,
        }
    }

    /// The tangential part at one contact.
    #[inline(always)]
    pub(super) fn friction(&self, contact: usize) -> [Lanes<L>; C] {
        let mut friction = [Lanes::ZERO; C];
        for axis in 0..C {
            friction[axis] = self.tangential[axis][contact];
        }
        friction
    }

    /// These forces and others together; the rounding of the others counts so many times.
    #[inline(always)]
    pub(super) fn with(&self, more: &Self, rounding: f64) -> Self {
        let mut sum = *self;
        for i in 0..N {
            sum.normal[i] += more.normal[i];
            sum.rounding[i] += Lanes::all(rounding) * more.rounding[i];
            for axis in 0..C {
                sum.tangential[axis][i] += more.tangential[axis][i];
            }
        }
        sum.unbalanced += more.unbalanced;
        sum.free += more.free;
        sum
    }
}
