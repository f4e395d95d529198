//! Adds several bodies to a grasp under assembly.

use super::place::PlacedBodies;
use crate::error::Error;
use crate::grasp::hand::Assembly;
use crate::grasp::rotation::of_the_object;

impl<const C: usize> Assembly<C> {
    /// Reserves coordinates for all bodies but the object, and appends to each contact its motion with them.
    pub(in crate::grasp) fn add_bodies(&mut self, bodies: &mut PlacedBodies<C>) -> Result<(), Error> {
        let object = of_the_object::<C>();
        self.used = bodies.place(&self.contacts, object + self.used)? - object;
        for (i, (contact, motions)) in self.contacts.iter().zip(&mut self.motions).enumerate() {
            motions.extend(bodies.columns(i, &contact.point));
        }
        Ok(())
    }
}
