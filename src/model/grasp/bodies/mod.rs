//! Several bodies, for scenes with more than one object.
//!
//! Each body has coordinates of its own. A contact couples two bodies, or one body with the ground. With body `on`, into which its normal points, and
//! body `against` on the other side
//!
//! ```text
//! v_i = a_i - G_iᵀ q_on + G_iᵀ q_against,        Σ_on G_i F_i - Σ_against G_i F_i + W_b = 0   for every body b
//! ```
//!
//! The contact law stays the same. The body that loads act on has the coordinates of the object. All other bodies have coordinates after those of the
//! joints, and move a contact in the same way as a joint does. Links between bodies are contacts that do not open.

mod assembled;
mod body;
mod builder;
mod coordinates;
mod face;
mod link;
mod link_points;
mod place;

pub use body::{Body, BodyLoad, BodyMotion};
pub use builder::Bodies;
pub use link::Link;
#[cfg(feature = "serde")]
pub(crate) use link::LinkPlace;
pub(crate) use place::{PlacedBodies, refuse_sides};
