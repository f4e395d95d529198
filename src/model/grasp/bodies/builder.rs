//! Builder of a grasp with several bodies, their contacts, links and hand. A question is a method of a grasp that takes a load, such as `hold`.

use alloc::sync::Arc;

use nalgebra::SVector;

use super::body::Body;
use super::link::Link;
use super::place::{LoadSharing, PlacedBodies};
use crate::error::{Error, MODERATE, is_moderate};
use crate::grasp::contact::Contact;
use crate::grasp::face::Face;
use crate::grasp::hand::{Finger, Hand};
use crate::grasp::wrench::Wrench;
use crate::numerics::{IntoList, mapped, summed};
use crate::prelude::*;

/// Several bodies that touch each other, the ground and fingers. [`Bodies::grasp`] makes a grasp, which answers the same questions as any other
/// grasp.
///
/// [`Contact::on`] names the body into which a contact's normal points, [`Contact::against`] the body on its other side. Without `against`, the other
/// side is the ground or a finger. The load passed to a question such as [`hold`](crate::ask::Grasp::hold) acts on one body: the first, or the body
/// named by [`loaded`](Self::loaded). With [`shared_by_mass`](Self::shared_by_mass) that load acts on all bodies in proportion to their masses.
///
/// ```
/// use grasp_lcp::planar::{Bodies, Body, Contact, Wrench};
///
/// // A box of 10 N stands on a box of 20 N on a table; μ = 0.3 between the boxes, and 0.5 at the table. The lower box is pulled.
/// let at = |x: f64, y: f64| Contact::new([x, y], [0.0, 1.0]).series_stiffness(1e5, 1e5);
/// let boxes = Bodies::new([
///     Body::new("lower").load(Wrench::force_at([0.0, -20.0], [0.0, 0.1])),
///     Body::new("upper").load(Wrench::force_at([0.0, -10.0], [0.0, 0.3])),
/// ])
/// .contacts([-0.1, 0.1].map(|x| at(x, 0.0).on("lower").friction(0.5)))
/// .contacts([-0.1, 0.1].map(|x| at(x, 0.2).on("upper").against("lower").friction(0.3)))
/// .grasp()?;
/// let verdict = boxes.hold(Wrench::force([20.0, 0.0]))?;
/// // Both boxes slide together on the table, under a pull of μ (10 + 20) N = 15 N.
/// assert!((verdict.lost.expect("slides").factor - 15.0 / 20.0).abs() < 1e-12);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Bodies<const C: usize> {
    list: Vec<Body<C>>,
    hand: Hand<C>,
    links: Vec<Link<C>>,
    gravity: SVector<f64, C>,
    loaded: LoadedBodies,
}

/// The bodies on which a load acts if the caller passes it to a question such as `hold`.
#[derive(Debug, Clone, PartialEq)]
enum LoadedBodies {
    First,
    Body(Arc<str>),
    ByMass,
}

impl<const C: usize> Bodies<C> {
    /// A grasp of these bodies, which must have different names; contacts and links are added next.
    pub fn new(bodies: impl IntoIterator<Item = Body<C>>) -> Self {
        Self {
            list: bodies.into_iter().list(),
            hand: Hand::new([]),
            links: Vec::new(),
            gravity: SVector::zeros(),
            loaded: LoadedBodies::First,
        }
    }

    setters! {
        /// Adds contacts with the ground, with fixed fingers, or between bodies. None of these contacts is moved by joints.
        pub fn contacts(mut self, contacts: impl IntoIterator<Item = Contact<C>>) {
            self.hand = contacts.into_iter().map(Finger::fixed).fold(self.hand, Hand::finger);
        }

        /// Adds hinges, slides (linear guides), springs or cables between the bodies or to the ground. The contacts that model these links come after
        /// all other contacts.
        pub fn links(mut self, links: impl IntoIterator<Item = Link<C>>) { self.links.extend(links); }

        /// Sets the hand that holds the bodies. The hand replaces all contacts given before.
        pub fn held_by(mut self, hand: Hand<C>) { self.hand = hand; }

        /// Sets gravity, m/s². The weight of each body acts at its centre of mass, in addition to the load passed to a question such as
        /// [`hold`](crate::ask::Grasp::hold).
        pub fn gravity(mut self, gravity: impl Into<[f64; C]>) {
            self.gravity = SVector::from(gravity.into());
        }

        /// Makes the loads that are passed to questions, such as [`hold`](crate::ask::Grasp::hold), act on this body.
        pub fn loaded(mut self, body: impl Into<String>) {
            self.loaded = LoadedBodies::Body(body.into().into());
        }

        /// Shares the loads that are passed to questions, such as [`hold`](crate::ask::Grasp::hold), among all bodies in proportion to their masses.
        /// Each part of the force acts at the centre of mass of its body. The moment that these forces leave unbalanced is shared in the same
        /// proportion. A load parallel to gravity thus scales all weights, and a load that turns (changes its direction) turns all weights.
        pub fn shared_by_mass(mut self) { self.loaded = LoadedBodies::ByMass; }
    }

