//! The parts of a grasp problem: contacts, soft fingertips, hands, several bodies, wrenches and twists.
//!
//! `C` is the number of axes of a contact, 2 in the plane and 3 in space. Use the short names in [`crate::planar`] and [`crate::spatial`]. The
//! engine itself uses vectors of three components for both.
//!
//! # Vectors of other libraries
//!
//! A point or vector argument accepts every type that converts into an array of f64:
//!
//! * arrays and tuples,
//! * vectors, points and translations of nalgebra,
//! * the `DVec2` and `DVec3` of any version of glam, and so of parry, rapier and bevy,
//! * the vectors and points of mint.
//!
//! Answers contain nalgebra's vectors ([`crate::nalgebra`]) or arrays, which convert back: `DVec3::from_array(contact.force_world.into())`.
//! Vectors of single precision must be converted by the caller (`Vec3::as_dvec3`, `DVec3::as_vec3`), since this crate computes in double
//! precision only.
//!
//! Poses are nalgebra's. [`Contact::transformed`], [`Wrench::transformed`] and [`Twist::transformed`] convert from the frame of a link or of the
//! object to the frame of the grasp. `about` changes the reference point. [`Twist::exp`](crate::spatial::Twist::exp) is the rigid motion that belongs
//! to an object's twist. Poses of glam, parry and rapier convert with `glamx` and its feature `nalgebra`: `DPose3::from(twist.exp())`,
//! `Isometry3::from(pose)`. The package `collision-contacts` in the repository takes contacts from parry and demonstrates all of this.

mod axis;
mod bodies;
mod cached_value;
mod commands;
mod contact;
mod contact_springs;
mod coordinates;
mod driven;
mod engine;
mod face;
mod fingertip;
mod frames;
mod hand;
mod in_words;
mod inside;
mod motion;
mod payload;
mod points_of_action;
mod pressure;
mod rectangular_pad;
mod rigid_motion;
mod rotation;
mod scaled;
mod site;
mod stiffness;
mod suction_cup;
mod support;
mod tolerances;
mod vacuum;
mod well_posed;
mod whole_contact;
mod wrench;

pub(crate) use crate::numerics::Space;
#[cfg(feature = "serde")]
pub(crate) use bodies::LinkGeometry;
pub use bodies::{Bodies, Body, BodyLoad, BodyMotion, Link};
pub(crate) use cached_value::CachedValue;
#[cfg(feature = "serde")]
pub(crate) use commands::CommandAxes;
pub use contact::{Contact, Hold};
pub(crate) use coordinates::Coordinates;
pub(crate) use engine::Engine;
pub(crate) use face::{
    Face, all_inside, face_of_enum, face_of_struct, frame_outside, inside, outside, same_on_both_sides,
};
pub use fingertip::SoftFingertip;
#[cfg(feature = "serde")]
pub(crate) use hand::JointMotion;
pub(crate) use hand::{Drive, DriveLaw, DriveOwner, Linkage, NamedPart, SLIDE_OF};
pub use hand::{Finger, Hand, HandPart, Joint, JointKind, Limit, PartLabel, Tendon};
pub use motion::Motion;
pub use payload::{ArmMotion, Payload};
pub(crate) use points_of_action::PointsOfAction;
pub use pressure::Pressure;
pub(crate) use rotation::{assert_plane_or_space, of_axes};
pub(crate) use scaled::PressOfPart;
pub(crate) use site::{Site, size_of};
pub(crate) use stiffness::Stiffness;
pub use suction_cup::SuctionCup;
pub(crate) use vacuum::{ATMOSPHERE, vacuum_is_gone};
pub use whole_contact::WholeContact;
pub(crate) use whole_contact::{ContactPoints, WholeContacts};
pub use wrench::{Twist, Wrench};

pub use crate::words::LinkKind;
