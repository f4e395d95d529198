//! Grasps in space: 6 degrees of freedom, 3 axes a contact. Lengths in m, forces in N, moments in N m, right-handed.
//!
//! The contact frame is (n, t₁, t₂) with n into the object and `t₂ = n × t₁`.

pub use crate::grasp::{Pressure, SuctionCup};

crate::planar::names!(3);
