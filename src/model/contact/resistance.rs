//! The most power of a contact against a motion of the body, whatever it has slipped before.
//!
//! With the velocity u of the body's point in the contact frame, and m the most power of friction of size one against u_t,
//!
//! ```text
//! -F·u  <=  (μ m - u_n) F_n  <=  (μ m - u_n)₊ k_n (v_n)₊
//! ```
//!
//! since a closed contact has the normal force `k_n v_n` of its normal stretch v_n, whatever its history. A contact that neither opens nor slides has
//! the force K v.

use crate::numerics::largest;

use nalgebra::SVector;

use super::law::LocalLaw;
use super::tangential::tangential;

/// A bound of `-F·u` by the stretch v of the contact, W for a velocity, J for a virtual motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Resistance {
    /// This multiple, N, of the normal stretch where the stretch is positive.
    ByFriction(f64),
    /// The product of this row and the stretch, exactly, N.
    BySprings(SVector<f64, 3>),
    /// None: infinite friction holds against the motion.
    Unlimited,
}

impl LocalLaw<'_> {
    /// The bound of the contact's power against a velocity u of the body, in the contact frame.
    pub(crate) fn resistance(&self, u: &SVector<f64, 3>) -> Resistance {
        if self.is_bonded() || self.may_pull() {
            return Resistance::BySprings(-self.springs.force(u));
        }
        let along = tangential(u);
        let friction = if self.is_frictionless() || along.norm() == 0.0 {
            0.0
        } else if self.never_slides() {
            return Resistance::Unlimited;
        } else if self.on_round_cone {
            self.friction.limit(along.norm())
        } else {
            self.friction.limit(largest(&self.polygon.corners, &|corner| -corner.dot(&along)))
        };
        Resistance::ByFriction(self.springs.force_along(0, (friction - u[0]).max(0.0)))
    }
}
