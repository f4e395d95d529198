//! Adds several bodies to a grasp that is being assembled from contacts and joints.

use super::place::PlacedBodies;
use crate::error::Error;
use crate::grasp::hand::Assembly;

impl Assembly {
    /// Reserves coordinates for all bodies except the object. Also adds, to the list of motions of each contact, its displacements per unit of the
    /// new coordinates.
    pub(in crate::model::grasp) fn add_bodies(&mut self, bodies: &mut PlacedBodies) -> Result<(), Error> {
        let object = self.space.of_the_object();
        self.used = bodies.place(&self.contacts, object + self.used)? - object;
        for (i, (contact, motions)) in self.contacts.iter().zip(&mut self.motions).enumerate() {
            motions.extend(bodies.columns(i, &contact.point));
        }
        Ok(())
    }
}
