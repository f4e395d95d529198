//! The motion of the object, which couples the contacts. It has d coordinates, and no stiffness except that of the contacts.
//!
//! With every contact in a known state, twist and forces follow from one `d x d` system. The other modules of the engine solve it here.
//!
//! | file | idea |
//! |---|---|
//! | `problem` | laws, offsets and load: the problem that the engine solves, at rest and in rates |
//! | `piece` | the linear problem in known states, by orthogonal factors |
//! | `band_piece` | the same problem of very many coordinates, by the tangent stiffness in a narrow band |
//! | `null_motions` | null vectors of the tangent stiffness in a band |
//! | `solution` | forces and twist of the linear problem, by iterative refinement |
//! | `free_motions` | motions that no spring resists |
//! | `tangent` | the tangent stiffness, and equilibrium by Newton steps on it |
//! | `newton` | Newton's method for equilibrium, in which each contact's force is explicit in the twist |
//! | `correction` | the error of given forces and twist in given contact states |
//! | `precise`, `load` | twist, equilibrium and load in twice the working precision |
//! | `sizes` | magnitudes that scale rounding errors |

mod band_piece;
mod correction;
mod free_motions;
mod limited;
mod load;
mod newton;
mod null_motions;
mod piece;
mod precise;
mod problem;
mod relaxing;
mod sizes;
mod solution;
mod tangent;
mod tolerances;
mod tresca;
mod trial;

pub(crate) use band_piece::uses_band;
pub(crate) use load::Load;
pub(crate) use newton::{Imbalance, newton, newton_on_cones};
pub(crate) use piece::{Piece, least_forces};
pub(crate) use precise::PreciseTwist;
pub(crate) use problem::{Lists, Problem};
pub(crate) use relaxing::ViscousRelaxation;
pub(crate) use sizes::{largest_force, least_spring_force};
pub(crate) use solution::{PieceState, SolutionMemory, Unbalanced};
pub(crate) use tangent::{balance, tangent_stiffness};
pub(crate) use tolerances::NO_FORCE;
pub(crate) use tresca::{states_by_tresca, twist_by_tresca};
