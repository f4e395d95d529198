//! Limits of the change of forces and gaps in a cycle of a repeated load. They tell whether a cycle repeats itself, and whether it is near the limit
//! of the cycles.
//!
//! All changes are relative: forces to the largest contact force of the cycle, gaps to the stretch of the softest spring under this force.

/// A cycle repeats itself if forces and gaps at its end differ from those at its beginning by at most this number, which allows for rounding.
///
/// If it were smaller, rounding would keep cycles that repeat themselves from being recognised. If it were larger, a slow drift would be taken as
/// repetition.
pub(super) const SAME_CYCLE: f64 = 1e-11;

/// If forces and gaps change per cycle by at most this relative number, the cycles count as near their limit. All further cycles are then expected to
/// have the same events (changes of contact states: contacts slip, stick, open or close).
///
/// If it were smaller, more cycles would be followed before the limit is known. If it were larger, events before the limit is reached would be
/// missed.
pub(super) const NEAR_THE_LIMIT: f64 = 1e-6;

/// Takes the place of [`NEAR_THE_LIMIT`] if directions of slip turn along load paths. Such paths are integrated in steps, which have errors.
pub(super) const NEAR_THE_LIMIT_ON_ARCS: f64 = 1e-5;

/// In a cycle with jumps (motions under constant load) a contact is reported as sliding only if its slip exceeds this fraction of the largest contact
/// displacement in one jump.
///
/// A jump starts a little beyond the loss of equilibrium, and its steps end a little before the object rests. Both inaccuracies together add slips of
/// some 1e-6 of the motion in the jump. If the fraction were smaller, these slips would be reported as sliding to and fro. If it were larger, true
/// small slips in a cycle with large jumps would not be reported. A walk (the same motion in every cycle) is recognised by slips of any length.
pub(super) const SLIP_OF_JUMPS: f64 = 1e-5;

/// If forces and gaps change by at most this relative number per cycle, the answer calls the forces constant. The number exceeds the error that is
/// allowed for one integration step of a load path, by default 1e-9.
///
/// If it were smaller, rounding would be reported as a change. If it were larger, small changes that add up over the cycles would not be reported.
pub(super) const CONSTANT_FORCES: f64 = 1e-8;
