//! Bodies on their way into a grasp.

use super::place::PlacedBodies;
use crate::error::Error;
use crate::grasp::hand::Assembly;
use crate::grasp::rotation::of_the_object;

impl<const C: usize> Assembly<C> {
    /// Coordinates of all bodies but the one in those of the object, and what contacts do with them.
    pub(in crate::grasp) fn add_bodies(&mut self, bodies: &mut PlacedBodies<C>) -> Result<(), Error> {
        let object = of_the_object::<C>();
        self.used = bodies.place(&self.contacts, object + self.used)? - object;
        for (i, (contact, motions)) in self.contacts.iter().zip(&mut self.motions).enumerate() {
            motions.extend(bodies.columns(i, &contact.point));
        }
        Ok(())
    }
}
