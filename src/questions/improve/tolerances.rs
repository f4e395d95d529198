//! Limits at which an ascent has reached an optimum, and below which a gain is rounding.
//!
//! Lengths and forces are relative to the unit of their variable. Gains are relative to the load factor of first slip, or for a reserve to the
//! greatest force at rest.

/// A point is called an optimum to first order if the residual of first-order optimality is at most this.
///
/// If smaller, the search ends as stalled at optima where two sticking conditions of one contact are active. If larger, a point that could still be
/// improved is called an optimum.
pub(super) const OPTIMAL: f64 = 1e-6;

/// The ascent stops once the residual of first-order optimality is at most this.
///
/// If smaller, the last steps gain rounding only. If larger, places of contacts lose digits.
pub(super) const ARRIVED_AT_TOP: f64 = 1e-10;

/// A predicted gain below this fraction of the load factor of first slip, or for a reserve of the greatest force at rest, is due to rounding.
///
/// If smaller, an ascent continues until its steps are used up. If larger, it ends where the gradient is small.
pub(super) const ROUNDED_GAIN: f64 = 1e-14;

/// A multiplier of the quadratic program (in its scaled numbers) below this is due to rounding, so its sticking condition or limit is not reported.
///
/// If smaller, inactive limits are named. If larger, limits with small multipliers are not.
pub(super) const ROUNDED_MULTIPLIER: f64 = 1e-7;

/// Largest distance of a point from its surface relative to its coordinates, and largest angle of its normal to that of the surface, rad.
///
/// Beyond it the contact is refused. If smaller, contacts with the six digits of a file are refused. If larger, a contact jumps to the surface.
pub(super) const OFF_THE_SURFACE: f64 = 1e-6;
