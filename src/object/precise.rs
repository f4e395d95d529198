//! Motion of the object and balance of forces in twice the working precision.
//!
//! What a stiff spring leaves of its equation is the difference of numbers 1e14 times as large as itself. With G_i, W and q to twice the
//! working precision, solving again for what is left gives forces that are right to the last digit.

use crate::numerics::{Size, Vector};

use super::load::Load;
use crate::grasp::Site;
use crate::numerics::DoubleDouble;

/// A vector in twice the working precision.
#[derive(Debug, Clone)]
struct Precise<D: Size> {
    high: Vector<D>,
    low: Vector<D>,
}

impl<D: Size> Precise<D> {
    #[inline(always)]
    fn at(&self, k: usize) -> DoubleDouble {
        DoubleDouble { high: self.high[k], low: self.low[k] }
    }

    #[inline(always)]
    fn change(&mut self, k: usize, by: impl FnOnce(&mut DoubleDouble)) {
        let mut x = self.at(k);
        by(&mut x);
        (self.high[k], self.low[k]) = (x.high, x.low);
    }

    fn value(&self) -> Vector<D> {
        let mut value = self.high.clone();
        value.iter_mut().enumerate().for_each(|(k, x)| *x = self.at(k).value());
        value
    }
}

/// A twist in twice the working precision: along a stiff spring its rounding would be a large force.
#[derive(Debug, Clone)]
pub(crate) struct PreciseTwist<D: Size>(Precise<D>);

impl<D: Size> PreciseTwist<D> {
    pub(crate) fn new(twist: Vector<D>) -> Self {
        Self(Precise { high: twist, low: Vector::zeros() })
    }

    pub(crate) fn add(&mut self, step: &Vector<D>) {
        for (k, step) in step.iter().enumerate() {
            self.0.change(k, |q| q.add(*step));
        }
    }

    pub(crate) fn value(&self) -> Vector<D> {
        self.0.value()
    }

    /// What is left when another twist is taken away.
    pub(super) fn less(mut self, other: &Self) -> Vector<D> {
        for k in 0..other.0.high.as_slice().len() {
            self.0.change(k, |q| q.subtract(other.0.at(k)));
        }
        self.value()
    }

    /// `a - g·q` for column `axis` of the grasp map of a contact.
    pub(crate) fn stretch<const C: usize>(&self, site: &Site<D, C>, axis: usize, drive: f64) -> DoubleDouble {
        let mut v = DoubleDouble::new(drive);
        for range in site.support.ranges::<C>() {
            for k in range {
                v.add_product_of_twice((-site.map[(k, axis)], -site.map_rest[(k, axis)]), self.0.at(k));
            }
        }
        v
    }
}

/// Forces and moments in twice the working precision.
pub(super) struct PreciseBalance<D: Size>(Precise<D>);

impl<D: Size> PreciseBalance<D> {
    pub(super) fn new(load: &Load<D>) -> Self {
        Self(Precise { high: load.wrench.clone(), low: load.rest.clone() })
    }

    /// Adds the wrench of a force along an axis of a contact.
    pub(super) fn add<const C: usize>(&mut self, site: &Site<D, C>, axis: usize, force: DoubleDouble) {
        for range in site.support.ranges::<C>() {
            for k in range {
                let g = (site.map[(k, axis)], site.map_rest[(k, axis)]);
                self.0.change(k, |sum| sum.add_product_of_twice(g, force));
            }
        }
    }

    pub(super) fn value(&self) -> Vector<D> {
        self.0.value()
    }
}
