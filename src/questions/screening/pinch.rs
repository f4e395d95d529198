//! Two contacts in space do not resist the rotation about the line between them. This file exchanges coordinates of the object so that the pivot of
//! this rotation is the last one when the stiffness matrix is factorised.
//!
//! That pivot vanishes up to rounding. If the rotation about the coordinate axis nearest to the line comes last, no other pivot is small. Thus not
//! rounding but the geometry determines which motion is taken as without resistance.

use super::lanes::Packed;
use crate::numerics::Each;

/// The exchange of two rotations in each lane: the rotation about the coordinate axis nearest to the line between two contacts becomes the last
/// coordinate.
#[derive(Debug, Clone, Copy)]
pub(super) struct AlongTheLine<X: Packed> {
    /// The first entry is one if the coordinate axis nearest to the line is x, the second entry if it is y; otherwise they are zero.
    is: [X; 2],
}

impl<X: Packed> AlongTheLine<X> {
    /// Finds, for each grasp, the coordinate axis nearest to the line between its two contacts. The rotation about this axis is to become the last
    /// coordinate.
    #[inline(always)]
    pub(super) fn between<const C: usize>(points: &[&[X]; C]) -> Self {
        let (zero, one) = (X::all(0.0), X::all(1.0));
        let [x, y, z] = [0, 1, 2 % C].each(|axis| (points[axis][1] - points[axis][0]).abs());
        let is_x = y.max(z).above(x, zero, one);
        Self { is: [is_x, z.above(y, zero, one - is_x)] }
    }

    /// Exchanges two rotations in the stiffness matrix t: about the coordinate axis nearest to the line, and about the last axis. Only entries on and
    /// below the diagonal of t are stored.
    #[inline(always)]
    pub(super) fn exchange(&self, t: &mut [[X; 6]; 6]) {
        for (k, is) in (3..).zip(self.is) {
            for other in 0..LAST {
                let [a, b] = if other == k {
                    [[k, k], [LAST, LAST]]
                } else {
                    [[k.max(other), k.min(other)], [LAST, other]]
                };
                let (one, two) = (t[a[0]][a[1]], t[b[0]][b[1]]);
                t[a[0]][a[1]] = is.above(X::all(0.0), two, one);
                t[b[0]][b[1]] = is.above(X::all(0.0), one, two);
            }
        }
    }

    /// A load or a motion with two rotations (or moments) exchanged, about the coordinate axis nearest to the line and about the last axis. A second
    /// exchange restores it.
    #[inline(always)]
    pub(super) fn exchanged(&self, w: &[X; 6]) -> [X; 6] {
        let mut exchanged = *w;
        for (k, is) in (3..).zip(self.is) {
            let (one, two) = (exchanged[k], exchanged[LAST]);
            exchanged[k] = is.above(X::all(0.0), two, one);
            exchanged[LAST] = is.above(X::all(0.0), one, two);
        }
        exchanged
    }
}

const LAST: usize = 5;
