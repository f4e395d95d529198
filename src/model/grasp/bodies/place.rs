//! The coordinates that belong to each body, the two bodies that each contact joins, and the loads on bodies.
//!
//! One of the bodies has the coordinates of the object, which come first; the coordinates of the other bodies follow those of the joints. The load
//! that the caller passes to a question such as `hold` acts on the body with the object's coordinates, or is shared among several bodies. A load
//! program is a sequence of ramps and turns of the loads, along which a load path is followed.

use alloc::sync::Arc;

use nalgebra::SVector;

use crate::error::Error;
use crate::grasp::contact::Contact;
use crate::grasp::engine::space_of;
use crate::grasp::hand::Columns;
use crate::grasp::points_of_action::PointsOfAction;
use crate::grasp::wrench::Wrench;
use crate::numerics::{
    IntoList, Size, Space, Vector, chosen, dot, indexed, mapped, numbered, paired, summed, tried,
};
use crate::prelude::*;
use crate::words::printable;

/// Where the coordinates of one body stand among all coordinates of the engine, and the point to which its rotations refer.
#[derive(Debug, Clone)]
pub(crate) struct BodyPlace {
    /// Index, from 0, of the body's first coordinate among all coordinates; zero for the body that has the object's coordinates.
    pub(crate) first: usize,
    /// Centroid of the body's contact points, m. The coordinates of rotation refer to this point.
    pub(crate) centre: SVector<f64, 3>,
    /// Root mean square distance of the body's contact points from the centroid, m.
    pub(crate) rms_radius: f64,
}

/// How a load that the caller passes to a question such as `hold` is shared among the bodies.
#[derive(Debug, Clone)]
pub(super) enum LoadSharing {
    /// The body that has the object's coordinates carries the whole load.
    OnObject,
    /// For each body the fraction of the load that it carries, and the point where its force acts, m.
    ByParts(Vec<(f64, SVector<f64, 3>)>),
    /// The loads of all bodies grow together. If the caller's load is `one`, each body carries its entry of `loads`. If the caller's load is a
    /// multiple of `one`, each body carries the same multiple of its entry.
    Together { one: Wrench<3>, loads: Vec<Wrench<3>> },
}

/// Several bodies in the engine, with their coordinates, loads and contacts.
#[derive(Debug, Clone)]
pub(crate) struct PlacedBodies {
    space: Space,
    pub(crate) names: Vec<Arc<str>>,
    /// Index, from 0, of the body that has the object's coordinates.
    pub(crate) object: usize,
    /// Constant load on each body, in addition to the loads that are passed to questions.
    pub(crate) loads: Vec<Wrench<3>>,
    /// The part of `loads` that the user gave as loads of bodies; weights are not included.
    pub(crate) user_loads: Vec<Wrench<3>>,
    /// The part of `loads` that a load program has applied so far, one load for each body; empty if no load program is followed.
    pub(super) program_loads: Vec<Wrench<3>>,
    pub(super) sharing: LoadSharing,
    pub(crate) places: Vec<BodyPlace>,
    /// For each contact, the body into which its normal points and the body on the other side, if any.
    pub(crate) sides: Vec<(usize, Option<usize>)>,
}

impl PlacedBodies {
    pub(super) fn new(
        names: Vec<Arc<str>>,
        object: usize,
        (loads, user_loads): (Vec<Wrench<3>>, Vec<Wrench<3>>),
        sharing: LoadSharing,
    ) -> Self {
        let (program_loads, places, sides) = (Vec::new(), Vec::new(), Vec::new());
        Self {
            space: Space::Spatial,
            names,
            object,
            loads,
            user_loads,
            program_loads,
            sharing,
            places,
            sides,
        }
    }

