//! The changes per cycle below which a cycle repeats itself, or is near its limit.
//!
//! All of them are parts of the largest force and of the largest stretch of springs.

/// Relative difference of forces and gaps at both ends of a cycle, up to which the cycle repeats itself: rounding.
///
/// Smaller, cycles that repeat themselves are followed on by their rounding. Larger, a slow drift is called a repetition.
pub(super) const SAME_CYCLE: f64 = 1e-11;

/// Change per cycle that is close to the limit: from there on, all cycles have the same events.
///
/// Smaller, more cycles are followed before the limit is known. Larger, events between here and the limit are passed over.
pub(super) const NEAR_THE_LIMIT: f64 = 1e-6;

/// The same if contacts slide along arcs, which are exact up to the error of their steps.
pub(super) const NEAR_THE_LIMIT_ON_ARCS: f64 = 1e-5;

/// Relative change of forces below which a sentence calls them constant, up to the error of steps along arcs.
///
/// Smaller, rounding is reported as a change. Larger, small changes that add up over the cycles are left out.
pub(super) const CONSTANT_FORCES: f64 = 1e-8;
