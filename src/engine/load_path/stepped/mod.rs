//! Load programs followed in numerical steps, for any number of contacts on the round friction cone.
//!
//! [`LoadPath`](super::LoadPath) finds every event of a few hundred contacts. If thousands slide on the round cone, their directions of slip turn all
//! the time. Here a step assumes that the stretch (spring deformation) of every contact changes along a straight line, for which its slip is exact.
//! Newton's method finds the motion of the object that balances the load at the end of the step. The remaining error arises because stretches do not
//! change along straight lines within the step. To measure this error, each step is made both at once and in two halves. A second path, on which no
//! step is divided into halves, shows how much of this error remains after later steps.
//!
//! | file | idea |
//! |---|---|
//! | `one_step` | the equilibrium at the end of a step |
//! | `stepped_path` | the follower of the load program, i.e. the part of a path that advances, and what it stores |
//! | `step_length`, `step_doubling`, `pace` | step control: steps as long as the allowed error permits |
//! | `coarse_path`, `shared_error` | the error of the path: measured by a second path, plus an estimate of errors that both paths make alike |
//! | `standing_at` | the equilibrium at the present place, and the contacts on the boundary of their cones |
//! | `ending`, `speeds` | the end of a path: a loss of equilibrium, or undecided |

mod coarse_path;
mod ending;
mod one_step;
mod pace;
mod shared_error;
mod speeds;
mod standing_at;
mod step_doubling;
mod step_length;
mod stepped_path;

pub use stepped_path::Step;
#[cfg(feature = "serde")]
pub(crate) use stepped_path::check_leg_error;
