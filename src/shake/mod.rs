//! Loads that repeat: does the grasp come to rest, or does the object walk out?
//!
//! A load that is held when it is put on once may not be held when it is put on a thousand times: each cycle may slide a little further. From rest
//! [`Grasp::shake`](crate::ask::Grasp::shake) follows a cycle of legs again and again, as [`Grasp::follow`](crate::ask::Grasp::follow) would, and looks
//! at what the cycles to come depend on:
//!
//! ```text
//! e = (forces F_i of what is closed, gaps of what is open)
//! ```
//!
//! Neither where the object has gone nor how far a contact has slid matters beside them. So where a cycle ends with the e that it began with, all cycles to
//! come are like it. That is the verdict for all time ([`Repeats`]). Nothing slides in such a cycle, and the grasp rests. Or contacts slide to and fro. Or the
//! object has moved, and walks on by as much each time.
//!
//! Where e changes by less and less, the verdict is that of its limit. While the same events happen in each cycle of the plane, or on a polygon, e goes from
//! cycle to cycle by an affine map. A few cycles tell its fixed point (reduced rank extrapolation: the affine combination of them that changes least),
//! and a cycle that begins there shows that it is one. On the round cone the same is done to the error of the steps.
//!
//! Where [friction falls](crate::grasp::Contact::kinetic) as contacts begin to slide a grasp may repeat itself after several cycles only, which is found, too.
//!
//! What is told of forces, slips and motions is to first order, for small motions, as everywhere: a walk says how fast it is, not where it ends.

mod cycle;
mod followed;
mod recurrence;
mod round;
mod shakedown;
mod verdict;
mod words;

pub use shakedown::{BindingContact, Shakedown};
pub use verdict::{Repeats, Shaken};
