//! Motion of the object and balance of forces in twice the working precision.
//!
//! What a stiff spring leaves of its equation is the difference of numbers 1e14 times as large as itself. With G_i, W and q to twice the
//! working precision, solving again for what is left gives forces that are right to the last digit.

use nalgebra::SVector;

use super::load::Load;
use crate::grasp::Site;
use crate::numerics::DoubleDouble;

/// A twist in twice the working precision: along a stiff spring its rounding would be a large force.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PreciseTwist<const D: usize>([DoubleDouble; D]);

impl<const D: usize> PreciseTwist<D> {
    pub(crate) fn new(twist: SVector<f64, D>) -> Self {
        Self(std::array::from_fn(|k| DoubleDouble::new(twist[k])))
    }

    pub(crate) fn add(&mut self, step: &SVector<f64, D>) {
        for (q, step) in self.0.iter_mut().zip(step.iter()) {
            q.add(*step);
        }
    }

    pub(crate) fn value(&self) -> SVector<f64, D> {
        SVector::from(self.0.map(DoubleDouble::value))
    }

    /// What is left when another twist is taken away.
    pub(super) fn less(mut self, other: &Self) -> SVector<f64, D> {
        for (q, other) in self.0.iter_mut().zip(other.0) {
            q.subtract(other);
        }
        self.value()
    }

    /// `a - g·q` for column `axis` of the grasp map of a contact.
    pub(crate) fn stretch<const C: usize>(&self, site: &Site<D, C>, axis: usize, drive: f64) -> DoubleDouble {
        let mut v = DoubleDouble::new(drive);
        for range in site.support.ranges::<C>() {
            for k in range {
                v.add_product_of_twice((-site.map[(k, axis)], -site.map_rest[(k, axis)]), self.0[k]);
            }
        }
        v
    }
}

/// Forces and moments in twice the working precision.
pub(super) struct PreciseBalance<const D: usize>([DoubleDouble; D]);

impl<const D: usize> PreciseBalance<D> {
    pub(super) fn new(load: &Load<D>) -> Self {
        Self(std::array::from_fn(|k| DoubleDouble { high: load.wrench[k], low: load.rest[k] }))
    }

    /// Adds the wrench of a force along an axis of a contact.
    pub(super) fn add<const C: usize>(&mut self, site: &Site<D, C>, axis: usize, force: DoubleDouble) {
        for range in site.support.ranges::<C>() {
            for k in range {
                self.0[k].add_product_of_twice((site.map[(k, axis)], site.map_rest[(k, axis)]), force);
            }
        }
    }

    pub(super) fn value(&self) -> SVector<f64, D> {
        SVector::from(self.0.map(DoubleDouble::value))
    }
}
