//! The numbers that proofs of no equilibrium share: when a contradiction counts, and what is rounding.

/// Least factor of an escape over the data with which a contradiction counts.
///
/// Smaller, contradictions count that rounding could have made; larger, clear ones are refused.
pub(crate) const ESCAPE: f64 = 1e4;

/// Assumed least work of a generator of length one along a unit y: rounding.
///
/// Smaller, rounded work makes contradictions seem clear; larger, clear ones are refused.
pub(crate) const LEAST_WORK: f64 = 1e-15;

/// A residual below this part of the load is no proof: the load is on the boundary, up to rounding.
///
/// Smaller, a load on the boundary seems to separate; larger, true proofs are refused.
pub(super) const CLEAR_RESIDUAL: f64 = 1e-9;

/// With more coordinates at most 200 generators join. Each takes a time that grows with the square of the number of coordinates, and all would take
/// seconds.
pub(super) const MOST_COORDINATES: usize = 600;
