//! The numbers at which an ascent has arrived, and below which a gain is rounding.
//!
//! Lengths are relative to the variable's unit, gains to the scale of values.

/// A residual of the gradients up to this value is an optimum to first order.
///
/// If smaller, optima at kinks end as stalled. If larger, a point that could still be improved is called an optimum.
pub(super) const OPTIMAL: f64 = 1e-6;

/// At this residual of the gradients the ascent stops.
///
/// If smaller, steps gain rounding only. If larger, places of contacts lose digits.
pub(super) const ARRIVED_AT_TOP: f64 = 1e-10;

/// A predicted gain below this fraction of the scale of values is rounding.
///
/// If smaller, an ascent continues until its steps are used up. If larger, it ends on flat slopes.
pub(super) const ROUNDED_GAIN: f64 = 1e-14;

/// Multipliers below this, in the units of the step program, are rounding and not reported.
///
/// If smaller, limits that do not bind are named. If larger, limits that bind weakly are not.
pub(super) const ROUNDED_MULTIPLIER: f64 = 1e-7;

/// Largest distance of a point from its surface relative to its coordinates, and largest angle of its normal to that of the surface, rad.
///
/// Beyond it the contact is refused. If smaller, contacts with the six digits of a file are refused. If larger, a contact jumps to the surface.
pub(super) const OFF_THE_SURFACE: f64 = 1e-6;
