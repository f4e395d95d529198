//! Tolerances of the proofs that no equilibrium exists: when a contradiction is accepted, and which values are taken as rounding errors.

/// A proof of no equilibrium is accepted if rounding could hide only an equilibrium with enormous forces: at least this multiple of load and
/// commands.
///
/// If smaller, proofs of no equilibrium are accepted that are mere rounding; if larger, clear proofs are refused.
pub(crate) const ESCAPE: f64 = 1e4;

/// Rounding error in the work of a generator (a unit wrench on the boundary of a friction cone) along a unit motion. If the computed negative work of
/// all generators is smaller, it is taken as this number.
///
/// If smaller, rounded work makes contradictions seem clear; if larger, clear contradictions are refused.
pub(crate) const LEAST_WORK: f64 = 1e-15;

/// A residual (the part of the load that admissible contact forces cannot balance) below this fraction of the load does not prove that the load is
/// unbalanced. The load is then on the boundary of the cone of contact forces, up to rounding.
///
/// If smaller, a load on the boundary seems to lie outside the cone of contact forces; if larger, true proofs are refused.
pub(super) const CLEAR_RESIDUAL: f64 = 1e-9;

/// Above this number of coordinates the search for the admissible forces nearest to the load (`wrench_cone`) adds at most 200 generators. The time
/// for each generator grows with the square of the number of coordinates; a search with more generators takes seconds.
pub(super) const MOST_COORDINATES: usize = 600;
