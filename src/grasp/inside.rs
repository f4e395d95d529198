//! Inside coordinates: moments and rotations about the centroid of the contact points, in their own
//! unit of length.
//!
//! Wrenches and twists of questions are converted to them, and answers are converted back. So neither a far reference point nor the user's unit of
//! length costs digits.

use nalgebra::SVector;

use crate::numerics::Vector;

use super::bodies::PlacedBodies;
use super::engine::Engine;
use super::motion::Motion;
use super::rotation::{moved_twist, moved_wrench, of_the_object, planes};
use super::wrench::{Twist, Wrench};
use crate::error::Error;
use crate::numerics::DoubleDouble;

impl<const C: usize> Engine<C> {
    /// A checked wrench, moved to the centroid and to the inside unit of length.
    pub(crate) fn inside(&self, wrench: &Wrench<C>, what: &'static str) -> Result<Vector, Error> {
        wrench.check(what)?;
        Ok(self.inside_unchecked(wrench))
    }

    /// A wrench that was checked before, moved to the centroid and to the inside unit of length.
    pub(crate) fn inside_unchecked(&self, wrench: &Wrench<C>) -> Vector {
        match self.bodies() {
            Some(bodies) if bodies.is_shared() => self.put_on_each(bodies, &bodies.shared(wrench)),
            _ => self.on_object(wrench),
        }
    }

    /// A wrench on the body in the coordinates of the object, in inside coordinates.
    pub(crate) fn on_object(&self, wrench: &Wrench<C>) -> Vector {
        self.per_length(moved_wrench::<C>(&-self.origin, &wrench.coordinates()))
    }

    /// Rounding of a wrench in inside coordinates: exact moments less rounded ones. It is zero where loads are shared among bodies.
    pub(crate) fn inside_rest(&self, wrench: &Wrench<C>) -> Vector {
        let (w, inside) = (wrench.coordinates(), self.inside_unchecked(wrench));
        let mut rest = Vector::zeros();
        if self.bodies().is_some_and(PlacedBodies::is_shared) {
            return rest;
        }
        for (k, &(i, j)) in planes::<C>().iter().enumerate() {
            let mut moment = DoubleDouble::new(w[C + k]);
            moment.add_product(-self.origin[i], w[j]);
            moment.add_product(self.origin[j], w[i]);
            moment.add_product(-inside[C + k], self.length);
            rest[C + k] = moment.value() / self.length;
        }
        rest
    }

    /// Centroid of the contact points.
    pub(crate) fn origin(&self) -> &SVector<f64, C> {
        &self.origin
    }

    /// Root mean square distance of the contact points from their centroid.
    pub(crate) fn length(&self) -> f64 {
        self.length
    }

    /// A wrench in the user's coordinates, from inside coordinates.
    pub(crate) fn wrench_outside(&self, w: &Vector) -> Wrench<C> {
        let outside = self.times_length(w.clone());
        let on_object = Wrench::among(&moved_wrench::<C>(&self.origin, &outside));
        match self.bodies() {
            Some(bodies) if bodies.is_shared() => {
                bodies.others(&outside).fold(on_object, |sum, other| sum + other)
            }
            _ => on_object,
        }
    }

    /// All coordinates of a motion, converted from the user's to inside coordinates.
    pub(crate) fn inside_motion(&self, outside: &Vector) -> Vector {
        self.times_length(moved_twist::<C>(&-self.origin, outside))
    }

    /// A motion of the object in the user's coordinates, from inside coordinates.
    pub(crate) fn outside(&self, q: &Vector) -> Twist<C> {
        Twist::among(&self.outside_coordinates(q))
    }

    /// A motion of object, joints and bodies in the user's coordinates, from inside coordinates.
    pub(crate) fn motion_outside(&self, q: &Vector) -> Motion<C> {
        let outside = self.outside_coordinates(q);
        let joints = self.linkage().map_or(0, |linkage| linkage.joints.len());
        let joints = (0..joints).map(|joint| outside[of_the_object::<C>() + joint]).collect();
        Motion { object: Twist::among(&outside), joints, bodies: self.body_motions(&outside) }
    }

    /// All coordinates in the user's units; coordinates of saturating drives come after the joints.
    pub(crate) fn outside_coordinates(&self, q: &Vector) -> Vector {
        moved_twist::<C>(&self.origin, &self.per_length(q.clone()))
    }

    /// Divides angular components by the inside unit of length, and components of joints by the lengths that measure them.
    fn per_length(&self, mut v: Vector) -> Vector {
        v.iter_mut().take(of_the_object::<C>()).skip(C).for_each(|x| *x /= self.length);
        if let Some(linkage) = self.linkage() {
            v.component_div_assign(&linkage.lengths);
        }
        v
    }

    /// Multiplies angular components by the inside unit of length, and components of joints by the lengths that measure them.
    fn times_length(&self, mut v: Vector) -> Vector {
        v.iter_mut().take(of_the_object::<C>()).skip(C).for_each(|x| *x *= self.length);
        if let Some(linkage) = self.linkage() {
            v.component_mul_assign(&linkage.lengths);
        }
        v
    }
}
