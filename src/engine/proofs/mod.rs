//! Proofs that a grasp has no equilibrium under a load. Each proof rests on virtual motions of the object: along them the load does more positive
//! work than contact forces can do negative work. No proof has to compute the forces in every combination of contact states.
//!
//! | file | idea |
//! |---|---|
//! | `wrench_cone` | the load lies outside the cone of all contact forces: a separating motion |
//! | `separating_many` | the same separating motion with many coordinates, by band matrices |
//! | `escape` | the safety factor of a proof: rounding may hide from it only an equilibrium whose forces are far larger than load and commands |
//! | `refutation` | case by case on the round cone, as a certificate that can be checked |
//! | `nothing_near` | a radius around a lost equilibrium within which no other equilibrium exists |
//! | `opening_cases` | for each choice of open contacts a linear problem, in which friction may have any direction |

mod escape;
mod nothing_near;
mod opening_cases;
mod refutation;
mod separating_many;
mod tolerances;
mod wrench_cone;

pub(crate) use nothing_near::nothing_near;
pub(crate) use opening_cases::nothing_holds;
pub(crate) use refutation::{ProofStep, check, yields};
pub(crate) use tolerances::{ESCAPE, LEAST_WORK};
pub(crate) use wrench_cone::{
    Generator, NearestForces, nearest_forces, round_generators, separates_from_here_on, separating_motion,
    separating_motion_of_few, straight_generators,
};
