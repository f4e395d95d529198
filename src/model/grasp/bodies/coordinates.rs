//! Conversion of loads and motions of several bodies between the engine's coordinates and the user's coordinates.
//!
//! In the user's coordinates moments and rotations refer to the origin of the scene. In the engine's coordinates those of a body refer to the
//! centroid of its contact points, and every angle is multiplied by a reference length. A load program is a sequence of ramps and turns of the loads.

use alloc::sync::Arc;

use nalgebra::SVector;

use super::body::{BodyLoad, BodyMotion};
use super::place::{BodyPlace, PlacedBodies};
use crate::error::Error;
use crate::grasp::engine::Engine;
use crate::grasp::wrench::{Twist, Wrench};
use crate::numerics::{IntoList, Size, Vector, chosen, indexed, mapped, paired};
use crate::prelude::*;

impl Engine {
    /// The bodies of the grasp; `None` for a single object.
    pub(crate) fn bodies(&self) -> Option<&PlacedBodies> {
        self.linkage()?.bodies.as_deref()
    }

    /// Sign with which the force of a contact acts on the object. With several bodies the object is the body on which the loads of questions act. The
    /// sign is 1 if the normal points into the object, -1 if the normal points out of the object, and 0 if the contact does not touch the object.
    pub(crate) fn sign_on_object(&self, contact: usize) -> f64 {
        self.bodies().map_or(1.0, |bodies| bodies.sign(contact, bodies.object))
    }

    /// The total load on each body: its constant load plus its part of `load`, the load that the caller asks about. For a single object the list
    /// holds only `load`.
    pub(crate) fn loads_of_bodies(&self, load: &Wrench<3>) -> Vec<Wrench<3>> {
        self.bodies().map_or_else(
            || vec![*load],
            |bodies| paired(&bodies.loads, &bodies.shared(load), &|(own, share)| *own + *share),
        )
    }

    /// Combines the wrenches on all bodies, in the user's coordinates, into one vector of generalised forces in the engine's coordinates. There the
    /// moments on each body refer to the centroid of its contact points and are divided by a reference length.
    pub(crate) fn combine_wrenches(&self, bodies: &PlacedBodies, loads: &[Wrench<3>]) -> Vector {
        let mut inside = Vector::zeros();
        for (body, (place, load)) in bodies.places.iter().zip(loads).enumerate() {
            if body == bodies.object {
                inside += self.on_object(load);
                continue;
            }
            let Some(linkage) = self.linkage() else { continue };
            let about_centre = self.space.moved_wrench(&-place.centre, &load.coordinates(self.space));
            for k in 0..self.space.of_the_object() {
                inside[place.first + k] = about_centre[k] / linkage.lengths[place.first + k];
            }
        }
        inside
    }

    /// The moments that a contact's `force` (N) with the lever arm `point` (m) exerts on each body, in the engine's coordinates; the components of
    /// forces are zero. If `point` is the rounding error of a contact point, the result is the error that it causes in the moments.
    pub(crate) fn moments_of(
        &self,
        contact: usize,
        point: &SVector<f64, 3>,
        force: &SVector<f64, 3>,
    ) -> Vector {
        let angular = self.space.axes()..self.space.of_the_object();
        if contact >= self.len() {
            // The force of a drive, the spring of a joint or tendon of a hand, acts on no body.
            return Vector::zeros();
        }
        let in_unit = self.space.wrench_of(&(point / self.length()), force);
        let mut moments = Vector::zeros();
        let Some((bodies, linkage)) = self.bodies().zip(self.linkage()) else {
            angular.for_each(|k| moments[k] = in_unit[k]);
            return moments;
        };
        let about_origin = self.space.wrench_of(point, force);
        for (body, place) in bodies.places.iter().enumerate() {
            let sign = bodies.sign(contact, body);
            for k in angular.clone() {
                let (row, is_object) = (place.first + k, body == bodies.object);
                let moment = if is_object { in_unit[k] } else { about_origin[k] / linkage.lengths[row] };
                moments[row] += sign * moment;
            }
        }
        moments
    }

    /// A grasp of the same bodies without constant loads, in which all loads grow from zero together. A load that is passed to the new grasp serves
    /// only as a factor f: its first force component in newtons. Each body then carries f times the sum of its constant load in this grasp and its
    /// share of `base`. `None` for a single object.
    pub(crate) fn growing_from_nothing(&self, base: &Wrench<3>) -> Option<Self> {
        let bodies = self.bodies()?;
        let shared = bodies.shared(base);
        let loads = bodies.loads.iter().zip(shared).map(|(own, base)| *own + base).list();
        Some(self.with_bodies(bodies.growing_together(loads)))
    }

    /// A copy of this grasp in which the loads `others` on named bodies grow in proportion to the load of a question. If the load of the question is
    /// `one`, they are equal to `others`; if it is a multiple of `one`, they are multiplied by the same factor.
    pub(crate) fn growing_together(
        &self,
        one: &Wrench<3>,
        others: &[(Arc<str>, Wrench<3>)],
    ) -> Result<Self, Error> {
        match (self.bodies(), others.first()) {
            (Some(bodies), _) => Ok(self.with_bodies(bodies.with_others_growing(one, others)?)),
            (None, None) => Ok(self.clone()),
            (None, Some((name, _))) => Err(no_body(name)),
        }
    }

