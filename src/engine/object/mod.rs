//! The coupling of the contacts by the twist of the object. The twist has d coordinates: those of the object, of joints and of further bodies. Only
//! the springs of the contacts, and those of joints and tendons (drives), resist it.
//!
//! With every contact in a known state, twist and contact forces follow from one linear `d x d` system. This folder solves it for the other folders
//! of the engine.
//!
//! | file | idea |
//! |---|---|
//! | `problem` | laws, offsets and load: the static problem and the rate problem that the engine solves |
//! | `linear_problem` | the linear problem in known contact states, by orthogonal factors; `trial`: the linear problem in which everything sticks |
//! | `banded_tangent` | the same linear problem for 36 or more coordinates, by the tangent stiffness as a band matrix |
//! | `null_motions` | null vectors of the tangent stiffness, if it is a band matrix |
//! | `solution` | contact forces and twist that solve the linear problem, by iterative refinement |
//! | `free_motions` | motions that no spring resists |
//! | `tangent` | the tangent stiffness, and equilibrium by Newton steps on it |
//! | `newton` | Newton's method for equilibrium, in which each contact's force is explicit in the twist; `relaxing`: a start for it |
//! | `correction` | the error of given contact forces and twist in given contact states |
//! | `precise`, `load` | twist, sum of forces and moments, and load in twice the working precision |
//! | `sizes` | rounding scales: the forces (N) and displacements (m) to which rounding errors are proportional |
//! | `tresca`, `limited` | proposed states of many contacts, with friction limits that do not depend on the normal force |

mod banded_tangent;
mod correction;
mod free_motions;
mod limited;
mod linear_problem;
mod load;
mod newton;
mod null_motions;
mod precise;
mod problem;
mod relaxing;
mod sizes;
mod solution;
mod tangent;
mod tolerances;
mod tresca;
mod trial;

pub(crate) use banded_tangent::uses_band;
pub(crate) use linear_problem::{LinearProblem, least_forces};
pub(crate) use load::Load;
pub(crate) use newton::{Imbalance, newton, newton_on_cones};
pub(crate) use precise::PreciseTwist;
pub(crate) use problem::{Problem, ProblemLists};
pub(crate) use relaxing::SpringDashpotRelaxation;
pub(crate) use sizes::{largest_force, least_spring_force};
pub(crate) use solution::{ForcesAndTwist, SolutionMemory, Unbalanced};
pub(crate) use tangent::{balance, tangent_stiffness};
pub(crate) use tolerances::NO_FORCE;
pub(crate) use tresca::{states_by_tresca, twist_by_tresca};
