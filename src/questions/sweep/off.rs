//! A contact with errors in its data.

use nalgebra::SVector;

use crate::grasp::Contact;

/// Errors of a contact's data: factors, and additions to its place and direction.
#[derive(Debug, Clone, Copy)]
pub(super) struct ContactErrors {
    pub(super) friction: f64,
    pub(super) stiffness: f64,
    pub(super) squeeze: f64,
    /// Displacement of the contact point, m.
    pub(super) moved: SVector<f64, 3>,
    /// Angles towards its tangents, rad.
    pub(super) tilt: SVector<f64, 3>,
}

impl ContactErrors {
    /// No errors.
    pub(super) fn not() -> Self {
        let (moved, tilt) = (SVector::zeros(), SVector::zeros());
        Self { friction: 1.0, stiffness: 1.0, squeeze: 1.0, moved, tilt }
    }

    pub(super) fn applied_to(&self, contact: &Contact<3>) -> Contact<3> {
        let mut off = contact.clone();
        off.set_friction(off.friction * self.friction);
        off.command[0] *= self.squeeze;
        off.force = contact.force.map(|force| force * self.squeeze);
        off.suction *= self.squeeze;
        off.stiffness = contact.stiffness.scaled(self.stiffness);
        off.point += self.moved;
        off.tilted(&self.tilt)
    }
}
