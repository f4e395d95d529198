//! Loads and motions of several bodies, converted between inside coordinates and the user's.

use alloc::sync::Arc;

use nalgebra::SVector;

use super::body::{BodyLoad, BodyMotion};
use super::place::{BodyPlace, PlacedBodies};
use crate::error::Error;
use crate::grasp::engine::Engine;
use crate::grasp::rotation::{moved_twist, moved_wrench, object_alone, of_the_object, wrench_of};
use crate::grasp::wrench::{Twist, Wrench};
use crate::numerics::Vector;
use crate::prelude::*;

impl<const C: usize> Engine<C> {
    /// The bodies, if there are several.
    pub(crate) fn bodies(&self) -> Option<&PlacedBodies<C>> {
        self.linkage()?.bodies.as_deref()
    }

    /// Sign, 1, -1 or 0, with which the force of a contact acts on the body in the coordinates of the object.
    pub(crate) fn sign_on_object(&self, contact: usize) -> f64 {
        self.bodies().map_or(1.0, |bodies| bodies.sign(contact, bodies.object))
    }

    /// The wrenches of one load on each body, in inside coordinates.
    pub(crate) fn put_on_each(&self, bodies: &PlacedBodies<C>, loads: &[Wrench<C>]) -> Vector {
        let mut inside = Vector::zeros();
        for (body, (place, load)) in bodies.places.iter().zip(loads).enumerate() {
            if body == bodies.object {
                inside += self.on_object(load);
                continue;
            }
            let Some(linkage) = self.linkage() else { continue };
            let about_centre = moved_wrench::<C>(&-place.centre, &load.coordinates());
            for (k, x) in Wrench::<C>::among(&about_centre).components().iter().enumerate() {
                inside[place.first + k] = x / linkage.lengths[place.first + k];
            }
        }
        inside
    }

    /// Moments about the origin of a contact's `force` at `point`, in inside coordinates; the components of the force itself are zero. They measure
    /// how rounding of the contact point acts on rotations.
    pub(crate) fn moments_of(
        &self,
        contact: usize,
        point: &SVector<f64, C>,
        force: &SVector<f64, C>,
    ) -> Vector {
        let object = of_the_object::<C>();
        if contact >= self.len() {
            // A drive acts on no body.
            return Vector::zeros();
        }
        let in_unit = wrench_of::<C>(&(point / self.length()), force);
        let mut moments = Vector::zeros();
        let Some((bodies, linkage)) = self.bodies().zip(self.linkage()) else {
            (C..object).for_each(|k| moments[k] = in_unit[k]);
            return moments;
        };
        let about_origin = wrench_of::<C>(point, force);
        for (body, place) in bodies.places.iter().enumerate() {
            let sign = bodies.sign(contact, body);
            for k in C..object {
                let (row, is_object) = (place.first + k, body == bodies.object);
                let moment = if is_object { in_unit[k] } else { about_origin[k] / linkage.lengths[row] };
                moments[row] += sign * moment;
            }
        }
        moments
    }

    /// These bodies under loads that grow from zero, per newton of a question's force along the first axis: the constant loads plus the shares of
    /// `base`. No constant load remains. `None` for a single object.
    pub(crate) fn growing_from_nothing(&self, base: &Wrench<C>) -> Option<Self> {
        let bodies = self.bodies()?;
        let shared = bodies.shared(base);
        let loads = bodies.loads.iter().zip(shared).map(|(own, base)| *own + base).collect();
        Some(self.with_bodies(bodies.growing_together(loads)))
    }

    /// [`Grasp::growing_together`](crate::ask::Grasp::growing_together).
    pub(crate) fn growing_together(
        &self,
        one: &Wrench<C>,
        others: &[(Arc<str>, Wrench<C>)],
    ) -> Result<Self, Error> {
        match (self.bodies(), others.first()) {
            (Some(bodies), _) => Ok(self.with_bodies(bodies.with_others_growing(one, others)?)),
            (None, None) => Ok(self.clone()),
            (None, Some((name, _))) => Err(no_body(name)),
        }
    }

