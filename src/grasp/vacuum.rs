//! What vacuums pull the object with: a load that is there beside the caller's, whatever that is.

use super::contact::Contact;
use super::engine::Engine;
use super::rotation::wrench_of;
use super::site::Site;
use super::wrench::Wrench;
use crate::numerics::{Size, Vector};

/// The vacuums of all contacts together.
#[derive(Debug, Clone)]
pub(crate) struct Vacuum<D: Size, const C: usize> {
    /// On object and joints, in inside coordinates.
    pub(crate) inside: Vector<D>,
    /// On the object, as the caller sees loads.
    pub(crate) on_object: Wrench<C>,
}

impl<D: Size, const C: usize> Vacuum<D, C> {
    /// Between each finger and the object, along the normal of the contact; `None` where there is none.
    pub(super) fn of(contacts: &[Contact<C>], sites: &[Site<D, C>]) -> Option<Box<Self>> {
        if contacts.iter().all(|contact| contact.suction == 0.0) {
            return None;
        }
        let (mut inside, mut outside) = (Vector::zeros(), Vector::zeros());
        for (contact, site) in contacts.iter().zip(sites).filter(|(contact, _)| contact.suction != 0.0) {
            inside -= &site.map.column(0) * contact.suction;
            outside += contact.pulled(site);
        }
        Some(Box::new(Self { inside, on_object: Wrench::among(&outside) }))
    }
}

impl<const C: usize> Contact<C> {
    /// What its vacuum does to the object.
    pub(crate) fn pulled<D: Size>(&self, site: &Site<D, C>) -> Vector<D> {
        wrench_of::<D, C>(&self.point, &(site.frame.column(0) * -self.suction))
    }
}

impl<D: Size, const C: usize> Engine<D, C> {
    /// What vacuums pull with, if there are any.
    pub(crate) fn vacuum(&self) -> Option<&Vacuum<D, C>> {
        self.vacuum.as_deref()
    }

    /// A load of the caller's with what vacuums do to the object.
    pub(crate) fn with_vacuum(&self, load: &Wrench<C>) -> Wrench<C> {
        self.vacuum().map_or(*load, |vacuum| *load + vacuum.on_object)
    }
}
