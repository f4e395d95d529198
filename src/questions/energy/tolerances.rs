//! The numbers below which the quadratic programs take a value for zero or for rounding.

/// A direction depends on the binding rows if less than this part of it is left after projecting them out.
///
/// Smaller, rounding counts as a free direction, and more forces are called undetermined. Larger, free directions are missed.
pub(super) const DEPENDENT_DIRECTION: f64 = 1e-10;

/// Relative changes of the displacements below this are rounding, and iterations of second order have settled.
///
/// Smaller, iterations go on by rounding. Larger, digits of the displacements are lost.
pub(super) const SETTLED_DISPLACEMENT: f64 = 1e-14;

/// Accepted relative change where rounding keeps the iterations from reaching [`SETTLED_DISPLACEMENT`].
///
/// Smaller, soft grasps never settle. Larger, iterations that diverge slowly count as settled.
pub(super) const STUCK_DISPLACEMENT: f64 = 1e-11;
