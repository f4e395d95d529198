//! Adds several bodies to a grasp under assembly.

use super::place::PlacedBodies;
use crate::error::Error;
use crate::grasp::hand::Assembly;

impl Assembly {
    /// Reserves coordinates for all bodies but the object, and appends to each contact its motion with them.
    pub(in crate::model::grasp) fn add_bodies(&mut self, bodies: &mut PlacedBodies) -> Result<(), Error> {
        let object = self.space.of_the_object();
        self.used = bodies.place(&self.contacts, object + self.used)? - object;
        for (i, (contact, motions)) in self.contacts.iter().zip(&mut self.motions).enumerate() {
            motions.extend(bodies.columns(i, &contact.point));
        }
        Ok(())
    }
}
