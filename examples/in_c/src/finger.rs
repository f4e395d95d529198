//! Vectors and fingers, as C passes them.

use grasp_lcp::spatial::Contact;
use safer_ffi::prelude::*;

/// A vector along the coordinate axes.
#[derive_ReprC(rename = "grasp_lcp_vector")]
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct Vector {
    /// Along x.
    pub x: f64,
    /// Along y.
    pub y: f64,
    /// Along z.
    pub z: f64,
}

impl Vector {
    pub(crate) fn components(self) -> [f64; 3] {
        [self.x, self.y, self.z]
    }
}

/// A finger that touches the object at a point.
#[derive_ReprC(rename = "grasp_lcp_finger")]
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct Finger {
    /// Contact point, m.
    pub point: Vector,
    /// Normal into the object, of any length.
    pub normal: Vector,
    /// Stiffness of finger and object in series along the normal, N/m.
    pub normal_stiffness: f64,
    /// Stiffness of finger and object in series along the surface, N/m.
    pub tangential_stiffness: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Commanded normal force, N.
    pub press: f64,
}

impl Finger {
    pub(crate) fn contact(&self) -> Contact {
        Contact::new(self.point.components(), self.normal.components())
            .series_stiffness(self.normal_stiffness, self.tangential_stiffness)
            .friction(self.friction)
            .pressed_with(self.press)
    }
}