    /// Number of the body with this name, for a load on it.
    ///
    /// # Errors
    /// [`Error::Body`] if there is no such body.
    pub(crate) fn body_called(&self, name: &Arc<str>) -> Result<usize, Error> {
        self.bodies().map_or_else(|| Err(no_body(name)), |bodies| bodies.called(name))
    }

    /// These bodies with the loads that a load program has applied, one for each body.
    pub(crate) fn under_body_loads(&self, loads: Vec<Wrench<C>>) -> Self {
        self.bodies().map_or_else(|| self.clone(), |bodies| self.with_bodies(bodies.under(loads)))
    }

    /// These bodies with the body loads of an answer applied again, for further questions about it.
    pub(crate) fn with_body_loads(&self, loads: &[BodyLoad<C>]) -> Result<Self, Error> {
        let mut all = vec![Wrench::ZERO; self.bodies().map_or(0, |bodies| bodies.names.len())];
        for BodyLoad { body, load } in loads {
            load.check("load of a body")?;
            all[self.body_called(body)?] = *load;
        }
        Ok(self.under_body_loads(all))
    }

    /// Loads that a load program has applied to bodies, zeros left out.
    pub(crate) fn body_loads(&self) -> Vec<BodyLoad<C>> {
        let Some(bodies) = self.bodies() else { return Vec::new() };
        let named = bodies.names.iter().zip(&bodies.put_on).filter(|(_, load)| **load != Wrench::ZERO);
        named.map(|(body, load)| BodyLoad { body: body.clone(), load: *load }).collect()
    }

    /// Motion of each body in the user's coordinates, from all coordinates in the user's units.
    pub(crate) fn body_motions(&self, outside: &Vector) -> Vec<BodyMotion<C>> {
        let Some(bodies) = self.bodies() else { return Vec::new() };
        let of = |(body, place): (usize, &BodyPlace<C>)| {
            let twist = if body == bodies.object {
                Twist::among(outside)
            } else {
                // Components behind the end of the vector are zero.
                let own: Vec<f64> = (0..of_the_object::<C>()).map(|k| outside[place.first + k]).collect();
                let about_centre = Twist::<C>::from_components(&own).coordinates();
                Twist::among(&moved_twist::<C>(&place.centre, &about_centre))
            };
            BodyMotion { body: bodies.names[body].clone(), twist, centre: place.centre, reach: place.reach }
        };
        bodies.places.iter().enumerate().map(of).collect()
    }

    /// Motion of each body in the user's coordinates, from inside coordinates; that of the object if there are no bodies.
    pub(crate) fn each_moves(&self, inside: &Vector) -> Vec<BodyMotion<C>> {
        let outside = self.outside_coordinates(inside);
        if self.bodies().is_some() {
            return self.body_motions(&outside);
        }
        let (twist, centre, reach) = (Twist::among(&outside), *self.origin(), self.length());
        vec![BodyMotion { body: "the object".into(), twist, centre, reach }]
    }

    /// Lengths that scale the rotations of all bodies other than the object.
    pub(crate) fn rotation_lengths(&self, bodies: &PlacedBodies<C>) -> Vec<f64> {
        let Some(linkage) = self.linkage() else { return Vec::new() };
        let others = bodies.places.iter().enumerate().filter(|(body, _)| *body != bodies.object);
        others
            .flat_map(|(_, place)| (C..of_the_object::<C>()).map(|k| linkage.lengths[place.first + k]))
            .collect()
    }

    /// The coordinates of the body that a contact's normal points into; all others are set to zero.
    pub(crate) fn body_alone(&self, contact: usize, coordinates: &Vector) -> Vector {
        let Some(bodies) = self.bodies() else { return object_alone::<C>(coordinates) };
        let Some((on, _)) = bodies.sides.get(contact) else { return coordinates.clone() };
        let first = bodies.places[*on].first;
        let mut alone = coordinates.clone();
        let own = first..first + of_the_object::<C>();
        alone.iter_mut().enumerate().filter(|(k, _)| !own.contains(k)).for_each(|(_, x)| *x = 0.0);
        alone
    }
}

fn no_body(name: &Arc<str>) -> Error {
    let fault = "is to be loaded, and the scene has no bodies".to_owned();
    Error::Body { name: name.to_string(), fault }
}