    /// Assigns coordinates to every body. The object has the first coordinates; all other bodies get indices from `first` on. Returns the next free
    /// index.
    ///
    /// # Errors
    /// [`Error::Body`] if a contact names an unknown body, names no body although there are several, or has the same body on both sides.
    pub(crate) fn place(&mut self, contacts: &[Contact<3>], first: usize) -> Result<usize, Error> {
        self.space = space_of(contacts);
        let numbered = indexed(contacts, &|contact| contact);
        self.sides = tried(&numbered, &|(i, contact)| self.sides_of(contact, *i))?;
        let mut next = first;
        for body in 0..self.names.len() {
            let touching = chosen(contacts.len(), &|i| self.touches(*i, body));
            let points = mapped(&touching, &|i| contacts[*i].point);
            let count = points.len().max(1) as f64;
            let centre = points.iter().fold(SVector::zeros(), |sum, point| sum + point / count);
            let rms_radius = summed(&points, &|point| (point - centre).norm_squared() / count).sqrt();
            let is_object = body == self.object;
            self.places.push(BodyPlace { first: if is_object { 0 } else { next }, centre, rms_radius });
            next += if is_object { 0 } else { self.space.of_the_object() };
        }
        Ok(next)
    }

    fn sides_of(&self, contact: &Contact<3>, index: usize) -> Result<(usize, Option<usize>), Error> {
        let refuse = |name: &str, fault: String| Error::Body { name: name.to_owned(), fault };
        let find = |name: &Arc<str>| {
            self.names.iter().position(|other| other == name).ok_or_else(|| {
                let names: Vec<_> = mapped(&self.names, &|name| printable(name));
                let who = contact.said_in_full(index);
                refuse(name, format!("is named by {who}, and is none of {}", names.join(", ")))
            })
        };
        let on = match &contact.on {
            Some(name) => find(name)?,
            None if self.names.len() == 1 => 0,
            None => {
                let who = contact.said_in_full(index);
                let fault = format!("may be what {who} is on, or another one: it must be said");
                return Err(refuse(&self.names[0], fault));
            }
        };
        let against = contact.against.as_ref().map(find).transpose()?;
        if against == Some(on) {
            let fault = format!("is on both sides of {}", contact.said_in_full(index));
            return Err(refuse(&self.names[on], fault));
        }
        Ok((on, against))
    }

    /// Whether the force of a contact acts on a body.
    pub(crate) fn touches(&self, contact: usize, body: usize) -> bool {
        self.sign(contact, body) != 0.0
    }

    /// Sign with which the force of a contact acts on a body. It is 1 if the normal points into the body, -1 if the body is on the other side of the
    /// contact, else 0.
    pub(crate) fn sign(&self, contact: usize, body: usize) -> f64 {
        match self.sides[contact] {
            (on, _) if on == body => 1.0,
            (_, Some(against)) if against == body => -1.0,
            _ => 0.0,
        }
    }

    /// Relative displacement at a contact per unit of each coordinate of its two bodies. Coordinates of the object are left out; the index of any
    /// other coordinate is counted from 0 after those of the object. The relative displacement is that of the body on the other side of the contact,
    /// less that of the body into which the normal points.
    pub(crate) fn columns(&self, contact: usize, point: &SVector<f64, 3>) -> Columns {
        let object = self.space.of_the_object();
        let mut columns = Columns::new();
        for (body, place) in self.places.iter().enumerate() {
            let sign = -self.sign(contact, body);
            if sign == 0.0 || body == self.object {
                continue;
            }
            let arm = point - place.centre;
            for k in 0..object {
                let mut unit = Vector::zeros();
                unit[k] = sign;
                columns.push((place.first - object + k, self.space.displacement_of(&arm, &unit)));
            }
        }
        columns
    }

    /// The part of `load`, the load that the caller asks about, that each body carries; constant loads of bodies are not included.
    pub(crate) fn shared(&self, load: &Wrench<3>) -> Vec<Wrench<3>> {
        let list = match &self.sharing {
            LoadSharing::OnObject => {
                let on = |body: usize| if body == self.object { *load } else { Wrench::ZERO };
                return numbered(self.names.len(), &on);
            }
            LoadSharing::Together { one, loads } => {
                let along = |x: &Wrench<3>| dot(x.components(), one.components());
                let times = along(load) / along(one);
                return mapped(loads, &|of| *of * times);
            }
            LoadSharing::ByParts(list) => list,
        };
        // Each body gets its fraction of the force, at its centre of mass, and its fraction of the moment that these forces leave unbalanced.
        let force = load.force_part();
        let at_centres: Vec<_> =
            mapped(list, &|(part, centre)| Wrench::force_through(centre, &(force * *part)));
        let left = at_centres.iter().fold(*load, |left, wrench| left - *wrench);
        // What remains of the load is a pure moment, which has no points of action.
        let left = left.acting_at(PointsOfAction::NO_FORCE);
        at_centres.iter().zip(list).map(|(wrench, (part, _))| *wrench + left * *part).list()
    }

