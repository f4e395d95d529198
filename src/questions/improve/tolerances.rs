//! At which numbers an ascent has arrived, and below which a gain is rounding.
//!
//! Lengths and forces are relative to the unit of their variable, gains to the scale of the design (the first slip, or the greatest force at rest).

/// A point is called an optimum to first order if the residual of its gradients is at most this.
///
/// If smaller, the search ends as stalled at optima where two conditions meet. If larger, a point that could still be improved is called an optimum.
pub(super) const OPTIMAL: f64 = 1e-6;

/// The ascent stops once the residual of the gradients is at most this.
///
/// If smaller, the last steps gain rounding only. If larger, places of contacts lose digits.
pub(super) const ARRIVED_AT_TOP: f64 = 1e-10;

/// A predicted gain below this fraction of the scale (the first slip, or for a reserve the greatest force at rest) is rounding.
///
/// If smaller, an ascent continues until its steps are used up. If larger, it ends on flat slopes.
pub(super) const ROUNDED_GAIN: f64 = 1e-14;

/// A multiplier of the step program (in its scaled numbers) below this is rounding, so its event or bound is not reported.
///
/// If smaller, limits that do not bind are named. If larger, limits that bind weakly are not.
pub(super) const ROUNDED_MULTIPLIER: f64 = 1e-7;

/// Largest distance of a point from its surface relative to its coordinates, and largest angle of its normal to that of the surface, rad.
///
/// Beyond it the contact is refused. If smaller, contacts with the six digits of a file are refused. If larger, a contact jumps to the surface.
pub(super) const OFF_THE_SURFACE: f64 = 1e-6;
