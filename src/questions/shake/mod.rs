//! Repeated loads: does the grasp come to rest, or does the object walk out of it cycle by cycle?
//!
//! A load that is held once may not be held when it is put on a thousand times. In each cycle contacts may slide a little further. From the
//! equilibrium under the base load, [`Grasp::shake`](crate::ask::Grasp::shake) follows a cycle of legs (sections of a load program) again and again.
//! Each leg is computed like the legs of [`Grasp::follow`](crate::ask::Grasp::follow). Later cycles depend only on the cycle state e at their
//! beginning,
//!
//! ```text
//! e = (forces of closed contacts, gaps of open contacts, contacts with kinetic friction)
//! ```
//!
//! not on the position of the object, nor on the slip of a contact so far. If the cycle state e at the end of a cycle equals that at its beginning,
//! all later cycles are like it. This cycle gives the verdict ([`Repeats`]). If nothing slides in it, and the object does not jump from one contact
//! to another, the grasp rests. Otherwise the object moves to and fro, or walks by the same motion in each cycle. Contacts may open and close in a
//! cycle although the grasp rests. The verdict names them, and says if they are suction cups, into which air flows.
//!
//! If e converges, a cycle that begins at its limit gives the verdict. In the plane, and on a polygonal cone, e changes from cycle to cycle by an
//! affine map. This holds as long as the events (changes of contact states: a contact slips, sticks, opens or closes) stay the same. The cycle states
//! of a few cycles determine the fixed point of this map (minimal polynomial extrapolation). A cycle that begins at the fixed point confirms it. On
//! the round cone load paths have step errors, and cycle states count as equal up to these errors.
//!
//! If [friction falls](crate::grasp::Contact::kinetic) as contacts begin to slide, the behaviour may repeat itself only after several cycles. Such
//! periods are found, too.
//!
//! Forces, slips and motions are computed to first order in small motions. Therefore a walk has a constant motion per cycle, and no end.

mod cycle;
mod face;
mod followed;
mod period_search;
mod recurrence;
mod shakedown;
mod tolerances;
mod verdict;
mod words;

pub use shakedown::{BindingContact, Shakedown};
pub use verdict::{Repeats, Shaken};
