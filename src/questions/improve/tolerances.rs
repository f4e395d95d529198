//! Limits of the search for finger places: at which an ascent has reached an optimum, and below which a gain is rounding. A place is the position of
//! a contact on its curve or surface, a squeeze the normal force of its command; a design point is one choice of both.
//!
//! Places and squeezes are divided by the unit of their variable. Gains are divided by the load factor of first slip. If the reserve (the least
//! margin of a contact force to the edge of its cone) is maximised, they are divided by the greatest contact force under the base load.

/// A design point is called an optimum to first order if its residual of first-order optimality is at most this number.
///
/// If smaller, the search ends as stalled at optima where two sticking conditions of one contact are active. If larger, a design point that could
/// still be improved is called an optimum.
pub(super) const OPTIMAL: f64 = 1e-6;

/// The ascent stops once the residual of first-order optimality is at most this number.
///
/// If smaller, the last steps gain rounding only. If larger, places of contacts lose digits.
pub(super) const ARRIVED_AT_TOP: f64 = 1e-10;

/// An ascent ends if the predicted gain is at most this fraction of the load factor of first slip, or for a reserve of the greatest contact force
/// under the base load: so small a gain is rounding.
///
/// If smaller, an ascent would continue until its steps are used up. If larger, it would end at places where the gradient is small.
pub(super) const ROUNDED_GAIN: f64 = 1e-14;

/// A multiplier of the quadratic program (in its scaled numbers) below this is due to rounding, so its sticking condition or limit is not reported.
///
/// If smaller, inactive limits are named. If larger, limits with small multipliers are not named.
pub(super) const ROUNDED_MULTIPLIER: f64 = 1e-7;

/// A contact is refused if its distance from its surface exceeds this number times the sum of the grasp's size and the contact's distance from the
/// origin. It is also refused if the angle between the two normals exceeds this number, rad.
///
/// If smaller, contacts with the six digits of a file are refused. If larger, a contact jumps to the surface.
pub(super) const OFF_THE_SURFACE: f64 = 1e-6;
