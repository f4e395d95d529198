//! The same number of several scenes, side by side.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// One number of each of `L` scenes. Every operation is a loop over the lanes, which the compiler turns into vector instructions;
/// each lane is computed as if it stood alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lanes<const L: usize>(pub(super) [f64; L]);

impl<const L: usize> Default for Lanes<L> {
    #[inline(always)]
    fn default() -> Self {
        Self([0.0; L])
    }
}

impl<const L: usize> Lanes<L> {
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

impl<const L: usize> Add for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |x, y| x + y)
    }
}

impl<const L: usize> Sub for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |x, y| x - y)
    }
}

impl<const L: usize> Mul for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |x, y| x * y)
    }
}

impl<const L: usize> Div for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.zip(other, |x, y| x / y)
    }
}

impl<const L: usize> Neg for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}

impl<const L: usize> AddAssign for Lanes<L> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<const L: usize> SubAssign for Lanes<L> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

/// Scalar product.
#[inline(always)]
pub(super) fn dot<const L: usize, const C: usize>(a: &[Lanes<L>; C], b: &[Lanes<L>; C]) -> Lanes<L> {
    let mut sum = a[0] * b[0];
    for axis in 1..C {
        sum += a[axis] * b[axis];
    }
    sum
}
