//! The engine's coordinates, called inside coordinates. Moments and rotations of the object refer to the centroid of its contact points. Arms are
//! measured in units of the root mean square distance of these points from the centroid. Joints and other bodies have reference lengths of their own.
//!
//! Wrenches and twists that the caller passes are converted to these coordinates, and answers are converted back. Neither a distant origin nor the
//! user's unit of length thus costs digits.

use nalgebra::SVector;

use crate::numerics::{DoubleDouble, Vector, numbered};

use super::bodies::PlacedBodies;
use super::engine::Engine;
use super::motion::Motion;
use super::wrench::{Twist, Wrench};
use crate::error::Error;

impl Engine {
    /// Converts a wrench to the engine's coordinates: moments about the centroid, in the engine's unit of length. Returns an error for components
    /// that are not finite or too large; `what` names the wrench in the message.
    pub(crate) fn inside(&self, wrench: &Wrench<3>, what: &'static str) -> Result<Vector, Error> {
        wrench.check_in(self.space, what)?;
        Ok(self.inside_unchecked(wrench))
    }

    /// Converts a wrench to the engine's coordinates, as [`Self::inside`] does, but without checking its components.
    pub(crate) fn inside_unchecked(&self, wrench: &Wrench<3>) -> Vector {
        match self.bodies() {
            Some(bodies) if bodies.is_shared() => self.combine_wrenches(bodies, &bodies.shared(wrench)),
            _ => self.on_object(wrench),
        }
    }

    /// Converts a wrench on the object to the engine's coordinates: moments about the centroid of the contacts, with arms in the engine's unit of
    /// length. With several bodies the object is the body on which the loads of questions act.
    pub(crate) fn on_object(&self, wrench: &Wrench<3>) -> Vector {
        self.per_length(self.space.moved_wrench(&-self.origin, &wrench.coordinates(self.space)))
    }

    /// Rounding error of a wrench in the engine's coordinates: exact less rounded moments about the centroid of the contacts. If several bodies share
    /// the load, the error is not computed, and zero is returned.
    pub(crate) fn inside_rounding_error(&self, wrench: &Wrench<3>) -> Vector {
        let (w, inside) = (wrench.coordinates(self.space), self.inside_unchecked(wrench));
        let axes = self.space.axes();
        let mut rest = Vector::zeros();
        if self.bodies().is_some_and(PlacedBodies::is_shared) {
            return rest;
        }
        for (k, &(i, j)) in self.space.planes().iter().enumerate() {
            let mut moment = DoubleDouble::new(w[axes + k]);
            moment.add_product(-self.origin[i], w[j]);
            moment.add_product(self.origin[j], w[i]);
            moment.add_product(-inside[axes + k], self.length);
            rest[axes + k] = moment.value() / self.length;
        }
        rest
    }

    /// Centroid of the object's contact points, m: the reference point of moments and rotations in the engine's coordinates.
    pub(crate) fn origin(&self) -> &SVector<f64, 3> {
        &self.origin
    }

    /// Root mean square distance of the object's contact points from their centroid, m: the engine's unit of length for arms.
    pub(crate) fn length(&self) -> f64 {
        self.length
    }

    /// Converts a wrench in the engine's coordinates to moments about the user's origin. If several bodies share the load, the result is the sum of
    /// the wrenches on all of them.
    pub(crate) fn wrench_outside(&self, w: &Vector) -> Wrench<3> {
        let outside = self.times_length(w.clone());
        let on_object = Wrench::among(self.space, &self.space.moved_wrench(&self.origin, &outside));
        match self.bodies() {
            Some(bodies) if bodies.is_shared() => {
                bodies.others(&outside).fold(on_object, |sum, other| sum + other)
            }
            _ => on_object,
        }
    }

    /// Converts all coordinates of a motion from the user's units, about the user's origin, to the engine's, about the centroid of the contacts.
    pub(crate) fn inside_motion(&self, outside: &Vector) -> Vector {
        self.times_length(self.space.moved_twist(&-self.origin, outside))
    }

    /// Converts a motion of the object from the engine's coordinates to a twist about the user's origin, in m and rad.
    pub(crate) fn outside(&self, q: &Vector) -> Twist<3> {
        Twist::among(self.space, &self.outside_coordinates(q))
    }

    /// Converts a motion of object, joints and bodies from the engine's coordinates to the user's, in m and rad.
    pub(crate) fn motion_outside(&self, q: &Vector) -> Motion<3> {
        let outside = self.outside_coordinates(q);
        let joints = self.linkage().map_or(0, |linkage| linkage.joints.len());
        let joints = numbered(joints, &|joint| outside[self.space.of_the_object() + joint]);
        Motion { object: Twist::among(self.space, &outside), joints, bodies: self.body_motions(&outside) }
    }

    /// Converts all coordinates to the user's units, in the same order. They belong to the object, the joints and the other bodies. A drive (the
    /// spring of a joint or tendon) that yields at a constant force is modelled by two springs; the point between them has a coordinate, too.
    pub(crate) fn outside_coordinates(&self, q: &Vector) -> Vector {
        self.space.moved_twist(&self.origin, &self.per_length(q.clone()))
    }

    /// Divides angular components of the object by the engine's unit of length, and components of joints and other bodies by their reference lengths.
    fn per_length(&self, mut v: Vector) -> Vector {
        v.iter_mut().take(self.space.of_the_object()).skip(self.space.axes()).for_each(|x| *x /= self.length);
        if let Some(linkage) = self.linkage() {
            v.component_div_assign(&linkage.lengths);
        }
        v
    }

    /// Multiplies angular components of the object by the engine's unit of length, and components of joints and other bodies by their reference
    /// lengths.
    fn times_length(&self, mut v: Vector) -> Vector {
        v.iter_mut().take(self.space.of_the_object()).skip(self.space.axes()).for_each(|x| *x *= self.length);
        if let Some(linkage) = self.linkage() {
            v.component_mul_assign(&linkage.lengths);
        }
        v
    }
}