    /// The wrench on each body except the body that has the object's coordinates, with moments about the user's origin. `outside` holds the
    /// generalised forces in all coordinates, in the user's units.
    pub(crate) fn others<'a>(&'a self, outside: &'a Vector) -> impl Iterator<Item = Wrench<3>> + 'a {
        self.places.iter().enumerate().filter(|(body, _)| *body != self.object).map(|(_, place)| {
            let first = place.first;
            let count = Size::of(self.space.of_the_object());
            let own = Vector::from_fn(count, |k| outside[first + k]);
            Wrench::among(self.space, &self.space.moved_wrench(&place.centre, &own))
        })
    }

    /// Index of the body with this name.
    ///
    /// # Errors
    /// [`Error::Body`] if there is no such body.
    pub(super) fn called(&self, name: &Arc<str>) -> Result<usize, Error> {
        self.names.iter().position(|other| other == name).ok_or_else(|| {
            let names: Vec<_> = mapped(&self.names, &|name| printable(name));
            let fault = format!("is to be loaded, and is none of {}", names.join(", "));
            Error::Body { name: name.to_string(), fault }
        })
    }

    /// These bodies with the loads `program_loads` added to their constant loads; `program_loads` has one load for each body.
    pub(super) fn under(&self, program_loads: Vec<Wrench<3>>) -> Self {
        let loads = paired(&self.loads, &program_loads, &|(always, more)| *always + *more);
        Self { loads, program_loads, ..self.clone() }
    }

    /// Whether the load that is passed to a question may act on more than one body.
    pub(crate) fn is_shared(&self) -> bool {
        !matches!(self.sharing, LoadSharing::OnObject)
    }

    /// These bodies without constant loads. Instead each body carries its entry of `loads` times a factor. The factor is the first force component,
    /// in N, of the load passed to a question: with 2 N each body carries twice its entry.
    pub(super) fn growing_together(&self, loads: Vec<Wrench<3>>) -> Self {
        let none = vec![Wrench::ZERO; loads.len()];
        let sharing = LoadSharing::Together { one: Wrench::from_components(&[1.0]), loads };
        Self { loads: none, sharing, ..self.clone() }
    }

    /// These bodies with the further loads `others`, each with the name of its body, which grow in proportion to the load passed to a question. If
    /// this load is `one`, they act as given; if it is a multiple of `one`, they are scaled by the same factor.
    ///
    /// # Errors
    /// [`Error::Body`] for an unknown body, [`Error::NothingChanges`] if `one` is zero, [`Error::Wrench`] for a component out of range.
    pub(super) fn with_others_growing(
        &self,
        one: &Wrench<3>,
        others: &[(Arc<str>, Wrench<3>)],
    ) -> Result<Self, Error> {
        if *one == Wrench::ZERO {
            return Err(Error::NothingChanges);
        }
        one.check_in(self.space, "load")?;
        let mut loads = self.shared(one);
        for (name, load) in others {
            load.check_in(self.space, "load that grows with another")?;
            let body = self.called(name)?;
            loads[body] = loads[body] + *load;
        }
        Ok(Self { sharing: LoadSharing::Together { one: *one, loads }, ..self.clone() })
    }
}

/// Returns an error if a contact names a body. Called for grasps without named bodies.
pub(crate) fn refuse_sides(contacts: &[Contact<3>]) -> Result<(), Error> {
    for (i, contact) in contacts.iter().enumerate() {
        if let Some(name) = contact.on.as_ref().or(contact.against.as_ref()) {
            let fault = format!("is named by {}, and the scene has no bodies", contact.said_in_full(i));
            return Err(Error::Body { name: name.to_string(), fault });
        }
    }
    Ok(())
}
