//! What a solution of a piece leaves of its equations, in twice the working precision.
//!
//! ```text
//! e_r = right_r · (a_i - G_iᵀ q) - x_r,      ρ = Σ G_i left_r x_r + W
//! ```
//!
//! Of a stiff spring e_r is the difference of numbers 1e14 times as large as itself. With G_i, W and q to twice the working
//! precision, too, solving again for what is left gives forces that are right to the last digit, unless errors grow by
//! 1e16 in the piece.

use nalgebra::SVector;

use super::problem::Load;
use super::spring::Spring;
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
            q.add(-other.high);
            q.add(-other.low);
        }
        self.value()
    }

    /// `a - g·q` for column `axis` of the grasp map of a contact.
    pub(crate) fn stretch<const C: usize>(&self, site: &Site<D, C>, axis: usize, drive: f64) -> DoubleDouble {
        let mut v = DoubleDouble::new(drive);
        for (k, q) in self.0.iter().enumerate() {
            v.add_product_of_twice((-site.map[(k, axis)], -site.map_rest[(k, axis)]), *q);
        }
        v
    }
}

/// Forces and moments in twice the working precision.
pub(super) struct Balance<const D: usize>([DoubleDouble; D]);

impl<const D: usize> Balance<D> {
    pub(super) fn new(load: &Load<D>) -> Self {
        Self(std::array::from_fn(|k| DoubleDouble { high: load.wrench[k], low: load.rest[k] }))
    }

    /// Adds the wrench of a force along an axis of a contact.
    pub(super) fn add<const C: usize>(&mut self, site: &Site<D, C>, axis: usize, force: DoubleDouble) {
        for (k, sum) in self.0.iter_mut().enumerate() {
            sum.add_product_of_twice((site.map[(k, axis)], site.map_rest[(k, axis)]), force);
        }
    }

    pub(super) fn value(&self) -> SVector<f64, D> {
        SVector::from(self.0.map(DoubleDouble::value))
    }
}

/// Writes e, spring by spring, and returns ρ. The springs of a contact follow each other.
pub(super) fn excess<const D: usize, const C: usize>(
    springs: &[Spring<C>],
    sites: &[Site<D, C>],
    (drives, load): (&[SVector<f64, C>], &Load<D>),
    (x, twist): (&[f64], &PreciseTwist<D>),
    e: &mut [f64],
) -> SVector<f64, D> {
    let mut balance = Balance::new(load);
    let mut first = 0;
    for of_contact in springs.chunk_by(|a, b| a.contact == b.contact) {
        let contact = of_contact[0].contact;
        let site = &sites[contact];
        // A contact has at most C springs.
        let mut left = [DoubleDouble::default(); C];
        for ((left, _), x) in left.iter_mut().zip(of_contact).zip(&x[first..]) {
            left.add(-x);
        }
        for a in 0..C {
            if of_contact.iter().any(|spring| spring.right[a] != 0.0) {
                let v = twist.stretch(site, a, drives[contact][a]);
                for (left, spring) in left.iter_mut().zip(of_contact) {
                    left.add_product_of_twice((spring.right[a], spring.right_rest[a]), v);
                }
            }
            let mut force = DoubleDouble::default();
            for (spring, &x) in of_contact.iter().zip(&x[first..]) {
                force.add_product_of_twice((spring.left[a], spring.left_rest[a]), DoubleDouble::new(x));
            }
            if force.high != 0.0 {
                balance.add(site, a, force);
            }
        }
        for ((e, left), _) in e[first..].iter_mut().zip(left).zip(of_contact) {
            *e = left.value();
        }
        first += of_contact.len();
    }
    balance.value()
}
