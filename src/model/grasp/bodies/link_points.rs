//! The contacts that model a link.
//!
//! A hinge is bonded at one point, in space at two. A slide is kept closed without friction, at bearings across its direction. A rigid joint is
//! bonded at points around its own. A spring is kept closed along its line, and a cable pulls along it. There the normal points from the beginning of
//! the line to its end: a positive normal force pulls the first body towards the end.

use nalgebra::SVector;

use super::link::{Link, LinkPlace};
use crate::error::{Error, LARGEST, MODERATE, is_moderate};
use crate::grasp::contact::Contact;
#[cfg(feature = "serde")]
use crate::grasp::{Face, Space};
use crate::prelude::*;

/// Unit vectors across a direction: two in space, one in the plane.
type Across<const C: usize> = Vec<SVector<f64, C>>;

impl<const C: usize> Link<C> {
    /// The contacts that model the link, as [`Bodies::links`](super::Bodies::links) adds them. Given to [`Grasp::new`](crate::ask::Grasp::new), they
    /// link a single object to the ground.
    ///
    /// # Errors
    /// [`Error::Link`] with the link's name, the field and the allowed values.
    pub fn contacts(&self) -> Result<Vec<Contact<C>>, Error> {
        self.contacts_called(self.name.as_deref().unwrap_or(self.kind().name()))
    }

    /// Refuses a link of a space as [`Self::contacts`] does.
    #[cfg(feature = "serde")]
    pub(crate) fn check_in(&self, space: Space) -> Result<(), Error> {
        let link = self.clone().enter();
        match space {
            Space::Planar => Link::<2>::leave(link).contacts().map(drop),
            Space::Spatial => link.contacts().map(drop),
        }
    }

    /// The contacts, named after `name`.
    pub(crate) fn contacts_called(&self, name: &str) -> Result<Vec<Contact<C>>, Error> {
        self.check().map_err(|(field, value, allowed)| Error::Link {
            kind: self.kind().name(),
            name: name.to_owned(),
            field,
            value,
            allowed,
        })?;
        let points = self.points();
        let (count, all) = (points.len() as f64, self.stiffness.unwrap_or(Self::STIFF));
        // In space half of the bearings of a slide act along each direction across it.
        let share =
            if matches!(self.place, LinkPlace::Slide { .. }) { (C - 1) as f64 / count } else { 1.0 / count };
        let is_one = points.len() == 1;
        let named = |(i, mut contact): (usize, Contact<C>)| {
            contact.name = Some(if is_one { name.into() } else { format!("{name} {i}").into() });
            contact.point_of_pad = (!is_one).then_some(i);
            contact.link = Some(self.kind());
            (contact.on, contact.against) = (self.on.clone(), self.against.clone());
            contact.clearance = self.slack;
            contact.command[0] = self.pretension / all;
            contact.at_rest = self.tension;
            contact.series_stiffness_axes([all * share; C])
        };
        Ok(points.into_iter().enumerate().map(named).collect())
    }

    fn points(&self) -> Vec<Contact<C>> {
        let first = || SVector::<f64, C>::from_fn(|a, _| if a == 0 { 1.0 } else { 0.0 });
        let contact = |point: SVector<f64, C>, normal: SVector<f64, C>| {
            let mut contact = Contact::new([0.0; C], [0.0; C]);
            (contact.point, contact.normal) = (point, normal);
            contact
        };
        let glued = |at: SVector<f64, C>| contact(at, first()).bonded();
        match &self.place {
            LinkPlace::Hinge { point, bearings: None } | LinkPlace::Ball { point } => vec![glued(*point)],
            LinkPlace::Hinge { point, bearings: Some((axis, length)) } => {
                let arm = axis.normalize() * (0.5 * length);
                vec![glued(point - arm), glued(point + arm)]
            }
            LinkPlace::Rigid { point, size } => {
                corners::<C>().into_iter().map(|corner| glued(point + corner * (0.5 * size))).collect()
            }
            LinkPlace::Spring { from, to } => vec![contact(*from, to - from).kept_closed()],
            LinkPlace::Cable { from, to } => vec![contact(*from, to - from)],
            LinkPlace::Slide { point, direction, length } => {
                let along = direction.normalize();
                let (half, across) = (0.5 * length, across(&along));
                let mut points = Vec::new();
                for normal in &across {
                    // Bearings at both ends, and in space on both sides of them, too, so that the slide cannot turn about its direction.
                    for arm in core::iter::once(&along).chain(across.iter().filter(|other| *other != normal))
                    {
                        points.extend([-half, half].map(|x| contact(point + arm * x, *normal).kept_closed()));
                    }
                }
                points
            }
        }
    }

    /// Checks all numbers; the error has the field, its value, and the allowed values.
    fn check(&self) -> Result<(), (&'static str, f64, &'static str)> {
        let point = |field, x: &SVector<f64, C>| match x.iter().find(|x| !is_moderate(**x)) {
            Some(x) => Err((field, *x, MODERATE)),
            None => Ok(()),
        };
        let good =
            |is_so: bool, field, x: f64, allowed| if is_so { Ok(()) } else { Err((field, x, allowed)) };
        let long =
            |field, x: f64| good((1.0 / LARGEST..=LARGEST).contains(&x), field, x, "from 1e-50 to 1e50");
        let along = |field, x: &SVector<f64, C>| {
            point(field, x)?;
            good(x.norm() > 0.0, field, 0.0, "of a length above zero")
        };
        let is_line = matches!(self.place, LinkPlace::Spring { .. } | LinkPlace::Cable { .. });
        match &self.place {
            LinkPlace::Hinge { point: at, bearings } => {
                point("point", at)?;
                if let Some((axis, length)) = bearings {
                    along("axis", axis)?;
                    long("length", *length)?;
                }
            }
            LinkPlace::Ball { point: at } => point("point", at)?,
            LinkPlace::Slide { point: at, direction, length } => {
                point("point", at)?;
                along("direction", direction)?;
                long("length", *length)?;
            }
            LinkPlace::Rigid { point: at, size } => {
                point("point", at)?;
                long("size", *size)?;
            }
            LinkPlace::Spring { from, to } | LinkPlace::Cable { from, to } => {
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
        let is_cable = matches!(self.place, LinkPlace::Cable { .. });
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
        good(is_cable || self.slack == 0.0, "slack", self.slack, "0 unless it is a cable")
    }
}

/// Unit vectors across `along`, in space also across each other.
fn across<const C: usize>(along: &SVector<f64, C>) -> Across<C> {
    if C == 2 {
        return vec![SVector::from_fn(|a, _| if a == 0 { -along[1] } else { along[0] })];
    }
    let mut axis = SVector::<f64, C>::zeros();
    axis[along.iamin()] = 1.0;
    let one = (axis - along * along.dot(&axis)).normalize();
    let other = SVector::from_fn(|a, _| {
        let (b, c) = ((a + 1) % C, (a + 2) % C);
        along[b] * one[c] - along[c] * one[b]
    });
    vec![one, other]
}

/// Points at distance 1 that resist moments about all axes equally: two in the plane, the corners of a tetrahedron in space.
fn corners<const C: usize>() -> Vec<SVector<f64, C>> {
    if C == 2 {
        return [-1.0, 1.0].map(|x| SVector::from_fn(|a, _| if a == 0 { x } else { 0.0 })).to_vec();
    }
    let side = 1.0 / 3f64.sqrt();
    [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]]
        .map(|signs| SVector::from_fn(|a, _| side * signs[a]))
        .to_vec()
}
