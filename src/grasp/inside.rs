//! Inside coordinates: moments and rotations about the centroid of the contact points, in their own
//! unit of length.
//!
//! Wrenches and twists of a question are moved there and those of an answer are moved back, so that
//! neither a far away reference point nor the unit of the user costs digits.

use nalgebra::SVector;

use super::engine::Engine;
use super::motion::Motion;
use super::rotation::{moved_twist, moved_wrench, of_the_object, planes};
use super::wrench::{Twist, Wrench};
use crate::error::Error;
use crate::numerics::DoubleDouble;

impl<const D: usize, const C: usize> Engine<D, C> {
    /// A checked wrench, moved to the centroid and to the inside unit of length.
    pub(crate) fn inside(&self, wrench: &Wrench<C>, what: &'static str) -> Result<SVector<f64, D>, Error> {
        wrench.check(what)?;
        Ok(self.inside_unchecked(wrench))
    }

    /// A wrench that was checked before, moved to the centroid and to the inside unit of length.
    pub(crate) fn inside_unchecked(&self, wrench: &Wrench<C>) -> SVector<f64, D> {
        self.per_length(moved_wrench::<D, C>(&-self.origin, &wrench.coordinates()))
    }

    /// What rounding takes from a wrench moved inside.
    pub(crate) fn inside_rest(&self, wrench: &Wrench<C>) -> SVector<f64, D> {
        let (w, inside) = (wrench.coordinates::<D>(), self.inside_unchecked(wrench));
        let mut rest = SVector::zeros();
        for (k, &(i, j)) in planes::<C>().iter().enumerate() {
            let mut moment = DoubleDouble::new(w[C + k]);
            moment.add_product(-self.origin[i], w[j]);
            moment.add_product(self.origin[j], w[i]);
            moment.add_product(-inside[C + k], self.length);
            rest[C + k] = moment.value() / self.length;
        }
        rest
    }

    /// Root mean square distance of the contact points from their centroid.
    pub(crate) fn length(&self) -> f64 {
        self.length
    }

    /// A wrench as the user sees it, from inside coordinates.
    pub(crate) fn wrench_outside(&self, w: &SVector<f64, D>) -> Wrench<C> {
        Wrench::among(&moved_wrench::<D, C>(&self.origin, &self.times_length(*w)))
    }

    /// All coordinates of a motion inside, from those that the user sees.
    pub(crate) fn inside_motion(&self, outside: &SVector<f64, D>) -> SVector<f64, D> {
        self.times_length(moved_twist::<D, C>(&-self.origin, outside))
    }

    /// A motion of the object as the user sees it, from inside coordinates.
    pub(crate) fn outside(&self, q: &SVector<f64, D>) -> Twist<C> {
        Twist::among(&self.outside_coordinates(q))
    }

    /// A motion of object and joints as the user sees it, from inside coordinates.
    pub(crate) fn motion_outside(&self, q: &SVector<f64, D>) -> Motion<C> {
        let outside = self.outside_coordinates(q);
        let joints = self.linkage().map_or(0, |linkage| linkage.joints.len());
        let joints = outside.iter().skip(of_the_object::<C>()).take(joints).copied().collect();
        Motion { object: Twist::among(&outside), joints }
    }

    /// All coordinates as the user sees them, those of drives that saturate behind the joints.
    pub(crate) fn outside_coordinates(&self, q: &SVector<f64, D>) -> SVector<f64, D> {
        moved_twist::<D, C>(&self.origin, &self.per_length(*q))
    }

    /// Angular components divided by the inside unit of length, those of joints by the lengths that measure them.
    fn per_length(&self, mut v: SVector<f64, D>) -> SVector<f64, D> {
        v.iter_mut().take(of_the_object::<C>()).skip(C).for_each(|x| *x /= self.length);
        if let Some(linkage) = self.linkage() {
            v.component_div_assign(&linkage.lengths);
        }
        v
    }

    /// Angular components times the inside unit of length, those of joints times the lengths that measure them.
    fn times_length(&self, mut v: SVector<f64, D>) -> SVector<f64, D> {
        v.iter_mut().take(of_the_object::<C>()).skip(C).for_each(|x| *x *= self.length);
        if let Some(linkage) = self.linkage() {
            v.component_mul_assign(&linkage.lengths);
        }
        v
    }
}
