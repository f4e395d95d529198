//! The search for contact states: the ladder, its rungs, and the check that every proposal must pass.
//!
//! | file | idea |
//! |---|---|
//! | `answer` | the end of a search, and its effort |
//! | `settings` | limits and tolerances that the caller may set |
//! | `record` | what every rung makes of each search, for a report |
//! | `elastic_trial` | input and result of a rung |
//! | `ladder` | each way to find an equilibrium or a proof, in the order in which they are tried |
//! | `leaving` | Lemke's method on the few of many contacts that leave the trial |
//! | `touching` | all contacts that touch stick |
//! | `proposals` | Lemke's method proposes states |
//! | `candidate` | a proposal solved and checked |
//! | `round_pieces`, `polish` | to the round cone, from the trial or from a polygon's answer |
//! | `enumerate` | every combination of states |
//! | `solution_interval` | a twist that is one end of an interval |
//! | `without_force` | what touches without force is open |
//! | `tree`, `relaxed` | on the round cone: branch and bound over what contacts do |

mod answer;
mod candidate;
mod elastic_trial;
mod enumerate;
mod ladder;
mod least_motion;
mod leaving;
#[cfg(test)]
mod pivots;
mod polish;
mod proposals;
#[cfg(feature = "std")]
pub mod record;
mod relaxed;
mod round_pieces;
mod settings;
mod small_motions;
mod solution_interval;
mod tolerances;
mod touching;
mod tree;
mod without_force;
#[cfg(test)]
mod yields_or_moves;

pub use answer::{Doubt, FoundBy};
pub use settings::Settings;
pub use small_motions::SmallMotions;

pub(crate) use answer::{Effort, Found, Kept, Settled};
pub(crate) use candidate::{Judged, for_each_condition, try_states};
pub(crate) use enumerate::{combinations, for_each_combination, search, search_among};
pub(crate) use ladder::settle;
pub(crate) use polish::{polish, solution_near};
pub(crate) use proposals::dense_is_affordable;
pub(crate) use solution_interval::on_the_solution_interval;
pub(crate) use tree::refute;
pub(crate) use without_force::{settle_at_rest, told_at_rest};
