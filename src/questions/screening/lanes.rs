//! Vectors of numbers with one number ("lane") for each of several grasps. A block has the data of as many grasps as a vector has lanes; a batch
//! consists of blocks.
//!
//! With `simd` everything here is inlined into its callers. If a function were not inlined, it would be compiled for the instructions that every
//! processor has, not for the wider vectors of its caller. Without `simd` inlining only lengthens compilation.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use crate::numerics::square_root;

/// Number of lanes: the number of grasps of a batch that one vector, and so one block, holds side by side.
pub(super) const LANES: usize = if cfg!(feature = "simd") { 8 } else { 4 };

/// A number of one grasp, or a vector with one number for each of several grasps. The result in a lane does not depend on the other lanes.
pub(super) trait Packed:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
{
    /// A list with one value of type `T` for each lane.
    type Each<T: Copy>: Copy + AsRef<[T]>;

    /// The vector that has the number `value` in every lane.
    fn all(value: f64) -> Self;
    /// The list with one value for each lane: `of` computes it from the index of the lane.
    fn each<T: Copy>(of: impl FnMut(usize) -> T) -> Self::Each<T>;
    /// The vector of the numbers `numbers`, one for each lane.
    fn of(numbers: Self::Each<f64>) -> Self;
    /// The number in the lane with the index `lane`.
    fn lane(self, lane: usize) -> f64;
    fn abs(self) -> Self;
    fn sqrt(self) -> Self;
    /// The larger of the two numbers in each lane; `other` if one of them is NaN.
    fn max(self, other: Self) -> Self;
    /// The smaller of the two numbers in each lane; `other` if one of them is NaN.
    fn min(self, other: Self) -> Self;
    /// In each lane `yes` if this number is larger than `bound`, else `no`; also `no` if one of the two is NaN.
    fn above(self, bound: Self, yes: Self, no: Self) -> Self;

    /// Whether every lane equals `value`.
    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn is_all(self, value: f64) -> bool {
        Self::each(|lane| self.lane(lane) == value).as_ref().iter().all(|&is| is)
    }
}

impl Packed for f64 {
    type Each<T: Copy> = [T; 1];

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn all(value: f64) -> Self {
        value
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn each<T: Copy>(mut of: impl FnMut(usize) -> T) -> [T; 1] {
        [of(0)]
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn of([number]: [f64; 1]) -> Self {
        number
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn lane(self, _: usize) -> f64 {
        self
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn abs(self) -> Self {
        self.abs()
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn sqrt(self) -> Self {
        square_root(self)
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn above(self, bound: Self, yes: Self, no: Self) -> Self {
        if self > bound { yes } else { no }
    }
}

/// A vector of one number for each of [`LANES`] grasps. Every operation is a loop over the lanes, which the compiler turns into vector instructions.
/// The alignment keeps a vector of four numbers, or each half of a vector of eight, within one line of the cache.
#[derive(Debug, Clone, Copy)]
#[repr(align(32))]
pub(super) struct Lanes([f64; LANES]);

impl Lanes {
    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let mut out = self;
        for (x, y) in out.0.iter_mut().zip(other.0) {
            *x = f(*x, y);
        }
        out
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        self.zip(self, |x, _| f(x))
    }

    /// Sets the lanes from index `from` to the last one to `number`.
    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    pub(super) fn fill(&mut self, from: usize, number: f64) {
        self.0[from..].fill(number);
    }
}

impl Packed for Lanes {
    type Each<T: Copy> = [T; LANES];

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn all(value: f64) -> Self {
        Self([value; LANES])
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn each<T: Copy>(mut of: impl FnMut(usize) -> T) -> [T; LANES] {
        let mut all = [of(0); LANES];
        for lane in 1..LANES {
            all[lane] = of(lane);
        }
        all
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn of(numbers: [f64; LANES]) -> Self {
        Self(numbers)
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn lane(self, lane: usize) -> f64 {
        self.0[lane]
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn abs(self) -> Self {
        self.map(f64::abs)
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn sqrt(self) -> Self {
        self.map(square_root)
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn max(self, other: Self) -> Self {
        self.zip(other, |x, y| if x > y { x } else { y })
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn min(self, other: Self) -> Self {
        self.zip(other, |x, y| if x < y { x } else { y })
    }

    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn above(self, bound: Self, yes: Self, no: Self) -> Self {
        let mut out = self;
        for lane in 0..LANES {
            out.0[lane] = self.0[lane].above(bound.0[lane], yes.0[lane], no.0[lane]);
        }
        out
    }
}

macro_rules! lane_by_lane {
    ($operator:ident, $operate:ident, $symbol:tt) => {
        impl $operator for Lanes {
            type Output = Self;
            #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
            fn $operate(self, other: Self) -> Self {
                self.zip(other, |x, y| x $symbol y)
            }
        }
    };
}

macro_rules! in_place {
    ($operator:ident, $operate:ident, $symbol:tt) => {
        impl $operator for Lanes {
            #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
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

impl Neg for Lanes {
    type Output = Self;
    #[cfg_attr(not(feature = "simd"), inline)]
    #[cfg_attr(feature = "simd", inline(always))]
    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}

in_place!(AddAssign, add_assign, +);
in_place!(SubAssign, sub_assign, -);

#[inline]
pub(super) fn dot<X: Packed, const C: usize>(a: &[X; C], b: &[X; C]) -> X {
    let mut sum = a[0] * b[0];
    for axis in 1..C {
        sum += a[axis] * b[axis];
    }
    sum
}

/// The vector product `a × b` in space, in every lane.
#[inline(always)]
pub(super) fn cross<const C: usize, X: Packed>(a: &[X; C], b: &[X; C]) -> [X; C] {
    let mut product = *a;
    for axis in 0..C {
        let (next, last) = ((axis + 1) % C, (axis + 2) % C);
        product[axis] = a[next] * b[last] - a[last] * b[next];
    }
    product
}