    /// Total weight of the bodies under this gravity (m/s²), as a load to pass to questions if loads are [shared by mass](Self::shared_by_mass).
    pub fn weight(&self, gravity: impl Into<[f64; C]>) -> Wrench<C> {
        let gravity = SVector::from(gravity.into());
        self.list.iter().fold(Wrench::ZERO, |sum, body| sum + body.weight(&gravity))
    }

    /// Validates bodies and links. Returns the hand, to which the contacts of the links are added, and the bodies.
    ///
    /// # Errors
    /// [`Error::Body`] with the name of the body, [`Error::Link`] with the name of the link, and the fault. [`Error::Wrench`] for a load and
    /// [`Error::Argument`] for a gravity that is out of range.
    pub(crate) fn checked(self) -> Result<(Hand<C>, PlacedBodies), Error> {
        let Self { list: bodies, mut hand, links, gravity, loaded } = self;
        for (number, link) in links.iter().enumerate() {
            let points = link.contacts_called(&link.called(number))?;
            hand = points.into_iter().map(Finger::fixed).fold(hand, Hand::finger);
        }
        let space = hand.space();
        let names: Vec<Arc<str>> = mapped(&bodies, &|body| body.name.clone());
        let refuse = |name: &Arc<str>, fault: String| Err(Error::Body { name: name.to_string(), fault });
        if names.is_empty() {
            return Err(Error::Body { name: String::new(), fault: "no body was given".to_owned() });
        }
        for (b, body) in bodies.iter().enumerate() {
            if names[..b].contains(&body.name) {
                return refuse(&body.name, "has the name of another body".to_owned());
            }
            if !(is_moderate(body.mass) && body.mass >= 0.0) {
                return refuse(&body.name, format!("has mass {}, must be from 0 to 1e50", body.mass));
            }
            if let Some(x) = body.centre.iter().find(|x| !is_moderate(**x)) {
                return refuse(&body.name, format!("has its centre of mass at {x}, must be {MODERATE}"));
            }
            body.load.check_in(space, "load of a body")?;
        }
        if let Some(&value) = gravity.iter().find(|x| !is_moderate(**x)) {
            return Err(Error::Argument { what: "gravity", value, allowed: MODERATE });
        }
        let object = match &loaded {
            LoadedBodies::First | LoadedBodies::ByMass => 0,
            LoadedBodies::Body(name) => match names.iter().position(|other| other == name) {
                Some(body) => body,
                None => return refuse(name, format!("is to be loaded, and is none of {}", names.join(", "))),
            },
        };
        let mass: f64 = summed(&bodies, &|body| body.mass);
        if loaded == LoadedBodies::ByMass && mass == 0.0 {
            return refuse(
                &names[0],
                "and all others have no mass by which a load could be shared".to_owned(),
            );
        }
        let sharing = match loaded {
            LoadedBodies::ByMass => {
                LoadSharing::ByParts(mapped(&bodies, &|body| (body.mass / mass, body.centre.into_inside())))
            }
            LoadedBodies::First | LoadedBodies::Body(_) => LoadSharing::OnObject,
        };
        let loads = mapped(&bodies, &|body| (body.load + body.weight(&gravity)).into_inside());
        let user_loads = mapped(&bodies, &|body| body.load.into_inside());
        Ok((hand, PlacedBodies::new(names, object, (loads, user_loads), sharing)))
    }
}

impl<const C: usize> Body<C> {
    /// Weight of the body under this gravity, m/s².
    fn weight(&self, gravity: &SVector<f64, C>) -> Wrench<C> {
        Wrench::force_through(&self.centre, &(gravity * self.mass))
    }
}
