//! Motion of the object and balance of forces in twice the working precision.
//!
//! The residual of a stiff spring is the difference of numbers 1e14 times as large. With G_i, W and q in twice the
//! working precision, solving again for the residual gives forces that are right to the last digit.

use core::ops::Range;

use crate::numerics::{Size, Vector};

use super::load::Load;
use crate::grasp::Site;
use crate::numerics::DoubleDouble;

/// A vector in twice the working precision.
#[derive(Debug, Clone)]
struct Precise {
    high: Vector,
    low: Vector,
}

impl Precise {
    fn new(size: Size, mut high: Vector, mut low: Vector) -> Self {
        high.reach(size);
        low.reach(size);
        Self { high, low }
    }

    /// The components within a range.
    #[inline(always)]
    fn within(&self, range: Range<usize>) -> impl Iterator<Item = DoubleDouble> {
        let (high, low) = (&self.high.as_slice()[range.clone()], &self.low.as_slice()[range]);
        high.iter().zip(low).map(|(&high, &low)| DoubleDouble { high, low })
    }

    /// Changes the components within a range, each by an entry of `by`.
    #[inline(always)]
    fn change<X>(
        &mut self,
        range: Range<usize>,
        by: impl Iterator<Item = X>,
        how: impl Fn(&mut DoubleDouble, X),
    ) {
        let (high, low) = (&mut self.high.as_mut_slice()[range.clone()], &mut self.low.as_mut_slice()[range]);
        for ((high, low), by) in high.iter_mut().zip(low).zip(by) {
            let mut x = DoubleDouble { high: *high, low: *low };
            how(&mut x, by);
            (*high, *low) = (x.high, x.low);
        }
    }

    fn value(&self) -> Vector {
        &self.high + &self.low
    }
}

/// A twist in twice the working precision: along a stiff spring its rounding would be a large force.
#[derive(Debug, Clone)]
pub(crate) struct PreciseTwist(Precise);

impl PreciseTwist {
    pub(crate) fn new(size: Size, twist: Vector) -> Self {
        Self(Precise::new(size, twist, Vector::zeros()))
    }

    pub(crate) fn add(&mut self, step: &Vector) {
        let step = step.as_slice();
        self.0.change(0..step.len(), step.iter(), |q, step| q.add(*step));
    }

    pub(crate) fn value(&self) -> Vector {
        self.0.value()
    }

    /// The difference to another twist.
    pub(super) fn less(mut self, other: &Self) -> Vector {
        let all = 0..other.0.high.as_slice().len();
        self.0.change(all.clone(), other.0.within(all), DoubleDouble::subtract);
        self.value()
    }

    /// `a - g·q` for column `axis` of the grasp map of a contact.
    pub(crate) fn stretch<const C: usize>(&self, site: &Site<C>, axis: usize, drive: f64) -> DoubleDouble {
        let mut v = DoubleDouble::new(drive);
        for range in site.support.ranges::<C>() {
            for ((g, rest), q) in site.column_in_twice(axis, range.clone()).zip(self.0.within(range)) {
                v.add_product_of_twice((-g, -rest), q);
            }
        }
        v
    }
}

/// Forces and moments in twice the working precision.
pub(super) struct PreciseBalance(Precise);

impl PreciseBalance {
    pub(super) fn new(size: Size, load: &Load) -> Self {
        Self(Precise::new(size, load.wrench.clone(), load.rest.clone()))
    }

    /// Adds the wrench of a force along an axis of a contact.
    pub(super) fn add<const C: usize>(&mut self, site: &Site<C>, axis: usize, force: DoubleDouble) {
        for range in site.support.ranges::<C>() {
            let column = site.column_in_twice(axis, range.clone());
            self.0.change(range, column, |sum, g| sum.add_product_of_twice(g, force));
        }
    }

    pub(super) fn value(&self) -> Vector {
        self.0.value()
    }
}
