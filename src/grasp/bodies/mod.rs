//! Several bodies: what a scene has that holds more than one object.
//!
//! Each body has coordinates of its own, and a contact couples two of them or one with the ground. With the normal into body `on` and
//! body `against` on the other side
//!
//! ```text
//! v_i = a_i - G_iᵀ q_on + G_iᵀ q_against,        Σ_on G_i F_i - Σ_against G_i F_i + W_b = 0   for every body b
//! ```
//!
//! The contact law is untouched. One body stands in the coordinates of the object, the one that loads act on; all others stand behind the joints, and
//! their motions reach a contact like those of a joint. Links between bodies are contacts that do not open.

mod assembled;
mod body;
mod builder;
mod coordinates;
mod link;
mod link_points;
mod place;

pub use body::{Body, BodyLoad, BodyMotion};
pub use builder::Bodies;
pub use link::Link;
#[cfg(feature = "serde")]
pub(crate) use link::LinkPlace;
pub(crate) use place::{PlacedBodies, refuse_sides};
