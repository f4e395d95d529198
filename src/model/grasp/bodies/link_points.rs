//! The contacts that model a link. A bonded contact neither opens nor slips; a contact that is kept closed may slip, but not open.
//!
//! A hinge of the plane or a ball joint is modelled by one bonded contact, a hinge in space by two. A slide is a linear guide, which leaves free only
//! the translation along one direction. Frictionless contacts that are kept closed model its bearings, with normals across this direction. A rigid
//! joint is modelled by bonded contacts around its centre. A spring is a contact along its line that is kept closed, and a cable is a contact along
//! its line that only pulls. The normal of a spring or a cable points from the start of the line to its end: a positive normal force pulls the first
//! body towards the end.

use nalgebra::SVector;

use super::link::{Link, LinkGeometry};
use crate::error::{Error, LARGEST, MODERATE, is_moderate};
use crate::grasp::contact::Contact;
use crate::grasp::{Space, inside, outside};
use crate::numerics::{indexed, mapped, unit};
use crate::prelude::*;

impl<const C: usize> Link<C> {
    /// The contacts that model the link, as [`Bodies::links`](super::Bodies::links) adds them. With [`Grasp::new`](crate::ask::Grasp::new) they
    /// link a single object to the ground.
    ///
    /// # Errors
    /// [`Error::Link`] with the link's name, the field and the allowed values.
    pub fn contacts(&self) -> Result<Vec<Contact<C>>, Error> {
        self.contacts_called(self.name.as_deref().unwrap_or(self.kind().name()))
    }

    /// The contacts that model the link, with names derived from `name`.
    pub(crate) fn contacts_called(&self, name: &str) -> Result<Vec<Contact<C>>, Error> {
        inside(self).contacts_in(Space::of::<C>(), name).map(outside)
    }

    /// Returns the error of [`Self::contacts`] for a link of the plane or of space, if any.
    #[cfg(feature = "serde")]
    pub(crate) fn check_in(&self, space: Space) -> Result<(), Error> {
        inside(self).contacts_in(space, self.kind().name()).map(drop)
    }
}

impl Link<3> {
    /// The contacts that model the link in the plane or in space, with names derived from `name`.
    pub(crate) fn contacts_in(&self, space: Space, name: &str) -> Result<Vec<Contact<3>>, Error> {
        self.check().map_err(|(field, value, allowed)| Error::Link {
            kind: self.kind().name(),
            name: name.to_owned(),
            field,
            value,
            allowed,
        })?;
        let points = self.points(space);
        let (count, all) = (points.len() as f64, self.stiffness.unwrap_or(Self::STIFF));
        // A slide (linear guide) in space has two normal directions, and half of its bearing contacts act along each of them. The contacts of each
        // half together have the whole stiffness of the slide.
        let is_slide = matches!(self.geometry, LinkGeometry::Slide { .. });
        let share = if is_slide { (space.axes() - 1) as f64 / count } else { 1.0 / count };
        let is_one = points.len() == 1;
        let named = |(i, contact): (usize, &Contact<3>)| {
            let mut contact = contact.clone();
            contact.name = Some(if is_one { name.into() } else { format!("{name} {i}").into() });
            contact.point_of_pad = (!is_one).then_some(i);
            contact.link = Some(self.kind());
            (contact.on, contact.against) = (self.on.clone(), self.against.clone());
            contact.clearance = self.slack;
            contact.command[0] = self.pretension / all;
            contact.at_rest = self.tension;
            contact.series_stiffness_axes([all * share; 3])
        };
        Ok(indexed(&points, &named))
    }

    fn points(&self, space: Space) -> Vec<Contact<3>> {
        let contact = |point: SVector<f64, 3>, normal: SVector<f64, 3>| {
            let mut contact = Contact::<3>::new([0.0; 3], [0.0; 3]);
            (contact.space, contact.point, contact.normal) = (space, point, normal);
            contact
        };
        let glued = |at: SVector<f64, 3>| contact(at, unit(0)).bonded();
        match &self.geometry {
            LinkGeometry::Hinge { point, bearings: None } | LinkGeometry::Ball { point } => {
                vec![glued(*point)]
            }
            LinkGeometry::Hinge { point, bearings: Some((axis, length)) } => {
                let arm = axis.normalize() * (0.5 * length);
                vec![glued(point - arm), glued(point + arm)]
            }
            LinkGeometry::Rigid { point, size } => {
                mapped(&corners(space), &|corner| glued(point + corner * (0.5 * size)))
            }
            LinkGeometry::Spring { from, to } => vec![contact(*from, to - from).kept_closed()],
            LinkGeometry::Cable { from, to } => vec![contact(*from, to - from)],
            LinkGeometry::Slide { point, direction, length } => {
                let along = direction.normalize();
                let (half, across) = (0.5 * length, normals_to(space, &along));
                let mut points = Vec::new();
                for normal in &across {
                    // Bearing contacts lie at both ends of the slide (linear guide). In space they also lie on both of its sides, so that it cannot
                    // turn about its direction.
                    for arm in [&[along], &across[..]].concat() {
                        if arm != *normal {
                            for x in [-half, half] {
                                points.push(contact(point + arm * x, *normal).kept_closed());
                            }
                        }
                    }
                }
                points
            }
        }
    }

