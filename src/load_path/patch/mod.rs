//! Load programs followed for thousands of contacts: each event costs about as much as the contacts
//! that it concerns.
//!
//! [`LoadPath`](super::LoadPath) keeps every piece of a path as a whole and asks every contact at
//! every event: n events of n contacts. Here contacts are in known states, and all that couples
//! them is the motion of the object. Everything is affine in that motion and the fraction of the
//! leg: from event to event the path is a straight line in d + 1 dimensions. So
//!
//! * an event changes a term or two of the d x d stiffness, and one d x d system gives the next piece;
//! * a contact need not be looked at before the path has gone as far as it takes to use up a bound of it;
//! * at an event only the contacts on an edge are asked what comes next, and those that slide elsewhere only
//!   when the direction of the path has turned far enough to stop them.
//!
//! | file | idea |
//! |---|---|
//! | `patch_path`, `patch_event` | the follower, and what happens where it stands |
//! | `moving_contact` | one contact on its way, and what its law watches |
//! | `active_set` | what it stands on |
//! | `trial_leg` | the elastic trial state along a leg |
//! | `balance` | contacts in known states, and the motion that balances the load |
//! | `bounds_ahead` | which contacts reach a bound first |
//! | `sliding_on` | which sliding contacts come to rest |
//! | `start` | the equilibrium to start from, and the start of each leg |
//! | `continuation` | what comes next at an event |
//! | `all_contacts` | the states of all contacts at once, and the end of the path |
//! | `following` | from event to event |
//! | `state_on_the_way` | the state as physics, and what stands on an edge |

mod active_set;
mod all_contacts;
mod balance;
mod bounds_ahead;
mod continuation;
mod following;
mod moving_contact;
mod patch_event;
mod patch_path;
mod sliding_on;
mod start;
mod state_on_the_way;
mod trial_leg;

pub use patch_event::PatchEvent;
