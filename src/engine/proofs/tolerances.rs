//! Tolerances of the proofs that no equilibrium exists: when a contradiction counts, and what is rounding.

/// A contradiction counts if an equilibrium that escapes it through rounding exceeds the data by at least this factor.
///
/// Smaller, contradictions count that rounding could have made; larger, clear ones are refused.
pub(crate) const ESCAPE: f64 = 1e4;

/// Rounding error of the work of a generator of length one along a unit motion y. Smaller computed works are replaced by it.
///
/// Smaller, rounded work makes contradictions seem clear; larger, clear ones are refused.
pub(crate) const LEAST_WORK: f64 = 1e-15;

/// A residual below this part of the load is no proof: the load is on the boundary, up to rounding.
///
/// Smaller, a load on the boundary seems to separate; larger, true proofs are refused.
pub(super) const CLEAR_RESIDUAL: f64 = 1e-9;

/// With more coordinates at most 200 generators join the nearest forces. The time for each grows with the square of the number of coordinates; more
/// would take seconds.
pub(super) const MOST_COORDINATES: usize = 600;