    /// Index of the body with this name.
    ///
    /// # Errors
    /// [`Error::Body`] if there is no such body.
    pub(crate) fn body_called(&self, name: &Arc<str>) -> Result<usize, Error> {
        self.bodies().map_or_else(|| Err(no_body(name)), |bodies| bodies.called(name))
    }

    /// A copy of this grasp in which `loads`, one for each body, act in addition to the constant loads of the bodies. A load program has applied
    /// these loads up to one of its points. The grasp of a single object is copied unchanged.
    pub(crate) fn under_body_loads(&self, loads: Vec<Wrench<3>>) -> Self {
        self.bodies().map_or_else(|| self.clone(), |bodies| self.with_bodies(bodies.under(loads)))
    }

    /// A copy of this grasp in which `loads` act in addition to the constant loads of the bodies. Each entry of `loads` names its body. An answer
    /// about a point of a load program lists the loads that the program has applied to bodies. Further questions about this point are asked of the
    /// copy with these loads.
    pub(crate) fn with_body_loads(&self, loads: &[BodyLoad<3>]) -> Result<Self, Error> {
        let mut all = vec![Wrench::ZERO; self.bodies().map_or(0, |bodies| bodies.names.len())];
        for BodyLoad { body, load } in loads {
            load.check_in(self.space, "load of a body")?;
            all[self.body_called(body)?] = *load;
        }
        Ok(self.under_body_loads(all))
    }

    /// The nonzero loads that a load program has applied to bodies; empty for a single object.
    pub(crate) fn body_loads(&self) -> Vec<BodyLoad<3>> {
        let Some(bodies) = self.bodies() else { return Vec::new() };
        let loads = &bodies.program_loads;
        let loaded = chosen(loads.len(), &|body| loads[*body] != Wrench::ZERO);
        mapped(&loaded, &|body| BodyLoad { body: bodies.names[*body].clone(), load: loads[*body] })
    }

    /// Motion of each body in the user's coordinates. `outside` holds all coordinates of the grasp in the user's units, m and rad.
    pub(crate) fn body_motions(&self, outside: &Vector) -> Vec<BodyMotion<3>> {
        let Some(bodies) = self.bodies() else { return Vec::new() };
        let of = |(body, place): (usize, &BodyPlace)| {
            let twist = if body == bodies.object {
                Twist::among(self.space, outside)
            } else {
                // Components beyond the end of `outside` are zero, so it may have fewer components than the grasp has coordinates.
                let count = Size::of(self.space.of_the_object());
                let own = Vector::from_fn(count, |k| outside[place.first + k]);
                Twist::among(self.space, &self.space.moved_twist(&place.centre, &own))
            };
            BodyMotion {
                body: bodies.names[body].clone(),
                twist,
                centre: place.centre,
                reach: if place.rms_radius > 0.0 { place.rms_radius } else { 1.0 },
            }
        };
        indexed(&bodies.places, &of)
    }

    /// Motion of each body, or of the single object, in the user's coordinates. `inside` holds all coordinates in the engine's units, in which
    /// rotations are lengths.
    pub(crate) fn each_moves(&self, inside: &Vector) -> Vec<BodyMotion<3>> {
        let outside = self.outside_coordinates(inside);
        if self.bodies().is_some() {
            return self.body_motions(&outside);
        }
        let (twist, centre, reach) = (Twist::among(self.space, &outside), *self.origin(), self.length());
        vec![BodyMotion { body: "the object".into(), twist, centre, reach }]
    }

    /// For each coordinate of rotation of the bodies other than the object, the reference length, m, with which the engine multiplies the angle.
    pub(crate) fn rotation_lengths(&self, bodies: &PlacedBodies) -> Vec<f64> {
        let Some(linkage) = self.linkage() else { return Vec::new() };
        let mut lengths = Vec::new();
        for (body, place) in bodies.places.iter().enumerate() {
            if body != bodies.object {
                for k in self.space.axes()..self.space.of_the_object() {
                    lengths.push(linkage.lengths[place.first + k]);
                }
            }
        }
        lengths
    }

    /// A copy of `coordinates` in which all are zero except those of one body: the body into which the normal of `contact` points, or the single
    /// object. If `contact` is the index of a drive, the spring of a joint or tendon, all coordinates are kept.
    pub(crate) fn body_alone(&self, contact: usize, coordinates: &Vector) -> Vector {
        let Some(bodies) = self.bodies() else { return self.space.object_alone(coordinates) };
        let Some((on, _)) = bodies.sides.get(contact) else { return coordinates.clone() };
        let first = bodies.places[*on].first;
        let mut alone = coordinates.clone();
        let own = first..first + self.space.of_the_object();
        alone.iter_mut().enumerate().filter(|(k, _)| !own.contains(k)).for_each(|(_, x)| *x = 0.0);
        alone
    }
}

fn no_body(name: &Arc<str>) -> Error {
    let fault = "is to be loaded, and the scene has no bodies".to_owned();
    Error::Body { name: name.to_string(), fault }
}
