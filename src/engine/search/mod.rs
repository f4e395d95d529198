//! The search for contact states: a sequence of methods (the ladder and its rungs), and the check that every proposed solution must pass. A search
//! begins with the elastic trial, the solution in which every contact sticks.
//!
//! | file | idea |
//! |---|---|
//! | `answer` | the result of a search, and the work that it took |
//! | `settings` | limits and tolerances that the caller may set |
//! | `record` | which rung ends each search, for the report `rungs` |
//! | `elastic_trial` | input and result of a rung |
//! | `ladder` | the methods that find an equilibrium or a proof, in the order in which they are tried |
//! | `leaving` | with many contacts: Lemke's method on the contacts that leave the elastic trial |
//! | `touching` | the equilibrium in which all closed contacts stick |
//! | `proposals` | contact states proposed by Lemke's method |
//! | `candidate` | proposed contact states, solved and checked |
//! | `round_pieces`, `polish` | Newton's method on the round cone, from the elastic trial or from a solution with polygonal cones |
//! | `enumerate` | every combination of contact states |
//! | `solution_interval` | a solution that is one end of an interval of solutions |
//! | `without_force` | contacts that touch without force are reported as open |
//! | `tree`, `relaxed` | on the round cone: branch and bound over contact states |

mod answer;
mod candidate;
mod elastic_trial;
mod enumerate;
mod ladder;
mod least_motion;
mod leaving;
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

pub(crate) use answer::{SearchCounts, SearchOutcome, SearchSolution, StoredSolution};
pub(crate) use candidate::{CandidateOutcome, for_each_condition, try_states};
pub(crate) use enumerate::{combinations, for_each_combination, search, search_among};
pub(crate) use ladder::settle;
pub(crate) use polish::{polish, solution_near};
pub(crate) use proposals::dense_is_affordable;
pub(crate) use solution_interval::on_the_solution_interval;
pub(crate) use tree::refute;
pub(crate) use without_force::{reported_at_rest, settle_at_rest};
