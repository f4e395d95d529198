//! Load programs followed for thousands of contacts: each event costs about as much as the contacts involved.
//!
//! [`LoadPath`](super::LoadPath) keeps every piece of a path as a whole and evaluates every contact at every event: n events of n contacts. Here
//! contacts are in known states, and only the motion of the object couples them. Everything is affine in that motion and the fraction of the leg:
//! from event to event the path is a straight line in d + 1 dimensions. So
//!
//! * an event changes a term or two of the d x d stiffness, and one d x d system gives the next piece;
//! * a contact is evaluated again only when the path has gone far enough to use up one of its bounds;
//! * at an event only the contacts on an edge are decided anew, and sliding contacts elsewhere only when the direction of the path has turned far
//!   enough to stop them.
//!
//! | file | idea |
//! |---|---|
//! | `patch_path`, `patch_event` | the follower, and its events |
//! | `moving_contact` | one contact on its way, and the conditions of its law |
//! | `active_set` | the facets and the apex that a contact has reached |
//! | `trial_leg` | the elastic trial state along a leg |
//! | `balance` | contacts in known states, and the motion that balances the load |
//! | `bounds_ahead` | which contacts reach a bound first |
//! | `sliding_on` | which sliding contacts come to rest |
//! | `start` | the equilibrium to start from, and the start of each leg |
//! | `continuation` | the continuation after an event |
//! | `all_contacts` | the states of all contacts at once, and the end of the path |
//! | `following` | from event to event |
//! | `state_on_the_way` | the equilibrium on the way, and the contacts on an edge |

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
