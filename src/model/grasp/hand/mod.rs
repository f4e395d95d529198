//! Hands: fingers with joints, which couple the contacts in addition to the object.
//!
//! A finger's joints move its contacts. In the vector of unknowns, the joint coordinates φ come after the object's twist q. The springs of joints and
//! tendons, with their force limits, are called drives and are treated like further contacts. The symbols of these equations are explained below:
//!
//! ```text
//! v_i = a_i - G_iᵀq + J_i φ,        Σ G_i F_i + W = 0
//! τ = Σ_k r_k T_k(r_k·(θ - φ)) + τ_held,      τ = Σ J_iᵀF_i - τ_ext
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | v_i, a_i | stretch of the springs of contact i, and their offset (commanded displacement minus clearance and earlier slip) | m |
//! | G_i, F_i | grasp map and force of contact i | N |
//! | q, W | motion of the object, and the load on it | |
//! | φ, θ | actual and commanded displacement of the joints | rad, m |
//! | J_i | Jacobian: motion of contact i with the joints of its finger | m/rad, 1 |
//! | r_k, T_k | a drive: its moment arms at the joints, and the force law of its spring | |
//! | τ | torque of the drives on a joint, positive along φ | N m, N |
//! | τ_held | constant torque on a joint | N m, N |
//! | τ_ext | external torque on the joints, a load like W | N m, N |
//!
//! The contact law stays the same: a drive is one more spring of a single axis, whose grasp map has entries only for joints.

mod assembly;
mod compliant;
mod draft;
mod drive;
mod face;
mod finger;
mod finger_contacts;
mod hand_builder;
mod held_by_force;
mod joint;
mod linkage;
mod positive;
mod tendon;

pub(super) use draft::{Assembly, Columns};
pub(crate) use drive::{Drive, DriveLaw, DriveOwner};
pub use finger::Finger;
pub use hand_builder::Hand;
pub(crate) use held_by_force::SLIDE_OF;
#[cfg(feature = "serde")]
pub(crate) use joint::JointMotion;
pub use joint::{Joint, JointKind, Limit};
pub use linkage::{HandPart, PartLabel};
pub(crate) use linkage::{Linkage, NamedPart};
pub use tendon::Tendon;
