//! The motion of the object, which couples the contacts: d coordinates without a stiffness of their
//! own.
//!
//! With every contact in a known state, twist and forces follow from one `d x d` system. All rooms
//! above obtain them here.
//!
//! | file | idea |
//! |---|---|
//! | `problem` | laws, offsets and load: the local problem, at rest and in rates |
//! | `piece` | the linear problem in known states, by orthogonal factors |
//! | `band_piece` | the same problem of very many coordinates, by the tangent stiffness in a narrow band |
//! | `null_motions` | the motions in which the band is singular |
//! | `solution` | its forces and twist, to the last digits |
//! | `free_motions` | motions that no spring resists |
//! | `energy_coordinates` | contacts where stiffness ratios do not show |
//! | `sums` | balance there, as sums that change by a few terms |
//! | `lazy_pricing` | the contacts that can reach the end of their state within a step |
//! | `tangent` | the tangent stiffness, and balance by steps on it |
//! | `newton` | Newton's method for balance, with contacts that respond one by one |
//! | `correction` | the distance of forces and a twist from the solution of their piece |
//! | `precise`, `load` | twist, balance and load in twice the working precision |
//! | `sizes` | sizes that scale rounding |

mod band_piece;
mod correction;
mod energy_coordinates;
mod free_motions;
mod lazy_pricing;
mod limited;
mod load;
mod newton;
mod null_motions;
mod piece;
mod precise;
mod problem;
mod sizes;
mod solution;
mod sums;
mod tangent;
mod tolerances;
mod tresca;
mod trial;

pub(crate) use band_piece::uses_band;
pub(crate) use energy_coordinates::{EnergyContact, EnergyCoordinates, Facet, Slipping, normal};
pub(crate) use lazy_pricing::{LazyPricing, Point, slack};
pub(crate) use load::Load;
pub(crate) use newton::{Imbalance, newton, newton_on_cones, relaxed_on_cones};
pub(crate) use piece::{Piece, least_combination, least_forces};
pub(crate) use precise::PreciseTwist;
pub(crate) use problem::{Lists, Problem};
pub(crate) use sizes::{largest_force, least_spring_force};
pub(crate) use solution::{PieceState, SolutionMemory, Unbalanced};
pub(crate) use sums::{Sums, are_stale};
pub(crate) use tangent::{balance, tangent_stiffness};
pub(crate) use tolerances::{NO_FORCE, PRICING_MARGIN};
pub(crate) use tresca::{states_by_tresca, twist_by_tresca};
