//! The validated data of a grasp problem: contacts with their law of friction and stiffness, hands, bodies, wrenches and twists.

pub(crate) mod contact;
pub mod grasp;
#[cfg(feature = "urdf")]
pub mod robot;
#[cfg(feature = "mesh")]
pub mod touch;
