//! Load programs followed in steps for any number of contacts on the round cone.
//!
//! [`LoadPath`](super::LoadPath) finds every event of a few hundred contacts. Where thousands slide on the round cone, their directions of slip turn
//! all the time. Here a step takes all contacts along straight stretches, each
//! with its exact slip, and Newton's method finds the motion of the object that balances the load at its end. The remaining error is that stretches
//! are not straight in between. Each step is made once, and again in two halves, to measure it. A second path of steps made once measures how much of
//! the error remains later.
//!
//! | file | idea |
//! |---|---|
//! | `one_step` | the equilibrium at the end of a step |
//! | `stepped_path` | the follower and its state |
//! | `step_length`, `places`, `pace` | steps as long as the error asked for allows |
//! | `coarse`, `unseen` | the error: shown by a second path, or missed by both |
//! | `standing_at` | the equilibrium on the way, and the contacts on an edge |
//! | `ending`, `speeds` | a limit load, or a doubt |

mod coarse;
mod ending;
mod one_step;
mod pace;
mod places;
mod speeds;
mod standing_at;
mod step_length;
mod stepped_path;
mod unseen;

pub use stepped_path::Step;
#[cfg(feature = "serde")]
pub(crate) use stepped_path::check_leg_error;
