//! A contact whose data (friction, stiffness, squeeze, point, normal) differ from the given ones by given errors.

use crate::numerics::Each;
use nalgebra::SVector;

use crate::grasp::Contact;
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// Errors of a contact's data. For friction, stiffness and squeeze they are logarithms of factors; for the point and the normal, numbers to be added.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct ContactErrors {
    pub(super) friction: f64,
    pub(super) stiffness: f64,
    pub(super) squeeze: f64,
    /// Displacement of the contact point along the coordinate axes, m.
    pub(super) moved: SVector<f64, 3>,
    /// Angles by which the normal tilts towards each tangent of the contact frame, rad.
    pub(super) tilt: SVector<f64, 3>,
}

impl ContactErrors {
    pub(super) fn add(&mut self, times: f64, other: &Self) {
        self.friction += other.friction * times;
        self.stiffness += other.stiffness * times;
        self.squeeze += other.squeeze * times;
        self.moved += other.moved * times;
        self.tilt += other.tilt * times;
    }

    pub(super) fn applied_to(&self, contact: &Contact<3>) -> Contact<3> {
        let [friction, stiffness, squeeze] = [self.friction, self.stiffness, self.squeeze].each(factor);
        let mut off = contact.clone();
        off.set_friction(off.friction * friction);
        off.squeeze(squeeze);
        off.stiffness = contact.stiffness.scaled(stiffness);
        off.point += self.moved;
        off.tilted(&self.tilt)
    }
}

/// The factor on a datum (a stiffness, for example) whose logarithm is in error by `log`.
pub(super) fn factor(log: f64) -> f64 {
    // The factor is kept away from zero and infinity: a stiffness of zero, for example, would mean that the contact has no spring. If a datum with
    // such a factor is out of range, a later check returns an error.
    let least = 1e-200_f64;
    log.exp().clamp(least, least.recip())
}