    /// Validates all numbers. The error holds the field, its value, and the allowed values.
    fn check(&self) -> Result<(), (&'static str, f64, &'static str)> {
        let point = |field, x: &SVector<f64, 3>| match x.as_slice().iter().find(|x| !is_moderate(**x)) {
            Some(x) => Err((field, *x, MODERATE)),
            None => Ok(()),
        };
        let good =
            |is_so: bool, field, x: f64, allowed| if is_so { Ok(()) } else { Err((field, x, allowed)) };
        let long =
            |field, x: f64| good((1.0 / LARGEST..=LARGEST).contains(&x), field, x, "from 1e-50 to 1e50");
        let along = |field, x: &SVector<f64, 3>| {
            point(field, x)?;
            good(x.norm() > 0.0, field, 0.0, "of a length above zero")
        };
        let is_line = matches!(self.geometry, LinkGeometry::Spring { .. } | LinkGeometry::Cable { .. });
        match &self.geometry {
            LinkGeometry::Hinge { point: at, bearings } => {
                point("point", at)?;
                if let Some((axis, length)) = bearings {
                    along("axis", axis)?;
                    long("length", *length)?;
                }
            }
            LinkGeometry::Ball { point: at } => point("point", at)?,
            LinkGeometry::Slide { point: at, direction, length } => {
                point("point", at)?;
                along("direction", direction)?;
                long("length", *length)?;
            }
            LinkGeometry::Rigid { point: at, size } => {
                point("point", at)?;
                long("size", *size)?;
            }
            LinkGeometry::Spring { from, to } | LinkGeometry::Cable { from, to } => {
                point("from", from)?;
                point("to", to)?;
                good(from != to, "length from beginning to end", 0.0, "above zero")?;
            }
        }
        let stiffness = self.stiffness.unwrap_or(Self::STIFF);
        good(stiffness > 0.0 && is_moderate(stiffness), "stiffness", stiffness, "above 0 and at most 1e50")?;
        good(is_moderate(self.pretension), "pretension", self.pretension, MODERATE)?;
        let only = "0 unless it is a spring or a cable";
        good(is_line || self.pretension == 0.0, "pretension", self.pretension, only)?;
        let is_cable = matches!(self.geometry, LinkGeometry::Cable { .. });
        if let Some(tension) = self.tension {
            good(tension > 0.0, "tension", tension, "more than 0 and at most 1e50, of a spring or a cable")?;
        }
        good(
            !is_cable || self.pretension >= 0.0,
            "pretension",
            self.pretension,
            "0 or more: a cable only pulls",
        )?;
        good(self.slack >= 0.0 && is_moderate(self.slack), "slack", self.slack, "from 0 to 1e50")?;
        good(is_cable || self.slack == 0.0, "slack", self.slack, "0 unless it is a cable")?;
        let is_slack = self.slack == 0.0 || self.tension.is_none();
        good(is_slack, "slack", self.slack, "0 in a cable with a tension")
    }
}

/// Unit vectors normal to `along`: one unit vector in the plane, two orthogonal unit vectors in space.
fn normals_to(space: Space, along: &SVector<f64, 3>) -> Vec<SVector<f64, 3>> {
    if space == Space::Planar {
        return vec![[-along[1], along[0], 0.0].into()];
    }
    let axis = unit::<3>(along.iamin());
    let one = (axis - along * along.dot(&axis)).normalize();
    vec![one, along.cross(&one)]
}

/// Points at distance 1 from the origin: two points in the plane, the corners of a tetrahedron in space. If each point has the same springs, their
/// stiffness against moments is equal about all axes.
fn corners(space: Space) -> Vec<SVector<f64, 3>> {
    if space == Space::Planar {
        return vec![-unit(0), unit(0)];
    }
    let side = 1.0 / 3f64.sqrt();
    let signs = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    mapped(&signs, &|signs| SVector::from(*signs) * side)
}
