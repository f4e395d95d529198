//! Grasps with more than one object, called bodies.
//!
//! Each body has its own coordinates. A contact couples two bodies, or one body with the ground. Its normal points into the body `on`; the body on
//! the other side is `against`. Contact i has the stretch v_i, the offset a_i (commanded displacement minus clearance and earlier slip), the grasp
//! map G_i and the force F_i. Let q_on and q_against be the motions of its two bodies, and W_b the load on body b. The sums run over the contacts
//! that have body b on the named side:
//!
//! ```text
//! v_i = a_i - G_iᵀ q_on + G_iᵀ q_against,        Σ_on G_i F_i - Σ_against G_i F_i + W_b = 0   for every body b
//! ```
//!
//! The contact law stays the same. The body on which loads act has the coordinates of the object. The coordinates of all other bodies come after the
//! coordinates of the joints. Joints and other bodies enter the motion of a contact in the same way. Links between bodies are contacts that cannot
//! open.

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
pub(crate) use link::LinkGeometry;
pub(crate) use place::{PlacedBodies, refuse_sides};
