//! Motion of the object and balance of forces in twice the working precision.
//!
//! The residual of a stiff spring is the difference of numbers 1e14 times as large. With G_i, W and q in twice the
//! working precision, solving again for the residual gives forces that are right to the last digit.

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

    /// Component k.
    #[inline(always)]
    fn at(&self, k: usize) -> DoubleDouble {
        DoubleDouble { high: self.high[k], low: self.low[k] }
    }

    #[inline(always)]
    fn set(&mut self, k: usize, x: DoubleDouble) {
        (self.high[k], self.low[k]) = (x.high, x.low);
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
        for (k, step) in step.iter().enumerate() {
            let mut q = self.0.at(k);
            q.add(*step);
            self.0.set(k, q);
        }
    }

    pub(crate) fn value(&self) -> Vector {
        self.0.value()
    }

    /// The difference to another twist.
    pub(super) fn less(mut self, other: &Self) -> Vector {
        for k in 0..other.0.high.len() {
            let mut q = self.0.at(k);
            q.subtract(other.0.at(k));
            self.0.set(k, q);
        }
        self.value()
    }

    /// `a - g·q` for column `axis` of the grasp map of a contact.
    pub(crate) fn stretch<const C: usize>(&self, site: &Site<C>, axis: usize, drive: f64) -> DoubleDouble {
        let (mut v, high, low) = (DoubleDouble::new(drive), self.0.high.as_slice(), self.0.low.as_slice());
        for range in site.support.ranges::<C>() {
            let (g, q) =
                (site.column_in_twice(axis, range.clone()), (&high[range.clone()], &low[range.clone()]));
            // The compiler knows the length for one object.
            match range.len() {
                3 => subtract_products(3, g, q, &mut v),
                6 => subtract_products(6, g, q, &mut v),
                n => subtract_products(n, g, q, &mut v),
            }
        }
        v
    }
}

/// Subtracts n products of numbers in twice the working precision, given by their high and their low parts.
#[inline(always)]
fn subtract_products(n: usize, g: (&[f64], &[f64]), q: (&[f64], &[f64]), v: &mut DoubleDouble) {
    let (g, q) = ((&g.0[..n], &g.1[..n]), (&q.0[..n], &q.1[..n]));
    for k in 0..n {
        v.add_product_of_twice((-g.0[k], -g.1[k]), DoubleDouble { high: q.0[k], low: q.1[k] });
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
        let (high, low) = (self.0.high.as_mut_slice(), self.0.low.as_mut_slice());
        for range in site.support.ranges::<C>() {
            let g = site.column_in_twice(axis, range.clone());
            let sums = (&mut high[range.clone()], &mut low[range.clone()]);
            match range.len() {
                3 => add_to_array::<3>(g, force, sums),
                6 => add_to_array::<6>(g, force, sums),
                _ => add_multiple(g, force, sums),
            }
        }
    }

    pub(super) fn value(&self) -> Vector {
        self.0.value()
    }
}

/// [`add_multiple`] of N numbers, by way of arrays of their own: the compiler then knows that they lie apart, and adds several at once.
#[inline(always)]
fn add_to_array<const N: usize>(g: (&[f64], &[f64]), times: DoubleDouble, sums: (&mut [f64], &mut [f64])) {
    let ([mut high, mut low], [mut g_high, mut g_low]) = ([[0.0; N]; 2], [[0.0; N]; 2]);
    high.copy_from_slice(sums.0);
    low.copy_from_slice(sums.1);
    g_high.copy_from_slice(g.0);
    g_low.copy_from_slice(g.1);
    add_multiple((&g_high, &g_low), times, (&mut high, &mut low));
    sums.0.copy_from_slice(&high);
    sums.1.copy_from_slice(&low);
}

/// Adds a multiple of numbers in twice the working precision.
#[inline(always)]
fn add_multiple(g: (&[f64], &[f64]), times: DoubleDouble, (high, low): (&mut [f64], &mut [f64])) {
    let n = high.len();
    let (g, low) = ((&g.0[..n], &g.1[..n]), &mut low[..n]);
    for k in 0..n {
        let mut sum = DoubleDouble { high: high[k], low: low[k] };
        sum.add_product_of_twice((g.0[k], g.1[k]), times);
        (high[k], low[k]) = (sum.high, sum.low);
    }
}
