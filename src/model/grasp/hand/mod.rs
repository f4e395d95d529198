//! Fingers with joints, which couple contacts in addition to the object.
//!
//! A finger's joints move its contacts. Joint coordinates φ are added to the twist of the object. Springs, gears, tendons and motors, which give the
//! joints stiffness, are added to the contacts:
//!
//! ```text
//! v_i = a_i - G_iᵀq + J_i φ,        Σ G_i F_i + W = 0
//! τ = Σ_k r_k T_k(r_k·(θ - φ)) + τ_held,      τ = Σ J_iᵀF_i - τ_ext
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | φ, θ | displacement of the joints, and the commanded one | rad, m |
//! | J_i | motion of contact i with the joints of its finger | m/rad, 1 |
//! | r_k, T_k | a drive: arms over the joints, and the law of its spring | |
//! | τ | torque of the drives on a joint, positive along φ | N m, N |
//! | τ_ext | external torque on the joints, appended to the wrench of a load | N m, N |
//!
//! The contact law stays the same: a drive is one more spring, of one axis, whose map has entries at the joints alone.

mod assembly;
mod carried;
mod compliant;
mod draft;
mod drive;
mod face;
mod finger;
mod hand_builder;
mod held_by_force;
mod joint;
mod linkage;
mod positive;
mod tendon;

pub(super) use draft::{Assembly, Columns};
pub(crate) use drive::{Drive, Owner, Role};
pub use finger::Finger;
pub use hand_builder::Hand;
#[cfg(feature = "serde")]
pub(crate) use held_by_force::SLIDE_OF;
pub(crate) use joint::JointMotion;
pub use joint::{Joint, JointKind, Limit};
pub use linkage::{HandPart, PartLabel};
pub(crate) use linkage::{Linkage, Named};
pub use tendon::Tendon;
