//! Up to which change per cycle a cycle repeats itself, or is near its limit.
//!
//! All changes are relative: forces to the largest force, gaps to the stretch of the softest spring under it.

/// Relative difference of forces and gaps at both ends of a cycle, up to which the cycle repeats itself: rounding.
///
/// If smaller, rounding keeps cycles that repeat themselves from being recognised. If larger, a slow drift counts as repetition.
pub(super) const SAME_CYCLE: f64 = 1e-11;

/// Change per cycle below which the limit is near: from there on, all cycles are expected to have the same events.
///
/// If smaller, more cycles are followed before the limit is known. If larger, events between here and the limit are missed.
pub(super) const NEAR_THE_LIMIT: f64 = 1e-6;

/// [`NEAR_THE_LIMIT`] if contacts slide along arcs, which are exact up to the error of their steps.
pub(super) const NEAR_THE_LIMIT_ON_ARCS: f64 = 1e-5;

/// Relative change of forces below which a sentence calls them constant, up to the error of steps along arcs.
///
/// If smaller, rounding is reported as a change. If larger, small changes that add up over the cycles are left out.
pub(super) const CONSTANT_FORCES: f64 = 1e-8;
