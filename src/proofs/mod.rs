//! Proofs that no equilibrium exists, that need no search among contact states.
//!
//! | file | idea |
//! |---|---|
//! | `wrench_cone` | the load lies outside all that friction can do: a separating motion |
//! | `separating_many` | the same of many coordinates, in a band |
//! | `escape` | when a contradiction counts |
//! | `refutation` | case by case on the round cone, to be checked by anyone |
//! | `nothing_near` | nothing holds within a radius of where an equilibrium was lost |
//! | `open_choices` | for each choice of open contacts, all that friction could do is a convex question |

mod escape;
mod nothing_near;
mod open_choices;
mod refutation;
mod separating_many;
mod wrench_cone;

pub(crate) use escape::{ESCAPE, LEAST_WORK};
pub(crate) use nothing_near::nothing_near;
pub(crate) use open_choices::nothing_holds;
pub(crate) use refutation::{ProofStep, check, yields};
pub(crate) use wrench_cone::{
    Generator, NearestForces, nearest_forces, round_generators, separates_from_here_on, separating_motion,
    separating_motion_in_a_band, straight_generators,
};
