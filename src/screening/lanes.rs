//! One number of each of several scenes, side by side.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// One number of each of `L` scenes. Every operation is a loop over the lanes, which the compiler
/// turns into vector instructions; each lane is computed as if it stood alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lanes<const L: usize>(pub(super) [f64; L]);

impl<const L: usize> Lanes<L> {
    pub(super) const ZERO: Self = Self([0.0; L]);

    #[inline(always)]
    pub(super) fn all(value: f64) -> Self {
        Self([value; L])
    }

    #[inline(always)]
    pub(super) fn map(self, f: impl Fn(f64) -> f64) -> Self {
        let mut out = self;
        for x in &mut out.0 {
            *x = f(*x);
        }
        out
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let mut out = self;
        for (x, y) in out.0.iter_mut().zip(other.0) {
            *x = f(*x, y);
        }
        out
    }

    #[inline(always)]
    pub(super) fn abs(self) -> Self {
        self.map(f64::abs)
    }

    #[inline(always)]
    pub(super) fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }

    /// The larger; the second where they do not compare.
    #[inline(always)]
    pub(super) fn max(self, other: Self) -> Self {
        self.zip(other, |x, y| if x > y { x } else { y })
    }

    /// The smaller; the second where they do not compare.
    #[inline(always)]
    pub(super) fn min(self, other: Self) -> Self {
        self.zip(other, |x, y| if x < y { x } else { y })
    }

    /// `yes` where this is larger than `bound`, else `no`, also where they do not compare.
    #[inline(always)]
    pub(super) fn above(self, bound: Self, yes: Self, no: Self) -> Self {
        let mut out = self;
        for lane in 0..L {
            out.0[lane] = if self.0[lane] > bound.0[lane] { yes.0[lane] } else { no.0[lane] };
        }
        out
    }
}

macro_rules! lane_by_lane {
    ($operator:ident, $operate:ident, $symbol:tt) => {
        impl<const L: usize> $operator for Lanes<L> {
            type Output = Self;
            #[inline(always)]
            fn $operate(self, other: Self) -> Self {
                self.zip(other, |x, y| x $symbol y)
            }
        }
    };
}

macro_rules! in_place {
    ($operator:ident, $operate:ident, $symbol:tt) => {
        impl<const L: usize> $operator for Lanes<L> {
            #[inline(always)]
            fn $operate(&mut self, other: Self) {
                *self = *self $symbol other;
            }
        }
    };
}

lane_by_lane!(Add, add, +);
lane_by_lane!(Sub, sub, -);
lane_by_lane!(Mul, mul, *);
lane_by_lane!(Div, div, /);

impl<const L: usize> Neg for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}

in_place!(AddAssign, add_assign, +);
in_place!(SubAssign, sub_assign, -);

/// Scalar product.
#[inline(always)]
pub(super) fn dot<const L: usize, const C: usize>(a: &[Lanes<L>; C], b: &[Lanes<L>; C]) -> Lanes<L> {
    let mut sum = a[0] * b[0];
    for axis in 1..C {
        sum += a[axis] * b[axis];
    }
    sum
}
