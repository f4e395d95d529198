//! Upper bound of a contact's power against a motion of the body, for any previous slip.
//!
//! Let F be the contact force, and u the velocity of the body's point in the contact frame. Let m be the largest power of a unit friction force
//! against u_t, k_n the normal stiffness, v_n the normal stretch, and (x)₊ = max(x, 0). Then
//!
//! ```text
//! -F·u  <=  (μ m - u_n) F_n  <=  (μ m - u_n)₊ k_n (v_n)₊
//! ```
//!
//! since the normal force of a closed contact is `k_n v_n`, whatever its history. A contact that can neither open nor slide has the force K v, with
//! its stiffness matrix K and the stretch v of its springs.

use crate::numerics::largest;

use nalgebra::SVector;

use super::law::LocalLaw;
use super::tangential::tangential;

/// A bound on `-F·u` in terms of the contact's stretch v. Its unit is W if u is a velocity, J if u is a virtual displacement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Resistance {
    /// The bound is this factor times the positive part of the normal stretch. The factor is in N/s if u is a velocity, in N if u is a virtual
    /// displacement.
    ByFriction(f64),
    /// The power is exactly the dot product of this vector and the stretch. The vector is in N/s if u is a velocity, in N if u is a virtual
    /// displacement.
    BySprings(SVector<f64, 3>),
    /// No bound: infinite friction can resist the motion without limit.
    Unlimited,
}

impl LocalLaw<'_> {
    /// The upper bound on the contact's power `-F·u` against a velocity u of the body in the contact frame, with the contact force F.
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
