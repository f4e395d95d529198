//! Twist of the object and sum of forces and moments in twice the working precision.
//!
//! The residual of a stiff spring may be the difference of numbers 1e14 times as large. With grasp maps, load and twist in twice the working
//! precision, solving again for this residual gives forces that are correct to the last digit.

use crate::numerics::{DoubleDouble, Size, Vector, WHOLE};

use super::load::Load;
use crate::grasp::Site;

/// A vector in twice the working precision.
#[derive(Debug, Clone)]
struct Precise {
    high: Vector,
    low: Vector,
}

impl Precise {
    fn new(size: Size, mut high: Vector, mut low: Vector) -> Self {
        high.grow(size);
        low.grow(size);
        Self { high, low }
    }

    /// Component k in twice the working precision.
    #[inline(always)]
    fn at(&self, k: usize) -> DoubleDouble {
        DoubleDouble { high: self.high[k], low: self.low[k] }
    }

    #[inline(always)]
    fn set(&mut self, k: usize, x: DoubleDouble) {
        (self.high[k], self.low[k]) = (x.high, x.low);
    }

    /// The parts `high` and `low` as arrays of fixed size, for which the compiler makes faster code. `None` if there are more coordinates than those
    /// of one object.
    #[inline(always)]
    fn arrays(&self) -> Option<DoublePrecisionPair<'_>> {
        Some([self.high.array()?, self.low.array()?])
    }

    fn value(&self) -> Vector {
        &self.high + &self.low
    }
}

/// A twist in twice the working precision, since along a stiff spring a rounding error of the twist would be a large force.
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

    /// This twist minus `other`, rounded to working precision.
    pub(super) fn less(mut self, other: &Self) -> Vector {
        for k in 0..other.0.high.len() {
            let mut q = self.0.at(k);
            q.subtract(other.0.at(k));
            self.0.set(k, q);
        }
        self.value()
    }

    /// The stretch `offset - g·q` of a contact along its axis `axis`, for this twist q. Here g is the column of the contact's grasp map for this
    /// axis.
    pub(crate) fn stretch(&self, site: &Site, axis: usize, offset: f64) -> DoubleDouble {
        let v = DoubleDouble::new(offset);
        let of_one_object = site.whole_column_in_twice(axis);
        if let Some((column, q)) = of_one_object.zip(self.0.arrays()) {
            return if site.coordinates().count() <= 3 {
                less_products::<3>(v, column, q)
            } else {
                less_products::<6>(v, column, q)
            };
        }
        let mut v = v;
        for range in site.support.ranges() {
            let (g, rest) = site.column_in_twice(axis, range.clone());
            for (k, (g, rest)) in range.zip(g.iter().zip(rest)) {
                v.add_product_of_twice((-g, -rest), self.0.at(k));
            }
        }
        v
    }
}

/// The stretch `v - g·q` of a spring with offset v, in twice the working precision. g is the spring's column of a grasp map, and q the twist. The
/// scalar product has the first N components of `g` and `q`.
#[inline(always)]
fn less_products<const N: usize>(
    mut v: DoubleDouble,
    g: DoublePrecisionPair<'_>,
    q: DoublePrecisionPair<'_>,
) -> DoubleDouble {
    for k in 0..N {
        v.add_product_of_twice((-g[0][k], -g[1][k]), DoubleDouble { high: q[0][k], low: q[1][k] });
    }
    v
}

/// A vector in twice the working precision, the sum of two arrays `[high, low]`, with at most the coordinates of one object.
type DoublePrecisionPair<'v> = [&'v [f64; WHOLE]; 2];

/// The sum of the load and of contact forces, a wrench in twice the working precision; zero in equilibrium.
pub(super) struct PreciseBalance(Precise);

impl PreciseBalance {
    pub(super) fn new(size: Size, load: &Load) -> Self {
        Self(Precise::new(size, load.wrench.clone(), load.rounding_error.clone()))
    }

    /// Adds the wrench of a contact whose force along its axis `axis` is `force`, N.
    pub(super) fn add(&mut self, site: &Site, axis: usize, force: DoubleDouble) {
        let (high, low) = (&mut self.0.high, &mut self.0.low);
        let of_one_object = site.whole_column_in_twice(axis);
        if let (Some(g), Some(high), Some(low)) = (of_one_object, high.array_mut(), low.array_mut()) {
            if site.coordinates().count() <= 3 {
                add_multiple::<3>(g, force, high, low);
            } else {
                add_multiple::<6>(g, force, high, low);
            }
            return;
        }
        for range in site.support.ranges() {
            let (g, rest) = site.column_in_twice(axis, range.clone());
            for (k, (g, rest)) in range.zip(g.iter().zip(rest)) {
                let mut sum = self.0.at(k);
                sum.add_product_of_twice((*g, *rest), force);
                self.0.set(k, sum);
            }
        }
    }

    pub(super) fn value(&self) -> Vector {
        self.0.value()
    }
}

/// Adds `times · g` to the first N components of the vector `high + low`.
#[inline(always)]
fn add_multiple<const N: usize>(
    g: DoublePrecisionPair<'_>,
    times: DoubleDouble,
    high: &mut [f64; WHOLE],
    low: &mut [f64; WHOLE],
) {
    // Copies cannot overlap other data in memory, so that the compiler adds several components at once.
    let (mut new_high, mut new_low) = (*high, *low);
    for k in 0..N {
        let mut sum = DoubleDouble { high: new_high[k], low: new_low[k] };
        sum.add_product_of_twice((g[0][k], g[1][k]), times);
        (new_high[k], new_low[k]) = (sum.high, sum.low);
    }
    (*high, *low) = (new_high, new_low);
}
