//! Pull of the vacuums on the object: a constant load in addition to the caller's load. In the engine's coordinates moments and rotations refer to
//! the centroid of the contacts.

use super::contact::Contact;
use super::engine::Engine;
use super::site::Site;
use super::whole_contact::WholeContact;
use super::wrench::Wrench;
use crate::error::ContactLabel;
use crate::numerics::{Space, Vector, keep};
use crate::prelude::*;
use crate::words::listed;

/// The pressure of the surrounding air at sea level, Pa: the largest possible pull of a vacuum per area.
pub(crate) const ATMOSPHERE: f64 = 101_325.0;

/// The sentence of a message about suction cups that have opened: "cup opens all around, and its vacuum is gone".
pub(crate) fn vacuum_is_gone(cups: &[WholeContact]) -> String {
    let [opens, its] = if cups.len() == 1 { ["opens", "its"] } else { ["open", "their"] };
    format!("{} {opens} all around, and {its} vacuum is gone", listed(cups))
}

/// Total pull of the vacuums of all contacts, a constant load.
#[derive(Debug, Clone)]
pub(crate) struct Vacuum {
    /// Generalised force of the vacuums on object, joints and other bodies, in the engine's coordinates.
    pub(crate) inside: Vector,
    /// Wrench of the vacuums on the object, in the caller's coordinates.
    pub(crate) on_object: Wrench<3>,
}

impl Vacuum {
    /// Sums the forces of the vacuums, which act between fingers and object along the contact normals; `None` without a vacuum.
    pub(super) fn of(space: Space, contacts: &[Contact<3>], sites: &[Site]) -> Option<Box<Self>> {
        if contacts.iter().all(|contact| contact.suction == 0.0) {
            return None;
        }
        let (mut inside, mut outside) = (Vector::zeros(), Vector::zeros());
        for (contact, site) in contacts.iter().zip(sites).filter(|(contact, _)| contact.suction != 0.0) {
            inside -= &site.map.column(0) * contact.suction;
            outside += contact.suction_wrench(site);
        }
        Some(Box::new(Self { inside, on_object: Wrench::among(space, &outside) }))
    }
}

impl Contact<3> {
    /// Wrench of the contact's vacuum on the object, about the origin.
    pub(crate) fn suction_wrench(&self, site: &Site) -> Vector {
        self.space.wrench_of(&self.point, &(site.frame.column(0) * -self.suction))
    }
}

impl Engine {
    /// Total pull of the vacuums of the grasp; `None` without a vacuum.
    pub(crate) fn vacuum(&self) -> Option<&Vacuum> {
        self.vacuum.as_deref()
    }

    /// The suction cups whose lips are open at all points, which means that their vacuum is lost.
    pub(crate) fn cups_open(&self, is_open: impl Fn(usize) -> bool) -> Vec<WholeContact> {
        if self.vacuum().is_none() {
            return Vec::new();
        }
        let of_a_cup = |i: usize| self.contacts()[i].suction > 0.0;
        let mut cups = self.wholes().with(&|i| of_a_cup(i) && is_open(i));
        keep(&mut cups, &WholeContact::is_whole);
        cups
    }

    /// The first suction cup with a leak: some points of its lip are open, others are closed. The result includes the number of open points.
    pub(crate) fn leaking_cup(&self, is_open: &dyn Fn(usize) -> bool) -> Option<WholeContact> {
        self.vacuum()?;
        let open = self.wholes().with(&|i| self.contacts()[i].suction > 0.0 && is_open(i));
        open.into_iter().find(|cup| !cup.is_whole())
    }

    /// Label of the first suction cup; `None` without a cup.
    pub(crate) fn first_cup(&self) -> Option<ContactLabel> {
        let cups = self.cups_open(|_| true);
        cups.first().map(|cup| self.wholes()[cup.contact].label.clone())
    }

    /// Indices of all contact points of the contacts in `parts`, in which a suction cup or a soft fingertip counts as one contact.
    pub(crate) fn points_of(&self, parts: &[WholeContact]) -> Vec<usize> {
        let mut points = Vec::new();
        for part in parts {
            points.extend(self.wholes()[part.contact].range.clone());
        }
        points
    }

    /// The caller's load plus the pull of the vacuums.
    pub(crate) fn with_vacuum(&self, load: &Wrench<3>) -> Wrench<3> {
        self.vacuum().map_or(*load, |vacuum| *load + vacuum.on_object)
    }
}
